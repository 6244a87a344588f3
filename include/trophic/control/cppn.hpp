// SPDX-License-Identifier: MIT
// A compositional pattern-producing network that generates the weights of a robot's CPG.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::control {

/// The activation function of a node, applied to the weighted sum of its links.
enum class Activation : std::uint8_t { sine, gaussian, tanh, linear, abs, step };
[[nodiscard]] constexpr std::array<std::string_view, 6> enum_names(Activation) {
  return {"sine", "gaussian", "tanh", "linear", "abs", "step"};
}

/// sin(x), exp(-x^2), tanh(x), x, |x|, or the step function (1 for x >= 0, else 0), where x is `sum` clipped to +-1e6, so that
/// every chain of nodes stays finite.
[[nodiscard]] inline double activate(Activation activation, double sum) {
  const double x = std::clamp(sum, -1e6, 1e6);
  switch (activation) {
    case Activation::sine:
      return std::sin(x);
    case Activation::gaussian:
      return std::exp(-x * x);
    case Activation::tanh:
      return std::tanh(x);
    case Activation::linear:
      return x;
    case Activation::step:
      return x >= 0.0 ? 1.0 : 0.0;
    case Activation::abs:
      break;
  }
  return std::abs(x);
}

/// A feed-forward CPPN [stanley2007] of seven inputs (1 and the grid cells of two hinges), hidden nodes in an order in which each
/// link leads to a later node, and one sine output. Nodes are numbered in the order inputs (0 to 6), hidden, output. As inherited
/// genes: the number of hidden nodes, their activations (all but step), then (from, to, weight) for each link.
struct Cppn {
  static constexpr std::size_t inputs = 7;
  static constexpr std::size_t inherited_activations = 5;
  static constexpr std::size_t most_hidden = 100;

  struct Link {
    std::size_t from = 0;
    std::size_t to = 0;
    double weight = 0.0;
  };
  std::vector<Activation> hidden;
  std::vector<Link> links;

  [[nodiscard]] std::size_t output() const { return inputs + hidden.size(); }

  /// Throws std::invalid_argument for other genes.
  [[nodiscard]] static Cppn of(std::span<const double> genes) {
    const auto require = [](bool good) {
      if (!good) throw std::invalid_argument{"genes of a gait: must be a feed-forward CPPN"};
    };
    std::size_t next = 0;
    const auto index = [&](std::size_t bound) {
      require(next < genes.size());
      const double gene = genes[next++];
      require(gene >= 0.0 && gene < static_cast<double>(bound) && gene == std::floor(gene));
      return static_cast<std::size_t>(gene);
    };
    Cppn network;
    network.hidden.resize(index(most_hidden + 1));
    for (Activation& activation : network.hidden) activation = static_cast<Activation>(index(inherited_activations));
    require((genes.size() - next) % 3 == 0);
    while (next < genes.size()) {
      const std::size_t from = index(network.output());
      const std::size_t to = index(network.output() + 1);
      require(from < to && to >= inputs && std::isfinite(genes[next]));
      network.links.push_back({.from = from, .to = to, .weight = genes[next++]});
    }
    return network;
  }

  [[nodiscard]] std::vector<double> genes() const {
    std::vector<double> all{static_cast<double>(hidden.size())};
    for (const Activation activation : hidden) all.push_back(static_cast<double>(activation));
    for (const Link& link : links)
      all.insert(all.end(), {static_cast<double>(link.from), static_cast<double>(link.to), link.weight});
    return all;
  }

  /// Returns the output for the grid cells of two hinges, within [-1, 1].
  [[nodiscard]] double operator()(const Eigen::Vector3i& first, const Eigen::Vector3i& second) const {
    std::vector<double> value(output() + 1, 0.0);
    value[0] = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      value[1 + static_cast<std::size_t>(axis)] = first[axis];
      value[4 + static_cast<std::size_t>(axis)] = second[axis];
    }
    for (std::size_t node = inputs; node <= output(); ++node) {
      double sum = 0.0;
      for (const Link& link : links) sum += link.to == node ? link.weight * value[link.from] : 0.0;
      value[node] = activate(node == output() ? Activation::sine : hidden[node - inputs], sum);
    }
    return value[output()];
  }

  /// Replaces a link by a new node with a random activation: weight 1 into it, the old weight out of it. 2 draws.
  void split_link(Rng& rng) {
    if (links.empty() || hidden.size() >= most_hidden) return;
    const Link old = links[rng.index(links.size())];
    const auto activation = static_cast<Activation>(rng.index(inherited_activations));
    const std::size_t place = old.to;  // the new node comes just before the end of the link
    std::erase_if(links, [&](const Link& link) { return link.from == old.from && link.to == old.to; });
    for (Link& link : links) {
      link.from += link.from >= place ? 1U : 0U;
      link.to += link.to >= place ? 1U : 0U;
    }
    hidden.insert(hidden.begin() + static_cast<std::ptrdiff_t>(place - inputs), activation);
    links.push_back({.from = old.from, .to = place, .weight = 1.0});
    links.push_back({.from = place, .to = old.to + 1, .weight = old.weight});
  }

  /// Adds a link between two unlinked nodes, each such pair equally likely. 2 draws.
  void add_link(double limit, Rng& rng) {
    std::vector<std::pair<std::size_t, std::size_t>> free;
    for (std::size_t to = inputs; to <= output(); ++to) {
      for (std::size_t from = 0; from < to; ++from) {
        const auto joins = [&](const Link& link) { return link.from == from && link.to == to; };
        if (std::ranges::none_of(links, joins)) free.emplace_back(from, to);
      }
    }
    if (free.empty()) return;
    const auto [from, to] = free[rng.index(free.size())];
    links.push_back({.from = from, .to = to, .weight = rng.uniform(-limit, limit)});
  }

  /// The gait that it generates for a robot (Sec. "Targeted Steering"): with the grid cells of the hinges, w_i is CPPN(i, i) and
  /// c_ij of two neighbours i < j is CPPN(i, j).
  [[nodiscard]] Gait gait_of(const RobotModel& robot) const {
    const auto n = static_cast<Eigen::Index>(robot.hinges.size());
    Gait gait{.name = {},
              .robot = robot.name,
              .provenance = {},
              .hinges = {},
              .internal = Eigen::VectorXd::Zero(n),
              .coupling = Eigen::MatrixXd::Zero(n, n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      const Hinge& hinge = robot.hinges[static_cast<std::size_t>(i)];
      gait.hinges.push_back(hinge.name);
      gait.internal[i] = (*this)(hinge.grid_position, hinge.grid_position);
      for (const std::size_t other : robot.hinge_neighbours[static_cast<std::size_t>(i)]) {
        const auto j = static_cast<Eigen::Index>(other);
        if (j <= i) continue;
        gait.coupling(i, j) = (*this)(hinge.grid_position, robot.hinges[other].grid_position);
        gait.coupling(j, i) = -gait.coupling(i, j);
      }
    }
    return gait;
  }
};

}  // namespace trophic::control
