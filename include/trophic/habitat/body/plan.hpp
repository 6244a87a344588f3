// SPDX-License-Identifier: MIT
// The representations of a body plan: a tree of modules as plain numbers, for genomes, and as a line of text, for tables.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <trophic/habitat/body/module.hpp>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic::body {

/// The largest number of modules in a plan that is read, so that genomes and files cannot request an unbounded body.
inline constexpr std::size_t most_modules_of_a_plan = 1000;

/// Numbers per module other than the core: index of its parent, face (0 front, 1 back, 2 left, 3 right), type (1 hinge, 2
/// brick), quarter turns (0 to 3).
inline constexpr std::size_t genes_per_module = 4;

/// The same modules in canonical order: depth first, faces in the order of `all_faces`. Two trees of one plan then have the same
/// modules, genes and text.
[[nodiscard]] ModuleTree in_canonical_order(const ModuleTree& tree);

/// The genes of a plan, module by module in canonical order; the core has none. Equal genes are equal plans.
[[nodiscard]] std::vector<double> genes_of(const ModuleTree& tree);

/// The plan of these genes. Throws std::invalid_argument "body gene INDEX = VALUE: must be ..." for a number that `genes_of`
/// cannot produce, a parent that does not come before its child, a face that is missing or taken, a module that overlaps another.
[[nodiscard]] ModuleTree tree_of(std::span<const double> genes);

/// The plan as text in canonical order: each module is FACE:TYPE and its quarter turns, with its children in brackets, as in
/// "core[front:hinge0[front:brick0] left:brick1]".
[[nodiscard]] std::string text_of(const ModuleTree& tree);

/// Reads `text_of`. Throws std::invalid_argument that names the text and the character at which it is not a plan.
[[nodiscard]] ModuleTree read_plan(std::string_view text);

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/plan.ipp>
#endif
