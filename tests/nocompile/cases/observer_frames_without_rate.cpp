// SPDX-License-Identifier: MIT
// An observer of frames that does not say how often would see none.
// expect: an observer with on_frame needs double frame_hz(), how often
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Watcher {
  void on_frame(const trophic::observe::Frame&) {}
#ifdef VALID
  double frame_hz() {
    return 5.0;
  }
#endif
};

int main() {
  trophic::Ecology<trophic::rules::Paper, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0, Watcher{});
}
