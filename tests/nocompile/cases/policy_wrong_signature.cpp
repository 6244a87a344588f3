// SPDX-License-Identifier: MIT
// A function of the right name that takes other arguments than the ecology gives.
// expect: the policy in Rules::Senescence needs bool dies(const Individual&, const View&, Rng&) const
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
#ifdef VALID
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(one) > 100.0;
  }
#else
  bool dies(const trophic::Individual& one, const trophic::View& view) const {
    return view.age_s(one) > 100.0;
  }
#endif
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
