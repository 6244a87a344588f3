// SPDX-License-Identifier: MIT
// An observer of deliberations that does not say whether it wants them would be told of none.
// expect: an observer with on_deliberation needs bool wants_deliberations(), whether it is to be told now
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Listener {
  void on_deliberation(const trophic::observe::Deliberation&, const trophic::View&) {}
#ifdef VALID
  bool wants_deliberations() {
    return true;
  }
#endif
};

int main() {
  trophic::Ecology<trophic::rules::Paper, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0, Listener{});
}
