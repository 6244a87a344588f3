// SPDX-License-Identifier: MIT
// A brain whose weights change during a life.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/brain/detail/network.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::control::brain {

namespace detail {

struct VisitsLink {
  void operator()(std::size_t, double, double) const {}
};

}  // namespace detail

/// A brain that lists the links behind its next decision: `for_each_link(inputs, weights, visit)`, with a State also `const
/// State& own` before `visit`.
template <class P>
concept ShowsLinks = requires(const P policy, std::span<const double> numbers, detail::VisitsLink visit) {
  policy.for_each_link(numbers, numbers, visit);
}
|| requires(const P policy, std::span<const double> numbers, const StateOf<P>& own, detail::VisitsLink visit) {
  policy.for_each_link(numbers, numbers, own, visit);
};

/// Rule: the brain `Network` with plastic weights. The genome g holds the weights at birth. After each decision every weight
/// w = g + learnt changes by Oja's rule [oja1982], a Hebbian rule that stays bounded:
///   learnt <- learnt + rate * y * (x - y * w), where x is the neuron before the weight and y the one after it. Learnt changes
///   die with the individual; its offspring inherit the genome unchanged by them.
/// Reads: what the network reads.   Random draws: the network's.
template <class Network>
struct Hebbian {
  static_assert(ShowsLinks<Network>, "brain::Hebbian takes a brain with for_each_link; see trophic/control/brain/hebbian.hpp");
  static constexpr std::string_view name = prefixed_name<"hebbian", Network>;
  static constexpr std::string_view source = "not in the paper; learning by [oja1982]";

  struct Params {
    ParamsOf<Network> network;
    double rate = 0.01;
    static constexpr auto fields() {
      return std::tuple{field("network", &Params::network),
                        field("rate", &Params::rate, between(0.0, 1.0), "learning rate per decision; 0: none")};
    }
  };
  Params params;

  struct State {
    StateOf<Network> network;
    std::vector<double> learnt;  ///< added to each weight of the genome; empty before the first decision
    static constexpr auto fields() { return std::tuple{field("network", &State::network), field("learnt", &State::learnt)}; }
  };
  [[nodiscard]] State born(const Individual& newborn, const State* parent, const State& body) const {
    State own;
    if constexpr (Stateful<Network>) {
      own.network = network().born(newborn, parent != nullptr ? &parent->network : nullptr, body.network);
    }
    return own;
  }

  [[nodiscard]] std::vector<int> tags() const { return network().tags(); }
  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const requires requires(const Network n) {
    n.genome_size(1, 1);
  }
  { return network().genome_size(inputs, outputs); }
  [[nodiscard]] std::vector<std::size_t> neurons(std::size_t inputs, std::size_t outputs) const requires NamesNeurons<Network> {
    return network().neurons(inputs, outputs);
  }

  [[nodiscard]] std::vector<double> first(std::size_t inputs, std::size_t outputs,
                                          Rng& rng) const requires control::GrowingBrain<Network> {
    return network().first(inputs, outputs, rng);
  }
  [[nodiscard]] bool fits(std::span<const double> genes, std::size_t inputs,
                          std::size_t outputs) const requires control::GrowingBrain<Network> {
    return network().fits(genes, inputs, outputs);
  }
  [[nodiscard]] std::span<double> weights_of(std::span<double> genes) const requires control::GrowingBrain<Network> {
    return network().weights_of(genes);
  }
  void mutate_structure(std::vector<double>& genes, std::size_t inputs, std::size_t outputs,
                        Rng& rng) const requires control::GrowingBrain<Network> {
    network().mutate_structure(genes, inputs, outputs, rng);
  }

  [[nodiscard]] double distance(std::span<const double> a, std::span<const double> b) const requires requires(const Network n) {
    n.distance(a, b);
  }
  { return network().distance(a, b); }

  /// The outputs before this decision's learning.
  void evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs, State& own) const {
    own.learnt.resize(weights.size(), 0.0);
    const std::vector<double> sum = learnt_weights(weights, own);
    const auto learn = [&](std::size_t weight, double before, double after) {
      own.learnt[weight] += detail::oja_step(params.rate, before, after, sum[weight]);
    };
    if constexpr (Stateful<Network>) {
      network().for_each_link(inputs, sum, std::as_const(own.network), learn);
    } else {
      network().for_each_link(inputs, sum, learn);
    }
    ask::evaluate(network(), own.network, inputs, sum, outputs);
  }
  [[nodiscard]] double target_angle_rad(double output) const requires requires(const Network n) { n.target_angle_rad(1.0); }
  { return network().target_angle_rad(output); }

 private:
  [[nodiscard]] Network network() const { return Network{params.network}; }

  [[nodiscard]] static std::vector<double> learnt_weights(std::span<const double> weights, const State& own) {
    std::vector<double> sum(weights.begin(), weights.end());
    for (std::size_t i = 0; i < own.learnt.size(); ++i) sum[i] += own.learnt[i];
    return sum;
  }
};

}  // namespace trophic::control::brain
