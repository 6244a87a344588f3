// SPDX-License-Identifier: MIT
// Newborns must walk in a nursery without diverging.
#pragma once

#include <trophic/params/policy.hpp>
#include <trophic/reproduction/viability/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::viability {

/// Rule: a body that `Rule` allows may be born if it walks with its own gait in a nursery for `trial_s` without diverging.
/// Otherwise its body and gait are drawn or mutated again.   Reads: body and gait.   Random draws: Rule's.
template <class Rule>
struct SurvivesTrial {
  static_assert(Viability<Rule>, "viability::SurvivesTrial takes a rule of the slot Viability");
  static constexpr std::string_view name = prefixed_name<"survives_trial", Rule>;
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    ParamsOf<Rule> bodies = {};
    double trial_s = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("bodies", &Params::bodies), field("trial_s", &Params::trial_s, between(0.01, 600.0),
                                                                "length of the trial in the nursery, simulated seconds")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<std::string> refusal(const body::Design& design, const RobotModel& robot) const {
    return make_policy<Rule>(params.bodies).refusal(design, robot);
  }
  [[nodiscard]] std::size_t attempts() const { return make_policy<Rule>(params.bodies).attempts(); }

  [[nodiscard]] std::optional<std::string> refusal_after_trial(const RobotModel& robot, const Gait& gait,
                                                               const Nursery& nursery) const {
    if (nursery.walked_m(robot, gait, params.trial_s)) return std::nullopt;
    return "diverges within " + number_text(params.trial_s) + " s: must walk until the end of the trial";
  }
};

}  // namespace trophic::reproduction::viability
