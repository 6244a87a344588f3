// SPDX-License-Identifier: MIT
// An observer whose only hook is misspelt would see nothing.
// expect: an observer needs at least one hook
#include <trophic/ecology/simulation.hpp>

struct Watcher {
#ifdef VALID
  void on_tick(const trophic::View&) {}
#else
  void on_tock(const trophic::View&) {}
#endif
};

void run(trophic::Simulation& ecology) {
  ecology.run_until(10.0, Watcher{});
}
