// SPDX-License-Identifier: MIT
// An inherited network generates a gait for any body.
#pragma once

#include <Eigen/Core>
#include <trophic/control/cppn.hpp>
#include <trophic/control/gait/contract.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>

namespace trophic::control::gait {

/// Rule: the genes are a growing CPPN (control/cppn.hpp) that generates the gait. With `first = robots` this is added to `gait`
/// for hinges with the same path from the core, and first networks have small weights; with `random` the CPPN alone makes the
/// gait. In first networks each input is linked to the output.   Reads: nothing.   Random draws: 7 without a parent; at a
/// mutation 1 to 3 per link, 2 for growth, and 2 more per new part.
struct InheritedCppn {
  static constexpr std::string_view name = "inherited_cppn";
  static constexpr std::string_view source = "not in the paper; networks as in [stanley2007]";

  struct Params {
    FirstGait first = FirstGait::robots;
    double first_limit = 0.05;
    double weight_probability = 0.8;
    double weight_sd = 0.02;
    double weight_limit = 2.0;
    double link_probability = 0.1;
    double node_probability = 0.05;
    std::string gait = {};
    static constexpr auto fields() {
      return std::tuple{
          field("first", &Params::first, "base to which the network is added: robots (the gait below) or random (none)"),
          field("first_limit", &Params::first_limit, at_least(0.0),
                "bound on the absolute value of first weights and of new links' weights"),
          field("weight_probability", &Params::weight_probability, between(0.0, 1.0), "probability that a weight mutates"),
          field("weight_sd", &Params::weight_sd, at_least(0.0), "standard deviation of a weight's mutation"),
          field("weight_limit", &Params::weight_limit, above(0.0), "bound on the absolute value of weights"),
          field("link_probability", &Params::link_probability, between(0.0, 1.0), "probability that an offspring has a new link"),
          field("node_probability", &Params::node_probability, between(0.0, 1.0),
                "probability that a new node splits one of its links"),
          field("gait", &Params::gait, "name or path of a gait; empty: the gait of ecology.robot")};
    }
  };
  Params params;

  /// The models to load before the run.
  [[nodiscard]] std::vector<std::string> gaits() const {
    return params.gait.empty() ? std::vector<std::string>{} : std::vector{params.gait};
  }

  [[nodiscard]] std::vector<double> draw(const RobotModel&, const Habitat&, Rng& rng) const {
    Cppn network;
    for (std::size_t input = 0; input < Cppn::inputs; ++input) {
      network.links.push_back(
          {.from = input, .to = network.output(), .weight = rng.uniform(-params.first_limit, params.first_limit)});
    }
    return network.genes();
  }

  void mutate(std::vector<double>& genes, const Individual&, Rng& rng) const {
    auto network = Cppn::of(genes);
    for (auto& link : network.links) {
      if (!rng.chance(params.weight_probability)) continue;
      link.weight = std::clamp(link.weight + rng.normal(0.0, params.weight_sd), -params.weight_limit, params.weight_limit);
    }
    if (rng.chance(params.link_probability)) network.add_link(params.first_limit, rng);
    if (rng.chance(params.node_probability)) network.split_link(rng);
    genes = network.genes();
  }

  /// All but the weights of the links.
  [[nodiscard]] std::vector<std::size_t> structure(std::span<const double> genes) const {
    const std::size_t first_link = 1 + Cppn::of(genes).hidden.size();
    std::vector<std::size_t> indices;
    for (std::size_t gene = 0; gene < genes.size(); ++gene)
      if (gene < first_link || (gene - first_link) % 3 != 2) indices.push_back(gene);
    return indices;
  }

  [[nodiscard]] Gait express(std::span<const double> genes, const RobotModel& robot, const Habitat& habitat) const {
    Gait gait = Cppn::of(genes).gait_of(robot);
    gait.name = gait.provenance = "inherited";
    const Gait& base = base_in(habitat);
    if (params.first == FirstGait::random) return gait;
    for (Eigen::Index i = 0; i < gait.internal.size(); ++i) {
      const Eigen::Index was = place_in(base, gait.hinges[static_cast<std::size_t>(i)]);
      if (was < 0) continue;
      gait.internal[i] += base.internal[was];
      for (const std::size_t other : robot.hinge_neighbours[static_cast<std::size_t>(i)]) {
        const auto j = static_cast<Eigen::Index>(other);
        const Eigen::Index there = place_in(base, gait.hinges[other]);
        if (j <= i || there < 0) continue;
        gait.coupling(i, j) += base.coupling(was, there);
        gait.coupling(j, i) = -gait.coupling(i, j);
      }
    }
    return gait;
  }

 private:
  [[nodiscard]] const Gait& base_in(const Habitat& habitat) const {
    if (params.gait.empty()) return habitat.gait;
    if (const Gait* named = habitat.gait_named(params.gait)) return *named;
    throw std::invalid_argument{"rules.gait.gait = \"" + params.gait + "\": must be a model of the habitat"};
  }
  [[nodiscard]] static Eigen::Index place_in(const Gait& gait, std::string_view hinge) {
    const auto found = std::ranges::find(gait.hinges, hinge);
    return found == gait.hinges.end() ? -1 : static_cast<Eigen::Index>(found - gait.hinges.begin());
  }
};
static_assert(InheritedGait<InheritedCppn>);

}  // namespace trophic::control::gait
