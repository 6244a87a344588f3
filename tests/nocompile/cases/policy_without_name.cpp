// SPDX-License-Identifier: MIT
// A policy that manifests cannot name.
// expect: the policy in Rules::Senescence needs static constexpr std::string_view name
#include <trophic/rules/paper.hpp>

struct Immortal {
#ifdef VALID
  static constexpr std::string_view name = "immortal";
#endif
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&) const {
    return false;
  }
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Immortal>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
