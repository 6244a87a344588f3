// SPDX-License-Identifier: MIT
// One part of the genome is not inherited; this is the shadow of that part.
#pragma once

#include <trophic/reproduction/heredity/contract.hpp>

namespace trophic::reproduction::heredity {

/// The parts of a genome.
enum class Part { brain, gait, body, traits };

/// Rule: the offspring's genome is a copy except for this part, which is drawn anew, as for an individual without a parent. A
/// comparison with OwnCopy measures the effect of inheriting the part. A table that does not inherit the part is refused. Reads:
/// parent's genome.   Random draws: 0.
template <Part part>
struct AllBut {
  static constexpr std::string_view name =
      std::array{"all_but_brain", "all_but_gait", "all_but_body", "all_but_traits"}[static_cast<int>(part)];
  static constexpr std::string_view left_out = name.substr(8);
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const {
    auto genome = std::make_shared<Genome>(*parent);
    constexpr std::array parts{&Genome::weights, &Genome::gait_genes, &Genome::body_genes, &Genome::traits};
    ((*genome).*parts[static_cast<int>(part)]).clear();
    return genome;
  }
};
using AllButBrain = AllBut<Part::brain>;
using AllButGait = AllBut<Part::gait>;
using AllButBody = AllBut<Part::body>;
using AllButTraits = AllBut<Part::traits>;
static_assert(Heredity<AllButBrain>);

}  // namespace trophic::reproduction::heredity
