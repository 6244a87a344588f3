// SPDX-License-Identifier: MIT
// An observer of frames that does not say how often would see none.
// expect: an observer with on_frame needs double frame_hz(), and one with frame_hz
#include <trophic/ecology/simulation.hpp>

struct Watcher {
  void on_frame(const trophic::observe::Frame&) {}
#ifdef VALID
  double frame_hz() {
    return 5.0;
  }
#endif
};

void run(trophic::Simulation& ecology) {
  ecology.run_until(10.0, Watcher{});
}
