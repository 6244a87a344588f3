// SPDX-License-Identifier: MIT
// Fitness functions of gaits.
#pragma once

#include <functional>
#include <numbers>
#include <tools/gait_evolution/track.hpp>
#include <tools/gait_evolution/trial.hpp>
#include <trophic/params/params.hpp>

namespace trophic::gait_evolution {

/// Tries the candidate with a pilot; the robot starts turned by that angle from the trial's facing.
using TryOut = std::function<Track(const Pilot& pilot, double start_turn_rad)>;

/// `fitness(try_out)`: the score of a candidate, higher is better, from as many tries as the policy likes.
template <class P>
concept Fitness = requires(const P policy, const TryOut& try_out) {
  { policy.fitness(try_out) } -> std::same_as<double>;
};

/// How the target angle is chosen while a gait is tried out.
enum class Aim {
  none,    ///< the gait alone: target angle 0
  minus_x  ///< the target angle is the bearing of the negative x-axis, at every control step
};
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Aim) {
  return {"none", "minus_x"};
}

/// Rule: displacement towards the negative x-axis, m (Sec. "Targeted Steering").   Tries: 1.   Random draws: 0.
/// The paper does not say whether the gait is steered meanwhile; the released code's is closed on the heading (Aim::minus_x).
struct DisplacementMinusX {
  static constexpr std::string_view name = "displacement_minus_x";

  struct Params {
    Aim aim = Aim::none;
    static constexpr auto fields() { return std::tuple{field("aim", &Params::aim, "none or minus_x (steered)")}; }
  };
  Params params;

  [[nodiscard]] double fitness(const TryOut& try_out) const;
};
static_assert(Fitness<DisplacementMinusX>);

/// Rule: the paper's displacement towards the negative x-axis, m, but the robot first has to turn to it, steered as a cognitive
/// brain steers: it starts facing start_turn_rad to the left of -x and, in a second try, as far to the right; every decision_s
/// the target angle is +turn_angle_rad where -x lies to the right and -turn_angle_rad where it lies to the left (Sec. "Cognitive
/// Brain": 2 s, 0.7 rad). A try scores its displacement times the share of the time in which the robot faced -x (bearing within
/// 90 degrees), the fitness is the smaller of both: a gait that does not turn to both sides or turns the wrong way walks in
/// circles or past its aim, one that walks backwards never faces it, and both score about 0 or less.   Tries: 2.   Random draws:
/// 0.
struct SteeredDisplacement {
  static constexpr std::string_view name = "steered_displacement";

  struct Params {
    double turn_angle_rad = 0.7;
    double decision_s = 2.0;
    double start_turn_rad = std::numbers::pi / 2.0;
    static constexpr auto fields() {
      return std::tuple{
          field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, std::numbers::pi), "size of the target angle"),
          field("decision_s", &Params::decision_s, above(0.0), "time between two choices of the target angle"),
          field("start_turn_rad", &Params::start_turn_rad, between(0.0, std::numbers::pi), "how far -x is to the side at first")};
    }
  };
  Params params;

  [[nodiscard]] double fitness(const TryOut& try_out) const;

 private:
  [[nodiscard]] double score_m(const TryOut& try_out, double start_turn_rad) const;
};
static_assert(Fitness<SteeredDisplacement>);

}  // namespace trophic::gait_evolution
