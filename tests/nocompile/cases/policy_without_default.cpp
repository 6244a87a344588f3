// SPDX-License-Identifier: MIT
// A rule without Params that cannot be made from nothing.
// expect: the policy in Rules::Senescence has no Params, so it needs a default constructor
#include <trophic/rules/paper.hpp>

class Ageing {
 public:
  static constexpr std::string_view name = "ageing";
#ifdef VALID
  Ageing() = default;
#endif
  explicit Ageing(double max_age_s) : max_age_s_{max_age_s} {}
  bool dies(const trophic::Individual& one, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(one) > max_age_s_;
  }

 private:
  double max_age_s_ = 600.0;
};

int main() {
  using Rules = trophic::with_senescence<trophic::rules::Paper, Ageing>;
  return trophic::RuleParams<Rules>{}.floor.floor == 7 ? 0 : 1;
}
