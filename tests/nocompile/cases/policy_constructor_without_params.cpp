// SPDX-License-Identifier: MIT
// A rule whose constructor takes no Params would run with its defaults, whatever was set.
// expect: the policy in Rules::Senescence has Params but cannot be made from them: it needs `Params params;` as its first member
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/rules/paper.hpp>

struct Ageing {
  static constexpr std::string_view name = "ageing";
  using Params = trophic::death::senescence::OldAge::Params;
  Ageing() = default;
#ifdef VALID
  explicit Ageing(const Params& given) : params{given} {}
#else
  explicit Ageing(double max_age_s) : params{max_age_s} {}
#endif
  Params params;
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(one) > params.max_age_s;
  }
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.senescence.max_age_s > 0.0 ? 0 : 1;
}
