// SPDX-License-Identifier: MIT
// An observer of deliberations that does not say whether it wants them would be told of none.
// expect: an observer with on_decision needs bool wants_decisions(), whether it is to be told now
#include <trophic/ecology/simulation.hpp>

struct Listener {
  void on_decision(const trophic::observe::DecisionRecord&, const trophic::View&) {}
#ifdef VALID
  bool wants_decisions() {
    return true;
  }
#endif
};

void run(trophic::Simulation& ecology) {
  ecology.run_until(10.0, Listener{});
}
