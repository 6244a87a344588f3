// SPDX-License-Identifier: MIT
// Decisions from outside: the run stops when all robots have perceived, this program decides for the prey, and the evolved brains
// decide for the predators. Births, deaths and genomes are those of the rule table.
#include <iostream>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/ecology/stepped_run.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <vector>

/// Counts deaths by catches.
struct Catches {
  int count = 0;
  void on_event(const trophic::observe::Event& event, const trophic::View&) {
    count += event.kind == trophic::observe::EventKind::capture ? 1 : 0;
  }
};

int main() {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  Catches catches;
  trophic::SteppedRun run{ecology, 6000.0, catches};
  while (run.sense()) {
    const trophic::Perceived& now = run.perceived();
    std::vector<double> outputs(run.own_outputs().begin(), run.own_outputs().end());
    for (std::size_t i = 0; i < now.bodies.size(); ++i) {
      const trophic::View view = ecology.view();
      if (view.web.hunts(view.robots[now.bodies[i]].species)) continue;
      const double side = now.inputs[i * now.inputs_each];  // of the nearest predator: positive on the right
      outputs[i * now.outputs_each] = -side;                // turns to the other side
    }
    run.decide(outputs);
  }
  std::cout << catches.count << " prey were caught; those that flee are caught less often\n";
}
