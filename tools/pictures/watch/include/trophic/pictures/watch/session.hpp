// SPDX-License-Identifier: MIT
// A run in a window: the run in a thread of its own, what is seen of it in this one.
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

  /// Opens the window. Throws std::invalid_argument, saying what is missing, where none can be opened.
  explicit Session(const std::string& title);
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// Who is to watch the run.
  [[nodiscard]] Spectator& spectator();

  /// Calls `simulate` in another thread and shows what the spectator is told, until the run has ended and the window is closed.
  /// Once the window is closed, the run goes on without it. Returns what `simulate` returns and throws what it throws.
  int show(const std::function<int()>& simulate);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace trophic::watch
