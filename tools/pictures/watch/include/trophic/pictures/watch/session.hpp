// SPDX-License-Identifier: MIT
// A run in a window: the run in its own thread, the window in this one.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <trophic/pictures/watch/spectator.hpp>

namespace trophic::watch {

/// One at a time in a program, in its main thread. The run's results do not depend on it.
class Session {
 public:
  using Spectator = watch::Spectator;

  /// Opens the window. Throws std::invalid_argument, naming what is missing, if none can be opened.
  explicit Session(const std::string& title);
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// The observer of the run.
  [[nodiscard]] Spectator& spectator();

  /// Calls `simulate` in another thread and shows the run until it has ended and the window is closed. Once the window is closed,
  /// the run continues without it. Returns the result of `simulate`, and throws its exceptions.
  int show(const std::function<int()>& simulate);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace trophic::watch
