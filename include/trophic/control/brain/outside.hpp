// SPDX-License-Identifier: MIT
// A brain whose decisions come from outside the ecology.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic::control::brain {

/// Rule: no decision of its own: a program outside the ecology decides for each robot (trophic/ecology/stepped_run.hpp), which
/// reads the sensors and, if it likes, the genome. Target angle and tag are those of the acts. Genome: numbers that are inherited
/// and mutated as weights are, for a decider that depends on them. Any other table can be decided from outside as well; its
/// genomes then hold the weights of its own brain.
/// Reads: nothing.   Random draws: 0.
struct Outside {
  static constexpr std::string_view name = "outside";
  static constexpr std::string_view source = "not in the paper";
  static constexpr bool is_outside = true;

  struct Params {
    std::size_t genes = 0;
    static constexpr auto fields() {
      return std::tuple{field("genes", &Params::genes, between(0.0, 100000.0), "numbers in a genome")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return params.genes; }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }
  /// Throws RuleError: it is asked only by a tool that plays or compares brains.
  void evaluate(std::span<const double>, std::span<const double>, std::span<double>) const {
    throw RuleError{"rules.brain = outside: has no outputs of its own; they come from SteppedRun::decide"};
  }
};
static_assert(Brain<Outside>);

}  // namespace trophic::control::brain
