// SPDX-License-Identifier: MIT
// Access to a live run: for the pages that its own address opened.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trophic::live {

/// 128 random bits as hexadecimal digits.
[[nodiscard]] std::string new_token();

/// A request, as far as it decides about access.
struct Request {
  std::string_view method;
  std::string_view target;  ///< path and query
  std::string_view host;    ///< of the header Host
  std::string_view origin;  ///< of the header Origin; empty if it has none
  bool is_upgrade = false;  ///< to a web socket
};

/// The answer to a request that is not let in.
struct Refusal {
  unsigned status = 403;
  std::string sentence;
};

/// `nullopt` for a request for the page, GET /?token=TOKEN, or for its web socket, /live?token=TOKEN. The host must be this
/// machine by name or address, at any port (ssh forwards another one), so that no foreign name leads here; the origin of a web
/// socket must be that host.
[[nodiscard]] std::optional<Refusal> refusal_of(const Request& request, std::string_view token);

}  // namespace trophic::live
