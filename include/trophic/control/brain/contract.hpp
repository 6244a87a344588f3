// SPDX-License-Identifier: MIT
// The contract of a slot: a robot's decision from its inputs.
#pragma once

#include <trophic/control/acts/list.hpp>
#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Brain                                                                                              \
  "std::size_t genome_size(std::size_t inputs, std::size_t outputs) const, std::vector<int> tags() const and void "         \
  "evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs) const or Decision " \
  "decide(std::span<const double> inputs, std::span<const double> weights) const (with a State also State& own); see "      \
  "trophic/control/brain/contract.hpp"

namespace trophic::control {

/// The acts of the paper that a brain chooses at a tick.
struct Decision {
  double target_angle_rad = 0.0;  ///< positive to the right
  int tag = 0;                    ///< one of the brain's tags
  friend bool operator==(const Decision&, const Decision&) = default;
};

/// The number of a brain's inputs, from the table's sensors, and of its outputs, for the table's acts.
struct BrainShape {
  std::size_t inputs = 0;
  std::size_t outputs = acts::TurnAndTag::outputs;
};

/// A brain whose number of genes may change. `first(inputs, outputs, rng)`: returns the genes of an individual without a parent,
/// with arbitrary weights. `weights_of(genes)`: returns the genes that are weights, which InitialGenome draws and Mutation
/// changes; all others are the structure, which must be equal in the parents for a crossover to mix them.
/// `mutate_structure(genes, inputs, outputs, rng)`: changes the structure of an inherited genome after Mutation. `fits(genes,
/// inputs, outputs)`: returns whether the genes are valid for this brain. Optional: `double distance(std::span<const double> a,
/// std::span<const double> b) const`, for mutation_distance; without it missing genes count as 0.
template <class P>
concept GrowingBrain = requires(const P policy, std::size_t size, std::vector<double>& genes, std::span<const double> fixed,
                                std::span<double> open, Rng& rng) {
  { policy.first(size, size, rng) } -> std::same_as<std::vector<double>>;
  { policy.weights_of(open) } -> std::same_as<std::span<double>>;
  { policy.mutate_structure(genes, size, size, rng) } -> std::same_as<void>;
  { policy.fits(fixed, size, size) } -> std::same_as<bool>;
};

/// A brain with the same number of weights in every individual.
template <class P>
concept BrainOfOneSize = requires(const P policy, std::size_t size) {
  { policy.genome_size(size, size) } -> std::same_as<std::size_t>;
};

/// A brain that returns for each of its weights the index of the neuron that the weight enters or whose bias it is.
template <class P>
concept NamesNeurons = requires(const P policy, std::size_t size) {
  { policy.neurons(size, size) } -> std::same_as<std::vector<std::size_t>>;
};

/// A brain with output neurons.
template <class P>
concept EvaluatesOutputs = requires(const P policy, std::span<const double> numbers, std::span<double> outputs) {
  { policy.evaluate(numbers, numbers, outputs) } -> std::same_as<void>;
}
|| requires(const P policy, std::span<const double> numbers, std::span<double> outputs, StateOf<P> own) {
  { policy.evaluate(numbers, numbers, outputs, own) } -> std::same_as<void>;
};

/// A brain without a State that evaluates many individuals in one call, such as a network that uses SIMD.
template <class P>
concept EvaluatesAll =
    EvaluatesOutputs<P> && !Stateful<P> && requires(const P policy, std::span<const double> inputs,
                                                    std::span<const std::span<const double>> genomes, std::span<double> outputs) {
  { policy.evaluate_all(inputs, genomes, outputs) } -> std::same_as<void>;
};

/// A brain whose decisions come from outside the ecology: brain/outside.hpp.
template <class P>
concept IsOutside = requires {
  requires P::is_outside;
};

/// A brain that turns and chooses a tag without output neurons.
template <class P>
concept Decides = requires(const P policy, std::span<const double> numbers) {
  { policy.decide(numbers, numbers) } -> std::same_as<Decision>;
}
|| requires(const P policy, std::span<const double> numbers, StateOf<P> own) {
  { policy.decide(numbers, numbers, own) } -> std::same_as<Decision>;
};

/// `genome_size(inputs, outputs)`: returns the number of weights for these numbers of inputs, from the table's sensors, and of
/// outputs, for its acts. `tags()`: returns every tag that the brain may choose. `evaluate(inputs, weights, outputs)`: sets the
/// outputs, in the order of the table's acts, which convert them to values. It is a pure function of inputs and weights and, with
/// a State, of `own`, which it may change; it is called at most once per tick. The weights are the genome's, which change only at
/// births. Optional: `target_angle_rad(output)` and `tag(output)`, which interpret the outputs of the acts Turn and Tag
/// (control/acts/). Optional, without a State: `evaluate_all(inputs, genomes, outputs)`, which does the same for all individuals
/// of a species at a tick: `genomes` has a span of weights for each; `inputs` and `outputs` hold one individual's numbers after
/// another's. It must set exactly the outputs that `evaluate` sets.
///
/// Instead of `evaluate`, a brain that only turns and chooses a tag may have `Decision decide(inputs, weights)`; the table's acts
/// are then those of the paper. Instead of `genome_size` it may have the functions of a GrowingBrain. A brain for only one number
/// of inputs declares it: `static constexpr std::size_t inputs = 3;`.
template <class P>
concept Brain = (BrainOfOneSize<P> || GrowingBrain<P>)&&requires(const P policy) {
  { policy.tags() } -> std::same_as<std::vector<int>>;
}
&&(EvaluatesOutputs<P> || Decides<P>);

namespace ask {

/// Returns the genes of an individual without a parent, with arbitrary weights. `structure` is for brains that grow, here and
/// below.
template <class P>
[[nodiscard]] std::vector<double> first_genes(const P& policy, const BrainShape& shape, [[maybe_unused]] Rng& structure) {
  if constexpr (GrowingBrain<P>) {
    return policy.first(shape.inputs, shape.outputs, structure);
  } else {
    return std::vector<double>(policy.genome_size(shape.inputs, shape.outputs));
  }
}

template <class P>
[[nodiscard]] std::span<double> weights_of([[maybe_unused]] const P& policy, std::span<double> genes) {
  if constexpr (GrowingBrain<P>) return policy.weights_of(genes);
  return genes;
}

/// Returns the indices of the genes that are not weights.
template <class P>
[[nodiscard]] std::vector<std::size_t> weight_structure([[maybe_unused]] const P& policy,
                                                        [[maybe_unused]] std::vector<double> genes) {
  std::vector<std::size_t> indices;
  if constexpr (GrowingBrain<P>) {
    const std::span<const double> weights = policy.weights_of(genes);
    for (std::size_t gene = 0; gene < genes.size(); ++gene) {
      const double* const at = &genes[gene];
      if (std::less<>{}(at, weights.data()) || !std::less<>{}(at, weights.data() + weights.size())) indices.push_back(gene);
    }
  }
  return indices;
}

template <class P>
void mutate_structure([[maybe_unused]] const P& policy, [[maybe_unused]] std::vector<double>& genes,
                      [[maybe_unused]] const BrainShape& shape, [[maybe_unused]] Rng& structure) {
  if constexpr (GrowingBrain<P>) policy.mutate_structure(genes, shape.inputs, shape.outputs, structure);
}

/// Returns whether these genes are valid for a brain.
template <class P>
[[nodiscard]] bool fits(const P& policy, std::span<const double> genes, const BrainShape& shape) {
  if constexpr (GrowingBrain<P>) {
    return policy.fits(genes, shape.inputs, shape.outputs);
  } else {
    return genes.size() == policy.genome_size(shape.inputs, shape.outputs);
  }
}

/// Returns a brain's requirement on a genome, for error messages: "a genome of 15 weights".
template <class P>
[[nodiscard]] std::string demand([[maybe_unused]] const P& policy, [[maybe_unused]] const BrainShape& shape) {
  if constexpr (GrowingBrain<P>) {
    return "a genome that fits the brain " + std::string{P::name};
  } else {
    return "a genome of " + std::to_string(policy.genome_size(shape.inputs, shape.outputs)) + " weights";
  }
}

/// Returns the distance between the genes of a parent and of its offspring. Missing genes count as 0.
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

/// Sets the outputs of a brain that has output neurons.
template <class P>
void evaluate(const P& policy, [[maybe_unused]] StateOf<P>& own, std::span<const double> inputs, std::span<const double> weights,
              std::span<double> outputs) {
  if constexpr (requires { policy.evaluate(inputs, weights, outputs, own); }) {
    policy.evaluate(inputs, weights, outputs, own);
  } else {
    policy.evaluate(inputs, weights, outputs);
  }
}

/// Sets the outputs of a brain; those of one without output neurons are its target angle, rad, and its tag.
template <class P>
void answer(const P& policy, [[maybe_unused]] StateOf<P>& own, std::span<const double> inputs, std::span<const double> weights,
            std::span<double> outputs) {
  if constexpr (EvaluatesOutputs<P>) {
    evaluate(policy, own, inputs, weights, outputs);
  } else {
    const auto decision = [&] {
      if constexpr (requires { policy.decide(inputs, weights, own); }) {
        return policy.decide(inputs, weights, own);
      } else {
        return policy.decide(inputs, weights);
      }
    }();
    outputs[0] = decision.target_angle_rad;
    outputs[1] = decision.tag;
  }
}

/// Returns the decision that outputs of a brain stand for in a table with these acts. Parts of the decision without an act are
/// copied from `before`.
template <class Acts, class P>
[[nodiscard]] Decision decision_of(const P& policy, std::span<const double, Acts::outputs> outputs, const Decision& before = {}) {
  Decision decision = before;
  if constexpr (EvaluatesOutputs<P>) {
    Acts::each(outputs, [&]<class One>(std::size_t, std::span<const double, One::outputs> out) {
      if constexpr (std::same_as<One, acts::Turn>) {
        if constexpr (requires { policy.target_angle_rad(out[0]); }) {
          decision.target_angle_rad = policy.target_angle_rad(out[0]);
        } else {
          decision.target_angle_rad = acts::Turn::value(out);
        }
      } else if constexpr (std::same_as<One, acts::Tag>) {
        if constexpr (requires { policy.tag(out[0]); }) {
          decision.tag = policy.tag(out[0]);
        } else {
          decision.tag = acts::Tag::value(out);
        }
      }
    });
  } else {
    decision = {.target_angle_rad = outputs[0], .tag = static_cast<int>(outputs[1])};
  }
  return decision;
}

/// Returns the decision of a brain in a table with these acts, and its outputs.
template <class Acts, class P>
[[nodiscard]] Decision decide(const P& policy, StateOf<P>& own, std::span<const double> inputs, std::span<const double> weights,
                              std::span<double, Acts::outputs> outputs, const Decision& before = {}) {
  answer(policy, own, inputs, weights, outputs);
  return decision_of<Acts>(policy, std::span<const double, Acts::outputs>{outputs}, before);
}

/// Returns the decision of a brain in a table with the paper's acts.
template <class P>
[[nodiscard]] Decision decide(const P& policy, StateOf<P>& own, std::span<const double> inputs, std::span<const double> weights) {
  std::array<double, acts::TurnAndTag::outputs> outputs{};
  return decide<acts::TurnAndTag>(policy, own, inputs, weights, std::span{outputs});
}

}  // namespace ask

namespace detail {

/// The compiler's message contains `given` and `taken`.
template <std::size_t given, std::size_t taken>
concept SameInputs = given == taken;

/// A brain that does not declare a number of inputs accepts any number.
template <class P, std::size_t given>
inline constexpr std::size_t inputs_taken = given;
template <class P, std::size_t given>
requires requires {
  typename std::integral_constant<std::size_t, P::inputs>;
}
inline constexpr std::size_t inputs_taken<P, given> = P::inputs;

}  // namespace detail

}  // namespace trophic::control
