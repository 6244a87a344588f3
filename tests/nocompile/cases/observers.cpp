// SPDX-License-Identifier: MIT
// What is told of a run.
#include <trophic/ecology/simulation.hpp>

struct Watcher {
  void on_tick(const trophic::View&) {}
};

struct Camera {
  void on_frame(const trophic::observe::Frame&) {}
  double frame_hz() { return 5.0; }
};

struct Listener {
  void on_decision(const trophic::observe::DecisionRecord&, const trophic::View&) {}
  bool wants_decisions() { return true; }
};

void run(trophic::Simulation& ecology) {
  ecology.run_until(10.0, Watcher{}, Camera{}, Listener{});
}
