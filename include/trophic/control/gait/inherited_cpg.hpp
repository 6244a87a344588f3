// SPDX-License-Identifier: MIT
// The weights of the pattern generator are inherited.
#pragma once

#include <Eigen/Core>
#include <trophic/control/gait/contract.hpp>

namespace trophic::control::gait {

/// The gait of an individual without a parent: the robot's own, or random weights.
enum class FirstGait { robots, random };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(FirstGait) {
  return {"robots", "random"};
}

/// Rule: the genes are the weights of the robot's CPG: w_i of each hinge, then c_ij of each pair of neighbours i < j. Without a
/// parent: the robot's own gait plus N(0, first_sd) for each weight, or uniform within +-limit. Mutation: w <- clip(w + N(0, sd),
/// -limit, limit). This rule is for bodies that do not evolve; the pattern generator restarts at birth.   Reads: nothing. Random
/// draws: 2 per weight; 1 per weight of a random gait.
struct InheritedCpg {
  static constexpr std::string_view name = "inherited_cpg";
  static constexpr std::string_view source = "not in the paper; its conclusion names it as future work";
  static constexpr bool fits_one_body = true;

  struct Params {
    FirstGait first = FirstGait::robots;
    double first_sd = 0.05;
    double sd = 0.02;
    double limit = 2.0;
    static constexpr auto fields() {
      return std::tuple{
          field("first", &Params::first, "gait of an individual without a parent: robots (the robot's own, with noise) or random")
              .read_for_newcomers(),
          field("first_sd", &Params::first_sd, at_least(0.0), "standard deviation of the noise on the first gaits")
              .read_for_newcomers(),
          field("sd", &Params::sd, at_least(0.0), "standard deviation of mutations"),
          field("limit", &Params::limit, above(0.0), "bound on the absolute value of weights")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<double> draw(const RobotModel& robot, const Habitat& habitat, Rng& rng) const {
    std::vector<double> genes;
    const Gait* own = params.first == FirstGait::robots ? habitat.gait_of(robot) : nullptr;
    if (params.first == FirstGait::robots && own == nullptr) {
      throw std::invalid_argument{"robot " + robot.name + ": has no gait to start from; set rules.gait.first = random"};
    }
    for_each_weight(robot, [&](Eigen::Index i, Eigen::Index j) {
      const double start = own == nullptr ? rng.uniform(-params.limit, params.limit)
                                          : (i == j ? own->internal[i] : own->coupling(i, j)) + rng.normal(0.0, params.first_sd);
      genes.push_back(std::clamp(start, -params.limit, params.limit));
    });
    return genes;
  }

  void mutate(std::vector<double>& genes, const Individual&, Rng& rng) const {
    for (double& gene : genes) gene = std::clamp(gene + rng.normal(0.0, params.sd), -params.limit, params.limit);
  }

  [[nodiscard]] Gait express(std::span<const double> genes, const RobotModel& robot, const Habitat&) const {
    const auto n = static_cast<Eigen::Index>(robot.hinges.size());
    Gait gait{.name = "inherited",
              .robot = robot.name,
              .provenance = "inherited",
              .hinges = {},
              .internal = Eigen::VectorXd::Zero(n),
              .coupling = Eigen::MatrixXd::Zero(n, n)};
    for (const Hinge& hinge : robot.hinges) gait.hinges.push_back(hinge.name);
    std::size_t taken = 0;
    for_each_weight(robot, [&](Eigen::Index i, Eigen::Index j) {
      const double gene = taken < genes.size() ? genes[taken] : 0.0;
      ++taken;
      if (i == j) {
        gait.internal[i] = gene;
      } else {
        gait.coupling(i, j) = gene;
        gait.coupling(j, i) = -gene;
      }
    });
    if (taken == genes.size()) return gait;
    throw std::invalid_argument{std::to_string(genes.size()) + " genes of a gait of robot " + robot.name + ": must be " +
                                std::to_string(taken) + ", one for each hinge and each pair of neighbours"};
  }

 private:
  /// Calls `visit(i, i)` for each hinge, then `visit(i, j)` for each pair of neighbours i < j.
  template <class Visitor>
  static void for_each_weight(const RobotModel& robot, const Visitor& visit) {
    const auto hinges = static_cast<Eigen::Index>(robot.hinges.size());
    for (Eigen::Index i = 0; i < hinges; ++i) visit(i, i);
    for (Eigen::Index i = 0; i < hinges; ++i) {
      for (const std::size_t j : robot.hinge_neighbours[static_cast<std::size_t>(i)]) {
        if (static_cast<Eigen::Index>(j) > i) visit(i, static_cast<Eigen::Index>(j));
      }
    }
  }
};
static_assert(InheritedGait<InheritedCpg>);

}  // namespace trophic::control::gait
