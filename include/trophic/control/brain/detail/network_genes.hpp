// SPDX-License-Identifier: MIT
// Networks of any shape as genes: the number of hidden neurons, the start and end of each link, and the weight of each link.
#pragma once

#include <algorithm>
#include <limits>
#include <trophic/support/rng.hpp>
#include <vector>

namespace trophic::control::brain::detail {

struct Link {
  std::size_t from = 0;  ///< neurons in the order inputs, hidden, outputs
  std::size_t to = 0;    ///< later than `from`
  double weight = 0.0;

  /// The order in which neurons are computed.
  [[nodiscard]] friend bool operator<(const Link& a, const Link& b) { return std::pair{a.to, a.from} < std::pair{b.to, b.from}; }
};

/// The links of a network after `added` neurons are inserted before neuron `place`.
[[nodiscard]] inline std::vector<Link> widened_links(std::span<const double> genes, std::size_t place, std::size_t added) {
  const std::size_t count = genes.size() / 3;
  const auto end = [&](std::size_t gene) {
    const auto neuron = static_cast<std::size_t>(genes[gene]);
    return neuron < place ? neuron : neuron + added;
  };
  std::vector<Link> links;
  for (std::size_t i = 0; i < count; ++i) {
    links.push_back({.from = end(1 + 2 * i), .to = end(2 + 2 * i), .weight = genes[1 + 2 * count + i]});
  }
  return links;
}

/// An unpacked network and its mutations. No two neurons are linked twice.
class Network {
 public:
  /// `genes` must satisfy `are_network`.
  Network(std::span<const double> genes, std::size_t inputs, std::size_t outputs)
      : inputs_{inputs}, hidden_{static_cast<std::size_t>(genes[0])}, outputs_{outputs}, links_{widened_links(genes, 0, 0)} {}

  [[nodiscard]] std::size_t hidden() const { return hidden_; }

  [[nodiscard]] std::vector<double> genes() const {
    std::vector<double> genes{static_cast<double>(hidden_)};
    for (const Link& link : links_) {
      genes.push_back(static_cast<double>(link.from));
      genes.push_back(static_cast<double>(link.to));
    }
    for (const Link& link : links_) genes.push_back(link.weight);
    return genes;
  }

  void add_link(double weight_sd, Rng& rng) {
    std::vector<Link> possible;
    for (std::size_t to = inputs_; to < inputs_ + hidden_ + outputs_; ++to) {
      for (std::size_t from = 0; from < std::min(to, inputs_ + hidden_); ++from) {
        const Link link{.from = from, .to = to};
        if (!std::ranges::binary_search(links_, link, std::less{})) possible.push_back(link);
      }
    }
    if (possible.empty()) return;
    Link added = possible[rng.index(possible.size())];
    added.weight = rng.normal(0.0, weight_sd);
    links_.insert(std::ranges::upper_bound(links_, added, std::less{}), added);
  }

  void remove_link(Rng& rng) {
    if (links_.empty()) return;
    links_.erase(links_.begin() + static_cast<std::ptrdiff_t>(rng.index(links_.size())));
  }

  /// The new neuron is placed right before the end of the link or, if that is an output, as the last hidden neuron.
  void split_link(Rng& rng) {
    if (links_.empty()) return;
    const std::size_t split = rng.index(links_.size());
    const std::size_t neuron = std::min(links_[split].to, inputs_ + hidden_);
    for (Link& link : links_) {
      if (link.from >= neuron) ++link.from;
      if (link.to >= neuron) ++link.to;
    }
    ++hidden_;
    const Link old = links_[split];
    links_[split] = {.from = old.from, .to = neuron, .weight = 1.0};
    links_.push_back({.from = neuron, .to = old.to, .weight = old.weight});
    std::ranges::sort(links_, std::less{});
  }

  void remove_neuron(Rng& rng) {
    if (hidden_ == 0) return;
    const std::size_t neuron = inputs_ + rng.index(hidden_);
    std::erase_if(links_, [&](const Link& link) { return link.from == neuron || link.to == neuron; });
    for (Link& link : links_) {
      if (link.from > neuron) --link.from;
      if (link.to > neuron) --link.to;
    }
    --hidden_;
  }

 private:
  std::size_t inputs_;
  std::size_t hidden_;
  std::size_t outputs_;
  std::vector<Link> links_;
};

/// Returns whether genes are a network: whole numbers are in range, links ascend, and weights are finite.
[[nodiscard]] inline bool are_network(std::span<const double> genes, std::size_t inputs, std::size_t outputs,
                                      std::size_t most_hidden) {
  const auto whole_below = [](double gene, std::size_t end) {
    return gene >= 0.0 && gene < static_cast<double>(end) && gene == std::floor(gene);
  };
  if (genes.size() % 3 != 1 || !whole_below(genes[0], most_hidden + 1)) return false;
  const std::size_t links = genes.size() / 3;
  const std::size_t before_outputs = inputs + static_cast<std::size_t>(genes[0]);
  Link last;
  for (std::size_t i = 0; i < links; ++i) {
    if (!whole_below(genes[1 + 2 * i], before_outputs) || !whole_below(genes[2 + 2 * i], before_outputs + outputs)) return false;
    const Link link{.from = static_cast<std::size_t>(genes[1 + 2 * i]), .to = static_cast<std::size_t>(genes[2 + 2 * i])};
    if (link.to < inputs || link.from >= link.to || (i > 0 && !(last < link))) return false;
    last = link;
  }
  return std::ranges::all_of(genes.last(links), [](double weight) { return std::isfinite(weight); });
}

/// Returns the Euclidean distance between the weights of two networks with ascending links. A missing link counts as weight 0.
/// Neurons are matched in order; missing neurons are inserted next to each other at the place that gives the smallest distance.
[[nodiscard]] inline double network_distance(std::span<const double> fewer, std::span<const double> more) {
  if (fewer[0] > more[0]) std::swap(fewer, more);
  const auto added = static_cast<std::size_t>(more[0] - fewer[0]);
  const std::vector<Link> others = widened_links(more, 0, 0);
  std::size_t last = 0;
  for (const Link& link : others) last = std::max(last, link.to);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t place = 0; place <= (added == 0 ? 0 : last); ++place) {
    const std::vector<Link> links = widened_links(fewer, place, added);
    double sum = 0.0;
    auto other = others.begin();
    for (const Link& link : links) {
      for (; other != others.end() && *other < link; ++other) sum += other->weight * other->weight;
      const bool is_in_both = other != others.end() && !(link < *other);
      const double step = link.weight - (is_in_both ? (other++)->weight : 0.0);
      sum += step * step;
    }
    for (; other != others.end(); ++other) sum += other->weight * other->weight;
    least = std::min(least, sum);
  }
  return std::sqrt(least);
}

/// Returns one layer of hidden neurons, or none, with all links and all weights 0.
[[nodiscard]] inline std::vector<double> layered_genes(std::size_t inputs, std::size_t hidden, std::size_t outputs) {
  std::vector<double> genes{static_cast<double>(hidden)};
  const auto link_all = [&](std::size_t from, std::size_t from_end, std::size_t to, std::size_t to_end) {
    for (; to < to_end; ++to) {
      for (std::size_t start = from; start < from_end; ++start) {
        genes.push_back(static_cast<double>(start));
        genes.push_back(static_cast<double>(to));
      }
    }
  };
  const std::size_t end = inputs + hidden;
  link_all(0, inputs, inputs, end);
  link_all(hidden == 0 ? 0 : inputs, end, end, end + outputs);
  genes.resize(genes.size() + (genes.size() - 1) / 2, 0.0);
  return genes;
}

/// Returns the values of all neurons in order, given the inputs.
[[nodiscard]] inline std::vector<double> network_neurons(std::span<const double> inputs, std::span<const double> genes,
                                                         std::size_t outputs) {
  std::vector<double> neurons(inputs.begin(), inputs.end());
  neurons.resize(inputs.size() + static_cast<std::size_t>(genes[0]) + outputs, 0.0);
  const std::size_t links = genes.size() / 3;
  std::size_t link = 0;
  for (std::size_t to = inputs.size(); to < neurons.size(); ++to) {
    double sum = 0.0;
    for (; link < links && static_cast<std::size_t>(genes[2 + 2 * link]) == to; ++link) {
      sum += genes[1 + 2 * links + link] * neurons[static_cast<std::size_t>(genes[1 + 2 * link])];
    }
    neurons[to] = std::tanh(sum);
  }
  return neurons;
}

}  // namespace trophic::control::brain::detail
