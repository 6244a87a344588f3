// SPDX-License-Identifier: MIT
// The signatures of the hooks of a final class could not be checked.
// expect: an observer must not be final
#include <trophic/ecology/simulation.hpp>

#ifdef VALID
struct Watcher {
#else
struct Watcher final {
#endif
  void on_tick(const trophic::View&) {}
};

void run(trophic::Simulation& ecology) {
  ecology.run_until(10.0, Watcher{});
}
