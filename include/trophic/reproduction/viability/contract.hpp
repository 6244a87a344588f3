// SPDX-License-Identifier: MIT
// The contract of a slot: whether an individual may be born with a body.
#pragma once

#include <optional>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/habitat/robot_model.hpp>

#define TROPHIC_SENTENCE_Viability                                                                                          \
  "std::optional<std::string> refusal(const body::Design&, const RobotModel&) const and std::size_t attempts() const; see " \
  "trophic/reproduction/viability/contract.hpp"

namespace trophic::reproduction {

/// `refusal(design, robot)`: returns why no individual may be born with this body, such as "12 hinges: must be <= 10", or
/// nothing. A pure function. `attempts()`: how often a mutation of the parent's genes is attempted, at least 1; if all are
/// refused, the offspring has its parent's body. Bodies without hinges and those that cannot be built are refused by every table.
template <class P>
concept Viability = requires(const P policy, const body::Design& design, const RobotModel& robot) {
  { policy.refusal(design, robot) } -> std::same_as<std::optional<std::string>>;
  { policy.attempts() } -> std::same_as<std::size_t>;
};

/// A rule that also tests newborns in a nursery. `refusal_after_trial(robot, gait, nursery)`: returns why this body may not be
/// born with this gait, or nothing. A pure function. Body and gait of a refused newborn are drawn or mutated again.
template <class P>
concept TriesNewborns = Viability<P> &&
    requires(const P policy, const RobotModel& robot, const Gait& gait, const Nursery& nursery) {
  { policy.refusal_after_trial(robot, gait, nursery) } -> std::same_as<std::optional<std::string>>;
};

namespace ask {

/// Returns nothing for a rule that does not test newborns and needs no nursery.
template <class P>
[[nodiscard]] std::optional<std::string> refusal_after_trial([[maybe_unused]] const P& policy,
                                                             [[maybe_unused]] const RobotModel& robot,
                                                             [[maybe_unused]] const Gait& gait,
                                                             [[maybe_unused]] const Nursery* nursery) {
  if constexpr (TriesNewborns<P>) return policy.refusal_after_trial(robot, gait, *nursery);
  return std::nullopt;
}

}  // namespace ask

}  // namespace trophic::reproduction
