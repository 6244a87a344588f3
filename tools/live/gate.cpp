// SPDX-License-Identifier: MIT
// Definitions of gate.hpp.
#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <tools/live/gate.hpp>

namespace trophic::live {

namespace {

/// Takes as long for any text of that length.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned differs = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differs |= static_cast<unsigned>(a[i] ^ b[i]);
  return differs == 0;
}

bool is_this_machine(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const bool has_port = colon != std::string_view::npos && host.find(']', colon) == std::string_view::npos;
  const std::string_view port = has_port ? host.substr(colon + 1) : "";
  const std::string_view name = has_port ? host.substr(0, colon) : host;
  constexpr std::array<std::string_view, 3> names{"127.0.0.1", "localhost", "[::1]"};
  const bool is_number = std::ranges::all_of(port, [](char letter) { return letter >= '0' && letter <= '9'; });
  return is_number && std::ranges::find(names, name) != names.end();
}

}  // namespace

std::string new_token() {
  std::random_device device;  // the operating system's
  std::string token;
  while (token.size() < 32) {
    for (unsigned bits = device(), digits = 0; digits < 8; ++digits, bits >>= 4U) token.push_back("0123456789abcdef"[bits & 15U]);
  }
  return token;
}

std::optional<Refusal> refusal_of(const Request& request, std::string_view token) {
  if (request.method != "GET") return Refusal{405, "This address accepts no data; it only shows a run."};
  if (!is_this_machine(request.host)) return Refusal{403, "The run can be viewed only on its own machine."};
  const std::size_t question = request.target.find('?');
  const std::string_view path = request.target.substr(0, question);
  const std::string_view query = question == std::string_view::npos ? "" : request.target.substr(question + 1);
  if (path != (request.is_upgrade ? "/live" : "/")) return Refusal{404, "There is no page at this address."};
  constexpr std::string_view name = "token=";
  if (!query.starts_with(name) || !same(query.substr(name.size()), token)) {
    return Refusal{403, "The address lacks the run's token: use the address that the program printed."};
  }
  if (!request.is_upgrade) return std::nullopt;
  constexpr std::string_view scheme = "http://";
  if (!request.origin.starts_with(scheme) || request.origin.substr(scheme.size()) != request.host) {
    return Refusal{403, "Only the run's own page may connect to it."};
  }
  return std::nullopt;
}

}  // namespace trophic::live
