// SPDX-License-Identifier: MIT
// A policy that lacks what its slot asks for.
// expect: the policy in Rules::GenomeSource needs bool inherits(Rng&) const and Origin without_parent() const
#include <trophic/rules/paper.hpp>

struct AlwaysInherits {
  static constexpr std::string_view name = "always_inherits";
  bool inherits(trophic::Rng&) const { return true; }
#ifdef VALID
  trophic::Origin without_parent() const {
    return trophic::Origin::random;
  }
#endif
};

int main() {
  using Rules = trophic::with_genome_source<trophic::rules::Paper, AlwaysInherits>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
