// SPDX-License-Identifier: MIT
// The numbers of a class with private members or a constructor cannot be counted against fields().
// expect: the Params of the policy in Rules::Senescence must be an aggregate: public numbers, no constructor
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
  struct Params {
#ifndef VALID
    Params() = default;
    explicit Params(double age_s) : max_age_s{age_s} {}
#endif
    double max_age_s = 600.0;
    static constexpr auto fields() {
      return std::tuple{trophic::field("max_age_s", &Params::max_age_s, trophic::above(0.0))};
    }
  };
  Params params;
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(one) > params.max_age_s;
  }
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.senescence.max_age_s > 0.0 ? 0 : 1;
}
