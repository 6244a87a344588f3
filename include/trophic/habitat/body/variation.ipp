// SPDX-License-Identifier: MIT
// Definitions of variation.hpp.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <vector>

namespace trophic::body {

namespace detail {

[[nodiscard]] inline Face left_right(Face face) {
  if (face == Face::left) return Face::right;
  return face == Face::right ? Face::left : face;
}

/// A subtree that is moved to a place.
struct Graft {
  std::size_t at = 0;                 ///< the module that it replaces, with everything attached to that module
  std::optional<std::size_t> module;  ///< the root of the subtree; if empty, the place stays empty
  std::optional<int> image_turns;     ///< if set, the mirror image is attached, with these quarter turns of the root
};

/// Attaches a copy of a subtree. Throws std::invalid_argument if the grid forbids it.
inline void attach_copy(const ModuleTree& from, const Graft& graft, ModuleTree& to, std::size_t parent, Face face) {
  const std::size_t root = graft.module.value();
  const bool is_mirrored = graft.image_turns.has_value();
  const int turns = graft.image_turns.value_or(from.modules()[root].quarter_turns);
  const std::size_t added = to.attach(parent, face, from.modules()[root].type, turns);
  for (const Face side : all_faces) {
    const auto child = from.child(root, side);
    if (!child) continue;
    const auto image_turns = is_mirrored ? std::optional{-from.modules()[*child].quarter_turns} : std::nullopt;
    attach_copy(from, {.module = child, .image_turns = image_turns}, to, added, is_mirrored ? left_right(side) : side);
  }
}

inline void copy_with(const ModuleTree& tree, std::size_t module, std::span<const Graft> grafts, ModuleTree& to,
                      std::size_t parent) {
  for (const Face face : all_faces) {
    const auto child = tree.child(module, face);
    if (!child) continue;
    const auto graft_here = std::ranges::find(grafts, *child, &Graft::at);
    if (graft_here == grafts.end()) {
      const Module& made = tree.modules()[*child];
      copy_with(tree, *child, grafts, to, to.attach(parent, face, made.type, made.quarter_turns));
    } else if (graft_here->module) {
      attach_copy(tree, *graft_here, to, parent, face);
    }
  }
}

/// Returns `tree` with these grafts; empty if the grid forbids it.
[[nodiscard]] inline std::optional<ModuleTree> with_grafts(const ModuleTree& tree, std::span<const Graft> grafts) {
  try {
    ModuleTree result;
    copy_with(tree, 0, grafts, result, 0);
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Returns `tree` with a copy of a subtree at a free face; empty if the grid forbids it.
[[nodiscard]] inline std::optional<ModuleTree> with_copy(const ModuleTree& tree, const Graft& graft, std::size_t parent,
                                                         Face face) {
  try {
    ModuleTree result = tree;
    attach_copy(tree, graft, result, parent, face);
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Returns `tree` with a different type or orientation of one module; empty if the grid forbids it.
[[nodiscard]] inline std::optional<ModuleTree> with_module(const ModuleTree& tree, std::size_t changed, ModuleType type,
                                                           int quarter_turns) {
  try {
    ModuleTree result;
    for (std::size_t i = 1; i < tree.modules().size(); ++i) {
      const Module& made = tree.modules()[i];
      (void)result.attach(*made.parent, made.face, i == changed ? type : made.type,
                          i == changed ? quarter_turns : made.quarter_turns);
    }
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Returns one of the trees or, without a draw, `tree` itself if there are none.
[[nodiscard]] inline ModuleTree one_of(std::vector<ModuleTree>& possible, const ModuleTree& tree, Rng& rng) {
  return possible.empty() ? tree : std::move(possible[rng.index(possible.size())]);
}

struct Place {
  std::size_t parent = 0;
  Face face = Face::front;
};

/// Calls `visit(parent, face)` for each face without a module.
template <class Visit>
void for_each_free_face(const ModuleTree& tree, const Visit& visit) {
  for (std::size_t parent = 0; parent < tree.modules().size(); ++parent) {
    for (const Face face : all_faces) {
      if (has_face(tree.modules()[parent].type, face) && !tree.child(parent, face)) visit(parent, face);
    }
  }
}

[[nodiscard]] inline bool contains(const ModuleTree& tree, std::size_t subtree, std::size_t module) {
  while (module > subtree) module = tree.modules()[module].parent.value();
  return module == subtree;
}

[[nodiscard]] inline bool is_leaf(const Module& module) {
  return module.parent && std::ranges::none_of(module.children, [](const auto& child) { return child.has_value(); });
}

[[nodiscard]] inline ModuleTree add(const ModuleTree& tree, Rng& rng) {
  std::vector<Place> places;
  for_each_free_face(tree, [&](std::size_t parent, Face face) {
    const Module& on = tree.modules()[parent];
    const Eigen::Vector3i cell = on.cell + on.orientation * face_rotation(face).col(0);
    if (std::ranges::none_of(tree.modules(), [&](const Module& other) { return other.cell == cell; }))
      places.push_back({parent, face});
  });
  if (places.empty()) return tree;
  const Place place = places[rng.index(places.size())];
  const ModuleType type = rng.index(2) == 0 ? ModuleType::hinge : ModuleType::brick;
  const auto quarter_turns = static_cast<int>(rng.index(4));
  ModuleTree result = tree;
  (void)result.attach(place.parent, place.face, type, quarter_turns);
  return result;
}

[[nodiscard]] inline ModuleTree without_one(const ModuleTree& tree, bool only_leaves, Rng& rng) {
  std::vector<std::size_t> modules;
  for (std::size_t i = 1; i < tree.modules().size(); ++i) {
    if (!only_leaves || is_leaf(tree.modules()[i])) modules.push_back(i);
  }
  if (modules.empty()) return tree;
  return with_grafts(tree, std::array{Graft{.at = modules[rng.index(modules.size())], .module = {}, .image_turns = {}}}).value();
}

[[nodiscard]] inline ModuleTree copy(const ModuleTree& tree, Rng& rng) {
  if (tree.modules().size() == 1) return tree;
  const std::size_t copied = 1 + rng.index(tree.modules().size() - 1);
  std::vector<ModuleTree> possible;
  for_each_free_face(tree, [&](std::size_t parent, Face face) {
    if (auto result = with_copy(tree, {.at = 0, .module = copied, .image_turns = {}}, parent, face))
      possible.push_back(std::move(*result));
  });
  return one_of(possible, tree, rng);
}

/// The reflection in the upright plane through the core along `forward_deg`, to the nearest 45 degrees.
[[nodiscard]] inline Eigen::Matrix3i reflection(double forward_deg) {
  constexpr std::array<int, 4> cosine{1, 0, -1, 0};
  const auto quarters = static_cast<int>(std::lround(forward_deg / 45.0));  // twice the angle, in quarter turns
  const int c = cosine.at(static_cast<std::size_t>(quarters & 3));
  const int s = cosine.at(static_cast<std::size_t>((quarters + 3) & 3));
  return (Eigen::Matrix3i() << c, s, 0, s, -c, 0, 0, 0, 1).finished();
}

/// Returns `tree` with the mirror image of a subtree at its mirrored place; empty if there is no face, or if the image is the
/// subtree itself.
[[nodiscard]] inline std::optional<ModuleTree> with_image(const ModuleTree& tree, std::size_t module,
                                                          const Eigen::Matrix3i& mirror) {
  const Module& made = tree.modules()[module];
  const Eigen::Vector3i outwards = mirror * made.orientation.col(0);
  const auto parent = std::ranges::find(tree.modules(), Eigen::Vector3i{mirror * made.cell - outwards}, &Module::cell);
  if (parent == tree.modules().end()) return std::nullopt;
  for (const Face face : all_faces) {
    const Eigen::Matrix3i towards = parent->orientation * face_rotation(face);
    if (!has_face(parent->type, face) || towards.col(0) != outwards) continue;
    const auto at = static_cast<std::size_t>(parent - tree.modules().begin());
    const auto there = tree.child(at, face);
    if (there == module) return std::nullopt;
    const Eigen::Matrix3i roll = towards.transpose() * mirror * made.orientation * Eigen::Vector3i{1, -1, 1}.asDiagonal();
    int quarter_turns = 0;
    while (roll_rotation(quarter_turns) != roll) ++quarter_turns;
    const Graft image{.at = there.value_or(0), .module = module, .image_turns = quarter_turns};
    return there ? with_grafts(tree, std::array{image}) : with_copy(tree, image, at, face);
  }
  return std::nullopt;
}

[[nodiscard]] inline ModuleTree mirror(const ModuleTree& tree, double forward_deg, Rng& rng) {
  std::vector<ModuleTree> possible;
  for (std::size_t module = 1; module < tree.modules().size(); ++module) {
    auto result = with_image(tree, module, reflection(forward_deg));
    if (result && text_of(*result) != text_of(tree)) possible.push_back(std::move(*result));
  }
  return one_of(possible, tree, rng);
}

[[nodiscard]] inline ModuleTree swap(const ModuleTree& tree, Rng& rng) {
  if (tree.modules().size() == 1) return tree;
  const std::size_t one = 1 + rng.index(tree.modules().size() - 1);
  std::vector<ModuleTree> possible;
  for (std::size_t other = 1; other < tree.modules().size(); ++other) {
    if (contains(tree, one, other) || contains(tree, other, one)) continue;
    auto result = with_grafts(tree, std::array{Graft{.at = one, .module = other, .image_turns = {}},
                                               Graft{.at = other, .module = one, .image_turns = {}}});
    if (result && text_of(*result) != text_of(tree)) possible.push_back(std::move(*result));
  }
  return one_of(possible, tree, rng);
}

[[nodiscard]] inline ModuleTree turn(const ModuleTree& tree, Rng& rng) {
  std::vector<ModuleTree> possible;
  for (std::size_t module = 1; module < tree.modules().size(); ++module) {
    const Module& made = tree.modules()[module];
    for (int by = 1; by < 4; ++by) {
      if (auto result = with_module(tree, module, made.type, made.quarter_turns + by)) possible.push_back(std::move(*result));
    }
  }
  return one_of(possible, tree, rng);
}

[[nodiscard]] inline ModuleTree change(const ModuleTree& tree, Rng& rng) {
  std::vector<ModuleTree> possible;
  for (std::size_t module = 1; module < tree.modules().size(); ++module) {
    const Module& made = tree.modules()[module];
    const ModuleType type = made.type == ModuleType::hinge ? ModuleType::brick : ModuleType::hinge;
    if (auto result = with_module(tree, module, type, made.quarter_turns)) possible.push_back(std::move(*result));
  }
  return one_of(possible, tree, rng);
}

}  // namespace detail

TROPHIC_INLINE ModuleTree changed(const ModuleTree& given, TreeOperator how, double forward_deg, Rng& rng) {
  const ModuleTree tree = in_canonical_order(given);
  switch (how) {
    case TreeOperator::add:
      return in_canonical_order(detail::add(tree, rng));
    case TreeOperator::remove:
      return in_canonical_order(detail::without_one(tree, true, rng));
    case TreeOperator::cut:
      return in_canonical_order(detail::without_one(tree, false, rng));
    case TreeOperator::copy:
      return in_canonical_order(detail::copy(tree, rng));
    case TreeOperator::mirror:
      return in_canonical_order(detail::mirror(tree, forward_deg, rng));
    case TreeOperator::swap:
      return in_canonical_order(detail::swap(tree, rng));
    case TreeOperator::turn:
      return in_canonical_order(detail::turn(tree, rng));
    case TreeOperator::change:
      return in_canonical_order(detail::change(tree, rng));
  }
  return tree;
}

TROPHIC_INLINE ModuleTree mutated(const ModuleTree& tree, const TreeMutation& probabilities, double forward_deg, Rng& rng) {
  ModuleTree result = in_canonical_order(tree);
  std::size_t how = 0;
  for_each_field(probabilities, [&](const auto&, const double& probability) {
    if (rng.chance(probability)) result = changed(result, static_cast<TreeOperator>(how), forward_deg, rng);
    ++how;
  });
  return result;
}

TROPHIC_INLINE ModuleTree random_tree(std::size_t modules, Rng& rng) {
  ModuleTree tree;
  while (tree.modules().size() < modules) {
    const std::size_t before = tree.modules().size();
    tree = changed(tree, TreeOperator::add, 0.0, rng);
    if (tree.modules().size() == before) break;
  }
  return tree;
}

}  // namespace trophic::body
