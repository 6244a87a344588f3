// SPDX-License-Identifier: MIT
// A part is swapped in a policy that is made of parts alone.
// expect: with_part: the table's policy in this slot is not made of parts; swap it by with_<slot>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/rules/paper.hpp>

using Killers = trophic::with_parent<trophic::rules::Paper, trophic::reproduction::parent::Killer>;

int main() {
#ifdef VALID
  return sizeof(trophic::RuleParams<trophic::with_parent<Killers, trophic::reproduction::parent::NearestVictim>>) > 0 ? 0 : 1;
#else
  return sizeof(trophic::with_parent_after<Killers, trophic::Cause::starved, trophic::reproduction::parent::NearestVictim>) > 0
             ? 0
             : 1;
#endif
}
