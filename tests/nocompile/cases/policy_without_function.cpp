// SPDX-License-Identifier: MIT
// A policy that lacks what its slot asks for.
// expect: the policy in Rules::GenomeSource needs Descent descent(Rng&) const; see
#include <trophic/rules/paper.hpp>

struct AlwaysInherits {
  static constexpr std::string_view name = "always_inherits";
#ifdef VALID
  trophic::reproduction::Descent descent(trophic::Rng&) const {
    return trophic::reproduction::Descent::of_parent;
  }
#endif
};

int main() {
  using Rules = trophic::with_genome_source<trophic::rules::Paper, AlwaysInherits>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
