// SPDX-License-Identifier: MIT
// A rule with numbers.
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
  struct Params {
    double max_age_s = 600.0;
    bool spares_founders = false;
    static constexpr auto fields() {
      return std::tuple{trophic::field("max_age_s", &Params::max_age_s, trophic::above(0.0)),
                        trophic::field("spares_founders", &Params::spares_founders)};
    }
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
