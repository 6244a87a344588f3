// SPDX-License-Identifier: MIT
// Inheritance that a parameter switches off.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::heredity {

/// Rule: like `Rule`, or no genome is passed on. With `by_species` one side evolves against another that does not:
/// `with_heredity<Paper, by_species<Switched<OwnCopy>>>` and `rules.heredity.prey.inherited=false`.   Not in the paper.
/// Reads: what Rule reads.   Random draws: those of Rule; if off, only those of the initial genome.
template <Heredity Rule>
struct Switched {
  static constexpr std::string_view name = prefixed_name<"switched", Rule>;
  static constexpr std::string_view source = "control";
  struct Params {
    bool inherited = true;
    static constexpr auto fields() {
      return std::tuple{field("inherited", &Params::inherited, "false: every genome is drawn anew, as in the neutral shadow")};
    }
  };
  Params params;

  static constexpr bool mixes_neurons = MixesNeurons<Rule>;

  [[nodiscard]] std::shared_ptr<Genome> inherit(std::span<const Ancestor> parents, Rng& rng,
                                                const GenomeStructure& structure) const {
    return params.inherited ? ask::inherit(Rule{}, parents, rng, structure) : nullptr;
  }
};

}  // namespace trophic::reproduction::heredity
