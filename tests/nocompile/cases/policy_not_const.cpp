// SPDX-License-Identifier: MIT
// A rule that changes itself would make a run depend on who asked before.
// expect: the policy in Rules::Senescence needs bool dies(const Individual&, const View&, Rng&) const
#include <trophic/rules/paper.hpp>

struct EveryTenth {
  static constexpr std::string_view name = "every_tenth";
#ifdef VALID
  bool dies(const trophic::Individual&, const trophic::View& view, trophic::Rng&) const {
    return view.tick % 10 == 9;
  }
#else
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&) {
    return ++asked % 10 == 0;
  }
  int asked = 0;
#endif
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, EveryTenth>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
