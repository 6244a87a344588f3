// SPDX-License-Identifier: MIT
// The server of a live run: one page, and a web socket for each browser that shows it. On this machine's loopback address alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tools/live/footage.hpp>

namespace trophic::live {

/// Bounds of what a server takes from others.
struct Limits {
  std::size_t connections = 32;
  std::size_t header_bytes = 8192;
  std::size_t waiting_bytes = std::size_t{4} << 20U;   ///< of a page that is slow: it is then left out of ticks
  std::size_t history_bytes = std::size_t{96} << 20U;  ///< of ticks, for pages that come later
  int seconds_to_ask = 20;                             ///< that a connection may take for its request
};

/// Called in the server's thread.
struct Callbacks {
  /// The number of pages changed.
  std::function<void(std::size_t pages)> pages;
  /// A message of the page that steers. Returns the sentence of its refusal, empty if it was taken.
  std::function<std::string(const std::string& message)> wish;
  /// The state that a page is shown, with the run's changes after those that it was `told`.
  std::function<Json(std::size_t told)> state;
};

/// Serves in a thread of its own from construction to destruction. The members may be called from any thread.
class Server {
 public:
  /// `port` 0: one that is free. Throws std::invalid_argument if it cannot listen.
  Server(std::uint16_t port, std::string page, Callbacks callbacks, Limits limits = {});
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] const std::string& token() const;
  /// http://127.0.0.1:PORT/?token=TOKEN
  [[nodiscard]] std::string address() const;

  /// Another run: all pages begin anew with its facts.
  void begin(SharedMessage facts);
  /// Makes messages in the server's thread and sends them to all pages. Ticks that wait while it is busy are shown without robots
  /// and poses, so that a run never waits for pages; the last tick is shown whole.
  void show(std::shared_ptr<TickSight> sight, std::shared_ptr<const RunFacts> facts);
  /// Sends to all pages now; later ones do not get it.
  void tell(SharedMessage message);
  /// Sends each page the state.
  void tell_state();

 private:
  class Hub;
  class Connection;
  class Page;
  std::unique_ptr<Hub> hub_;
};

}  // namespace trophic::live
