// SPDX-License-Identifier: MIT
// A number listed under two names would hide that another is missing.
// expect: the Params of the policy in Rules::Senescence must list no number and no name twice in fields()
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
  struct Params {
    double min_age_s = 60.0;
    double max_age_s = 600.0;
    static constexpr auto fields() {
      return std::tuple{trophic::field("max_age_s", &Params::max_age_s, trophic::above(0.0)),
#ifdef VALID
                        trophic::field("min_age_s", &Params::min_age_s, trophic::above(0.0))};
#else
                        trophic::field("min_age_s", &Params::max_age_s, trophic::above(0.0))};
#endif
    }
  };
  Params params;
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng& rng) const {
    return view.age_s(one) > rng.uniform(params.min_age_s, params.max_age_s);
  }
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.senescence.max_age_s > 0.0 ? 0 : 1;
}
