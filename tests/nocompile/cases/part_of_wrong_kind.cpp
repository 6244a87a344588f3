// SPDX-License-Identifier: MIT
// A part of another kind.
// expect: a part of the policy in Rules::Starvation does not fit the contract of that part
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Rules = trophic::with_starvation_exemption<trophic::rules::Paper, trophic::death::starvation::exemption::NoExemption>;
#else
using Rules = trophic::with_starvation_interval<trophic::rules::Paper, trophic::death::starvation::exemption::NoExemption>;
#endif

int main() {
  trophic::Ecology<Rules> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
