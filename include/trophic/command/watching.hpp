// SPDX-License-Identifier: MIT
// `--watch`: a run in a window while it goes on, in programs that are linked with trophic::watch.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
// Who links trophic::watch has this definition.
#ifdef TROPHIC_WITH_WATCH
#include <trophic/pictures/watch/session.hpp>
#endif

namespace trophic::command::detail {

#ifdef TROPHIC_WITH_WATCH
using Watching = watch::Session;
#else
/// Says that there is no window in this program.
class Watching {
 public:
  struct Spectator {
    [[nodiscard]] static bool keep_running() { return true; }
  };

  explicit Watching(const std::string&) {
    throw std::invalid_argument{
        "--watch: this program was built without a window; apt-get install libglfw3-dev libmujoco-dev and build again"};
  }
  [[nodiscard]] Spectator& spectator() { return spectator_; }
  template <class Simulate>
  [[nodiscard]] int show(Simulate&& simulate) {
    return std::forward<Simulate>(simulate)();
  }

 private:
  Spectator spectator_;
};
#endif

}  // namespace trophic::command::detail
