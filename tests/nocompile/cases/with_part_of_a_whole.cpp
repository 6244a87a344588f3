// SPDX-License-Identifier: MIT
// A part is swapped in a policy that is made of parts alone.
// expect: with_part: the table's policy in this slot is not made of parts; swap it by with_<slot>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/rules/paper.hpp>

using Killers = trophic::with_parent<trophic::rules::Paper, trophic::reproduction::parent::Killer>;
#ifdef VALID
using Rules = trophic::with_parent<Killers, trophic::reproduction::parent::NearestVictim>;
#else
using Rules = trophic::with_parent_after<Killers, trophic::Cause::starved, trophic::reproduction::parent::NearestVictim>;
#endif

int main() {
  return trophic::RuleParams<Rules>{}.capture.reach_m == 1.0 ? 0 : 1;
}
