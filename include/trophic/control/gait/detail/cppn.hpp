// SPDX-License-Identifier: MIT
// A compositional pattern producing network as plain numbers.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <trophic/support/rng.hpp>
#include <vector>

namespace trophic::control::gait::detail {

/// A feed-forward CPPN [stanley2007] of seven inputs (1 and the grid cells of two hinges), hidden nodes in an order in which each
/// link leads to a later node, and one sine as output. As genes: the number of hidden nodes, their activations, then
/// (from, to, weight) for each link. Nodes are numbered: inputs 0 to 6, hidden ones, output.
struct Cppn {
  static constexpr std::size_t inputs = 7;
  static constexpr std::size_t activations = 5;  ///< sine, gaussian, tanh, linear, abs
  static constexpr std::size_t most_hidden = 100;

  struct LinkGene {
    std::size_t from = 0;
    std::size_t to = 0;
    double weight = 0.0;
  };
  std::vector<std::size_t> hidden;  ///< their activations
  std::vector<LinkGene> links;

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
    for (std::size_t& activation : network.hidden) activation = index(activations);
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
    for (const std::size_t activation : hidden) all.push_back(static_cast<double>(activation));
    for (const LinkGene& link : links)
      all.insert(all.end(), {static_cast<double>(link.from), static_cast<double>(link.to), link.weight});
    return all;
  }

  /// The output for the grid cells of two hinges, within [-1, 1].
  [[nodiscard]] double operator()(const Eigen::Vector3i& first, const Eigen::Vector3i& second) const {
    std::vector<double> value(output() + 1, 0.0);
    value[0] = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      value[1 + static_cast<std::size_t>(axis)] = first[axis];
      value[4 + static_cast<std::size_t>(axis)] = second[axis];
    }
    for (std::size_t node = inputs; node <= output(); ++node) {
      double sum = 0.0;
      for (const LinkGene& link : links) sum += link.to == node ? link.weight * value[link.from] : 0.0;
      value[node] = activate(node == output() ? 0 : hidden[node - inputs], std::clamp(sum, -1e6, 1e6));
    }
    return value[output()];
  }

  /// Replaces a link by a new node with a random activation: weight 1 into it, the old weight out of it. 2 draws.
  void split_link(Rng& rng) {
    if (links.empty() || hidden.size() >= most_hidden) return;
    const LinkGene old = links[rng.index(links.size())];
    const std::size_t activation = rng.index(activations);
    const std::size_t place = old.to;  // the new node comes just before the node that the link led to
    std::erase_if(links, [&](const LinkGene& link) { return link.from == old.from && link.to == old.to; });
    for (LinkGene& link : links) {
      link.from += link.from >= place ? 1U : 0U;
      link.to += link.to >= place ? 1U : 0U;
    }
    hidden.insert(hidden.begin() + static_cast<std::ptrdiff_t>(place - inputs), activation);
    links.push_back({.from = old.from, .to = place, .weight = 1.0});
    links.push_back({.from = place, .to = old.to + 1, .weight = old.weight});
  }

  /// Adds a link between two nodes that none joins, each such pair as probable. 2 draws.
  void add_link(double limit, Rng& rng) {
    std::vector<std::pair<std::size_t, std::size_t>> free;
    for (std::size_t to = inputs; to <= output(); ++to) {
      for (std::size_t from = 0; from < to; ++from) {
        const auto joins = [&](const LinkGene& link) { return link.from == from && link.to == to; };
        if (std::ranges::none_of(links, joins)) free.emplace_back(from, to);
      }
    }
    if (free.empty()) return;
    const auto [from, to] = free[rng.index(free.size())];
    links.push_back({.from = from, .to = to, .weight = rng.uniform(-limit, limit)});
  }

 private:
  [[nodiscard]] static double activate(std::size_t activation, double x) {
    switch (activation) {
      case 0:
        return std::sin(x);
      case 1:
        return std::exp(-x * x);
      case 2:
        return std::tanh(x);
      case 3:
        return x;
      default:
        return std::abs(x);
    }
  }
};

}  // namespace trophic::control::gait::detail
