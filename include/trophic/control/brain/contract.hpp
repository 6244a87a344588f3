// SPDX-License-Identifier: MIT
// The contract of a slot: a robot's decision from its inputs.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Brain                                                                                          \
  "std::size_t genome_size(std::size_t inputs, std::size_t outputs) const, std::vector<int> tags() const and Decision " \
  "decide(std::span<const double> inputs, std::span<const double> weights) const (with a State also State& own); see "  \
  "trophic/control/brain/contract.hpp"

namespace trophic::control {

/// A brain's decision at a tick.
struct Decision {
  static constexpr std::size_t outputs = 2;  ///< outputs of a network for one decision: target angle and tag

  double target_angle_rad = 0.0;  ///< positive to the right
  int tag = 0;                    ///< one of the brain's tags
  friend bool operator==(const Decision&, const Decision&) = default;
};

/// A brain whose number of genes may change. `first(inputs, outputs, rng)`: returns the genes of an individual without a parent,
/// with any weights. `weights_of(genes)`: returns those genes that are weights, which InitialGenome draws and Mutation changes.
/// `mutate_structure(genes, inputs, outputs, rng)`: changes the structure of an inherited genome after Mutation. `fits(genes,
/// inputs, outputs)`: returns whether `decide` takes these genes. Optional: `double distance(std::span<const double> a,
/// std::span<const double> b) const`, for mutation_distance; without it missing genes count as 0.
template <class P>
concept GrowingBrain = requires(const P policy, std::size_t inputs, std::vector<double>& genes, std::span<const double> fixed,
                                std::span<double> open, Rng& rng) {
  { policy.first(inputs, Decision::outputs, rng) } -> std::same_as<std::vector<double>>;
  { policy.weights_of(open) } -> std::same_as<std::span<double>>;
  { policy.mutate_structure(genes, inputs, Decision::outputs, rng) } -> std::same_as<void>;
  { policy.fits(fixed, inputs, Decision::outputs) } -> std::same_as<bool>;
};

/// A brain with the same number of weights in every individual.
template <class P>
concept BrainOfOneSize = requires(const P policy, std::size_t inputs) {
  { policy.genome_size(inputs, Decision::outputs) } -> std::same_as<std::size_t>;
};

/// `genome_size(inputs, outputs)`: returns the number of weights for this number of inputs, which the table's sensors give, and
/// of outputs (`Decision::outputs`). `tags()`: returns every tag that the brain may choose. `decide(inputs, weights)`: a pure
/// function of both and, with a State, of `own`, which it may change; called at most once in a tick. The weights are the
/// genome's, which only births change. Instead of `genome_size` a brain may have the functions of a GrowingBrain. A brain that
/// shows its output neurons to observers has `std::array<double,
/// Decision::outputs> outputs(inputs, weights) const` (with a State also `const State& own`): the outputs behind decide's
/// decision. A brain for one number of inputs only declares it: `static constexpr std::size_t inputs = 3;`.
template <class P>
concept Brain = (BrainOfOneSize<P> || GrowingBrain<P>)&&requires(const P policy) {
  { policy.tags() } -> std::same_as<std::vector<int>>;
}
&&(
    requires(const P policy, std::span<const double> inputs, std::span<const double> weights) {
      { policy.decide(inputs, weights) } -> std::same_as<Decision>;
    } ||
    requires(const P policy, std::span<const double> inputs, std::span<const double> weights, StateOf<P> own) {
      { policy.decide(inputs, weights, own) } -> std::same_as<Decision>;
    });

namespace ask {

/// The genes of an individual without a parent, with any weights. `structure` is for brains that grow, as in all that follows.
template <class P>
[[nodiscard]] std::vector<double> first_genes(const P& policy, std::size_t inputs, [[maybe_unused]] Rng& structure) {
  if constexpr (GrowingBrain<P>) {
    return policy.first(inputs, Decision::outputs, structure);
  } else {
    return std::vector<double>(policy.genome_size(inputs, Decision::outputs));
  }
}

template <class P>
[[nodiscard]] std::span<double> weights_of([[maybe_unused]] const P& policy, std::span<double> genes) {
  if constexpr (GrowingBrain<P>) return policy.weights_of(genes);
  return genes;
}

template <class P>
void mutate_structure([[maybe_unused]] const P& policy, [[maybe_unused]] std::vector<double>& genes,
                      [[maybe_unused]] std::size_t inputs, [[maybe_unused]] Rng& structure) {
  if constexpr (GrowingBrain<P>) policy.mutate_structure(genes, inputs, Decision::outputs, structure);
}

/// Whether a brain takes these genes.
template <class P>
[[nodiscard]] bool fits(const P& policy, std::span<const double> genes, std::size_t inputs) {
  if constexpr (GrowingBrain<P>) {
    return policy.fits(genes, inputs, Decision::outputs);
  } else {
    return genes.size() == policy.genome_size(inputs, Decision::outputs);
  }
}

/// A brain's demand on a genome, for error messages: "a genome of 15 weights".
template <class P>
[[nodiscard]] std::string demand([[maybe_unused]] const P& policy, [[maybe_unused]] std::size_t inputs) {
  if constexpr (GrowingBrain<P>) {
    return "a genome that fits the brain " + std::string{P::name};
  } else {
    return "a genome of " + std::to_string(policy.genome_size(inputs, Decision::outputs)) + " weights";
  }
}

/// The distance between the genes of a parent and of its offspring. Missing genes count as 0.
template <class P>
[[nodiscard]] double distance([[maybe_unused]] const P& policy, std::span<const double> parents, std::span<const double> own) {
  if constexpr (requires { policy.distance(parents, own); }) {
    return policy.distance(parents, own);
  } else {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::max(parents.size(), own.size()); ++i) {
      const double step = (i < own.size() ? own[i] : 0.0) - (i < parents.size() ? parents[i] : 0.0);
      sum += step * step;
    }
    return std::sqrt(sum);
  }
}

template <class P>
[[nodiscard]] Decision decide(const P& policy, [[maybe_unused]] StateOf<P>& own, std::span<const double> inputs,
                              std::span<const double> weights) {
  if constexpr (requires { policy.decide(inputs, weights, own); }) {
    return policy.decide(inputs, weights, own);
  } else {
    return policy.decide(inputs, weights);
  }
}

/// None for a brain that does not show its output neurons.
template <class P>
[[nodiscard]] std::optional<std::array<double, Decision::outputs>> outputs(const P& policy,
                                                                           [[maybe_unused]] const StateOf<P>& own,
                                                                           std::span<const double> inputs,
                                                                           std::span<const double> weights) {
  if constexpr (requires { policy.outputs(inputs, weights, own); }) {
    return policy.outputs(inputs, weights, own);
  } else if constexpr (requires { policy.outputs(inputs, weights); }) {
    return policy.outputs(inputs, weights);
  } else {
    return std::nullopt;
  }
}

}  // namespace ask

namespace detail {

/// The compiler's message contains `given` and `taken`.
template <std::size_t given, std::size_t taken>
concept SameInputs = given == taken;

/// A brain that does not declare a number of inputs takes any.
template <class P, std::size_t given>
inline constexpr std::size_t inputs_taken = given;
template <class P, std::size_t given>
requires requires {
  typename std::integral_constant<std::size_t, P::inputs>;
}
inline constexpr std::size_t inputs_taken<P, given> = P::inputs;

}  // namespace detail

}  // namespace trophic::control
