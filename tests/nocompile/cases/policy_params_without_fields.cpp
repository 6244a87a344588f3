// SPDX-License-Identifier: MIT
// A rule's number that fields() does not list would be missing from configuration and manifest.
// expect: the Params of the policy in Rules::Senescence need static constexpr auto fields(), listing every number
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
  struct Params {
    double max_age_s = 100.0;
#ifdef VALID
    static constexpr auto fields() {
      return std::tuple{trophic::field("max_age_s", &Params::max_age_s, trophic::above(0.0), "age at death")};
    }
#endif
  };
  Params params;
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(one) > params.max_age_s;
  }
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
