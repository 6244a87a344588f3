// SPDX-License-Identifier: MIT
// A policy of another kind in a slot.
// expect: the policy in Rules::Capture needs std::vector<Capture> captures(const View&, Rng&) const
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Policy = trophic::rules::Paper::Capture;
#else
using Policy = trophic::rules::Paper::Floor;
#endif

int main() {
  trophic::Ecology<trophic::with_capture<trophic::rules::Paper, Policy>> ecology({.seed = 2},
                                                                                 trophic::backend::Kinematic::Params{});
  ecology.run_until(10.0);
}
