// SPDX-License-Identifier: MIT
// A number that fields() leaves out could not be set and would be missing from the manifest.
// expect: the Params of the policy in Rules::Senescence must list every number in fields()
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
  struct Params {
    double max_age_s = 600.0;
    bool spares_founders = false;
    static constexpr auto fields() {
      return std::tuple{trophic::field("max_age_s", &Params::max_age_s, trophic::above(0.0))
#ifdef VALID
                            ,
                        trophic::field("spares_founders", &Params::spares_founders)
#endif
      };
    }
  };
  Params params;
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(one) > params.max_age_s && !(params.spares_founders && one.id < 30);
  }
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.senescence.max_age_s > 0.0 ? 0 : 1;
}
