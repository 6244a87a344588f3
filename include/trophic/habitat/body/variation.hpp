// SPDX-License-Identifier: MIT
// Random changes of a tree of modules: its mutation operators, and a random tree.
#pragma once

#include <trophic/habitat/body/module.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::body {

/// The operators, in the order in which a mutation applies them. No operator makes a tree that the grid forbids: each chooses
/// with equal probability among the possible changes; if there are none, it does nothing and draws nothing.
///   add      a new leaf: free face, then type, then quarter turns          3 draws
///   remove   a leaf                                                        1 draw
///   cut      a module with all that it carries                             1 draw
///   copy     a module with all that it carries, to a free face             1 draw, and 1 if there is a place
///   mirror   the mirror image of a module with all that it carries
///            replaces what is at the mirrored place                        1 draw
///   swap     two subtrees of which none contains the other change places   1 draw, and 1 if there is a partner
///   turn     a module, with all that it carries, by 1 to 3 quarter turns   1 draw
///   change   a hinge to a brick, or a brick without side branches to a hinge    1 draw
enum class TreeOperator { add, remove, cut, copy, mirror, swap, turn, change };
[[nodiscard]] constexpr std::array<std::string_view, 8> enum_names(TreeOperator) {
  return {"add", "remove", "cut", "copy", "mirror", "swap", "turn", "change"};
}

/// The probability of each operator at a birth; with the defaults, about half of the newborns have their parent's plan. The
/// operators are those for directed graphs of parts [sims1994], applied to a tree.
struct TreeMutation {
  double add = 0.15;
  double remove = 0.15;
  double cut = 0.03;
  double copy = 0.05;
  double mirror = 0.05;
  double swap = 0.05;
  double turn = 0.10;
  double change = 0.10;

  static constexpr auto fields() {
    return std::tuple{field("add", &TreeMutation::add, between(0.0, 1.0), "probability of a new leaf"),
                      field("remove", &TreeMutation::remove, between(0.0, 1.0), "probability of losing a leaf"),
                      field("cut", &TreeMutation::cut, between(0.0, 1.0), "probability of losing a subtree"),
                      field("copy", &TreeMutation::copy, between(0.0, 1.0), "probability that a subtree is copied"),
                      field("mirror", &TreeMutation::mirror, between(0.0, 1.0), "probability that a subtree is mirrored"),
                      field("swap", &TreeMutation::swap, between(0.0, 1.0), "probability that two subtrees are swapped"),
                      field("turn", &TreeMutation::turn, between(0.0, 1.0), "probability that a subtree is rotated"),
                      field("change", &TreeMutation::change, between(0.0, 1.0), "probability that a module changes type")};
  }

  /// The probabilities, multiplied by a factor in [0, 1].
  [[nodiscard]] TreeMutation times(double factor) const {
    TreeMutation result = *this;
    for_each_field(result, [&](const auto&, double& probability) { probability *= factor; });
    return result;
  }
};

/// Returns the tree changed by one operator, in canonical order. The mirror is the upright plane through the core along
/// `forward_deg`, to the nearest 45 degrees. Draws: see TreeOperator.
[[nodiscard]] ModuleTree changed(const ModuleTree& tree, TreeOperator how, double forward_deg, Rng& rng);

/// Returns the tree after each operator in turn, with its probability, in canonical order. Draws: 1 per operator, plus those of
/// the operators that act.
[[nodiscard]] ModuleTree mutated(const ModuleTree& tree, const TreeMutation& probabilities, double forward_deg, Rng& rng);

/// Returns a core to which leaves are added until the tree has `modules`, or no face is free. Draws: 3 per module except the
/// core.
[[nodiscard]] ModuleTree random_tree(std::size_t modules, Rng& rng);

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/variation.ipp>
#endif
