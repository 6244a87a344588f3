// SPDX-License-Identifier: MIT
// A hook that cannot be called would never be.
// expect: the observer's on_tick must be callable as void on_tick(const View&)
#include <trophic/ecology/simulation.hpp>

struct Watcher {
#ifdef VALID
  void on_tick(const trophic::View&) {}
#else
  void on_tick(double) {}
#endif
};

void run(trophic::Simulation& ecology) {
  ecology.run_until(10.0, Watcher{});
}
