// SPDX-License-Identifier: MIT
// Bodies that their servos can carry.
#pragma once

#include <trophic/reproduction/viability/contract.hpp>

namespace trophic::reproduction::viability {

/// Rule: a body of at most `most_kg` may be born; the mutation of a heavier one is repeated, up to `attempts` times in total.
/// Reads: the mass.   Random draws: 0.
struct WithinMass {
  static constexpr std::string_view name = "within_mass";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double most_kg = 2.0;
    std::size_t attempts = 10;
    static constexpr auto fields() {
      return std::tuple{field("most_kg", &Params::most_kg, above(0.0), "largest mass of a body"),
                        field("attempts", &Params::attempts, between(1.0, 1000.0), "number of attempted mutations of a body")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<std::string> refusal(const body::Design&, const RobotModel& robot) const {
    if (robot.mass_kg() <= params.most_kg) return std::nullopt;
    return number_text(robot.mass_kg()) + " kg: must be <= " + number_text(params.most_kg);
  }
  [[nodiscard]] std::size_t attempts() const { return params.attempts; }
};
static_assert(Viability<WithinMass>);

}  // namespace trophic::reproduction::viability
