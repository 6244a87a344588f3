// SPDX-License-Identifier: MIT
// Definitions of genome.hpp.
#include <tools/gait_evolution/genome.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace trophic::gait_evolution {

namespace {

/// In the order in which they are drawn.
constexpr std::array activations{Activation::sine, Activation::gaussian, Activation::tanh,
                                 Activation::step, Activation::linear,   Activation::abs};

[[nodiscard]] Activation draw_activation(Rng& rng) {
  return activations[rng.index(activations.size())];
}

[[nodiscard]] double draw_weight(const Variation& variation, Rng& rng) {
  return rng.uniform(-variation.initial_weight_limit, variation.initial_weight_limit);
}

[[nodiscard]] auto find_link(std::vector<LinkGene>& links, std::uint32_t from, std::uint32_t to) {
  return std::ranges::find_if(links, [=](const LinkGene& link) { return link.from == from && link.to == to; });
}

void insert(std::vector<LinkGene>& links, const LinkGene& link) {
  links.insert(std::ranges::upper_bound(links, link.innovation, {}, &LinkGene::innovation), link);
}

/// A node and all that its links, disabled ones included, lead to.
[[nodiscard]] std::set<std::uint32_t> reachable_from(const Genome& genome, std::uint32_t node) {
  std::set<std::uint32_t> reached{node};
  std::vector<std::uint32_t> open{node};
  while (!open.empty()) {
    const std::uint32_t from = open.back();
    open.pop_back();
    for (const LinkGene& link : genome.links) {
      if (link.from == from && reached.insert(link.to).second) open.push_back(link.to);
    }
  }
  return reached;
}

}  // namespace

control::Cppn Genome::network() const {
  control::Cppn network;
  std::map<std::uint32_t, std::size_t> place;  // in the network, of each node so far
  for (std::uint32_t input = 0; input < inputs; ++input) place[input] = input;
  const auto is_ready = [&](const NodeGene& node) {
    const auto waits = [&](const LinkGene& link) { return link.to == node.id && !place.contains(link.from); };
    return node.id != output && !place.contains(node.id) && std::ranges::none_of(links, waits);
  };
  for (auto next = std::ranges::find_if(nodes, is_ready); next != nodes.end(); next = std::ranges::find_if(nodes, is_ready)) {
    place[next->id] = network.output();
    network.hidden.push_back(next->activation);
  }
  if (network.hidden.size() + 1 != nodes.size()) throw std::invalid_argument{"genome of a CPPN: its links form a cycle"};
  place[output] = network.output();
  for (const LinkGene& link : links) {
    if (link.enabled) network.links.push_back({.from = place.at(link.from), .to = place.at(link.to), .weight = link.weight});
  }
  return network;
}

Innovations::Innovations() {
  for (std::uint32_t input = 0; input < Genome::inputs; ++input) link(input, Genome::output);
}

std::uint32_t Innovations::link(std::uint32_t from, std::uint32_t to) {
  return links_.try_emplace({from, to}, static_cast<std::uint32_t>(links_.size())).first->second;
}

std::uint32_t Innovations::node(std::uint32_t split_link, const Genome& genome) {
  for (std::uint32_t i = 0; i < splits_.size(); ++i) {
    const std::uint32_t id = Genome::output + 1 + i;
    if (splits_[i] == split_link && !std::ranges::binary_search(genome.nodes, id, {}, &NodeGene::id)) return id;
  }
  splits_.push_back(split_link);
  return Genome::output + static_cast<std::uint32_t>(splits_.size());
}

Genome random_genome(const Variation& variation, Innovations& innovations, Rng& rng) {
  Genome genome{.nodes = {{Genome::output, Activation::sine}}, .links = {}};
  for (std::uint32_t input = 0; input < Genome::inputs; ++input) {
    genome.links.push_back({.innovation = innovations.link(input, Genome::output),
                            .from = input,
                            .to = Genome::output,
                            .weight = draw_weight(variation, rng)});
  }
  return genome;
}

void add_node(Genome& genome, Innovations& innovations, Rng& rng) {
  std::vector<LinkGene*> enabled;
  for (LinkGene& link : genome.links) {
    if (link.enabled) enabled.push_back(&link);
  }
  if (enabled.empty()) return;
  LinkGene& split = *enabled[rng.index(enabled.size())];
  const LinkGene old = split;
  split.enabled = false;
  const NodeGene node{innovations.node(old.innovation, genome), draw_activation(rng)};
  genome.nodes.insert(std::ranges::upper_bound(genome.nodes, node.id, {}, &NodeGene::id), node);
  insert(genome.links, {innovations.link(old.from, node.id), old.from, node.id, 1.0});
  insert(genome.links, {innovations.link(node.id, old.to), node.id, old.to, old.weight});
}

void add_link(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng) {
  std::vector<Innovations::Ends> free;
  for (const NodeGene& to : genome.nodes) {
    const std::set<std::uint32_t> later = reachable_from(genome, to.id);
    const auto offer = [&](std::uint32_t from) {
      const auto known = find_link(genome.links, from, to.id);
      if (!later.contains(from) && (known == genome.links.end() || !known->enabled)) free.emplace_back(from, to.id);
    };
    for (std::uint32_t input = 0; input < Genome::inputs; ++input) offer(input);
    for (const NodeGene& from : genome.nodes) {
      if (from.id != Genome::output) offer(from.id);
    }
  }
  if (free.empty()) return;
  const auto [from, to] = free[rng.index(free.size())];
  const double weight = draw_weight(variation, rng);
  if (const auto known = find_link(genome.links, from, to); known != genome.links.end()) {
    known->weight = weight;
    known->enabled = true;
  } else {
    insert(genome.links, {innovations.link(from, to), from, to, weight});
  }
}

void mutate(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng) {
  for (LinkGene& link : genome.links) {
    if (!rng.chance(variation.weight_mutation_probability)) continue;
    const bool replaced = rng.chance(variation.weight_replacement_probability);
    const double weight =
        replaced ? draw_weight(variation, rng) : link.weight + rng.normal(0.0, variation.weight_standard_deviation);
    link.weight = std::clamp(weight, -variation.weight_limit, variation.weight_limit);
  }
  for (NodeGene& node : genome.nodes) {
    if (node.id == Genome::output || !rng.chance(variation.activation_mutation_probability)) continue;
    node.activation = draw_activation(rng);
  }
  if (rng.chance(variation.add_link_probability)) add_link(genome, variation, innovations, rng);
  if (rng.chance(variation.add_node_probability)) add_node(genome, innovations, rng);
}

Genome crossover(const Genome& fitter, const Genome& other, Rng& rng) {
  Genome child = fitter;
  const auto cross = [&](auto& genes, const auto& others, auto number) {
    for (auto& gene : genes) {
      const auto match = std::ranges::lower_bound(others, gene.*number, {}, number);
      if (match != others.end() && (*match).*number == gene.*number && rng.chance(0.5)) gene = *match;
    }
  };
  cross(child.nodes, other.nodes, &NodeGene::id);
  cross(child.links, other.links, &LinkGene::innovation);
  return child;
}

}  // namespace trophic::gait_evolution
