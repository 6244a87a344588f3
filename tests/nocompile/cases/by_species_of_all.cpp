// SPDX-License-Identifier: MIT
// A rule about the whole population has no species whose numbers could count.
// expect: Rules::MinimumPredators asks about no single individual or species, so its policy's numbers cannot differ by_species
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Rules = trophic::with_floor<trophic::rules::Paper, trophic::rules::by_species<trophic::death::floor::VictimFloor>>;
#else
using Rules =
    trophic::with_minimum_predators<trophic::rules::Paper,
                                    trophic::rules::by_species<trophic::death::minimum_predators::SacrificeRandomVictim>>;
#endif

int main() {
  return trophic::RuleParams<Rules>{}.capture.reach_m == 1.0 ? 0 : 1;
}
