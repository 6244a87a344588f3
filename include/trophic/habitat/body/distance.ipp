// SPDX-License-Identifier: MIT
// Definitions of distance.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/habitat/body/distance.hpp>
#include <tuple>
#include <vector>

namespace trophic::body {

namespace detail {

/// A tree in postorder, as the algorithm of Zhang and Shasha numbers it.
struct Postorder {
  using Label = std::tuple<ModuleType, Face, int>;
  std::vector<Label> labels;
  std::vector<std::size_t> leftmost;  ///< for each module: the first leaf of its subtree
  std::vector<std::size_t> keyroots;  ///< the root, and each module with a sibling before it, ascending

  explicit Postorder(const ModuleTree& tree) {
    walk(tree, 0);
    for (std::size_t i = 0; i < leftmost.size(); ++i) {
      if (std::ranges::find(leftmost.begin() + static_cast<std::ptrdiff_t>(i) + 1, leftmost.end(), leftmost[i]) == leftmost.end())
        keyroots.push_back(i);
    }
  }

 private:
  /// Returns the first leaf of the subtree.
  std::size_t walk(const ModuleTree& tree, std::size_t module) {
    std::size_t first = labels.size();
    bool is_first = true;
    for (const Face face : all_faces) {
      const auto child = tree.child(module, face);
      if (!child) continue;
      const std::size_t leaf = walk(tree, *child);
      if (is_first) first = leaf;
      is_first = false;
    }
    const Module& made = tree.modules()[module];
    labels.emplace_back(made.type, made.face, made.quarter_turns);
    leftmost.push_back(first);
    return first;
  }
};

}  // namespace detail

TROPHIC_INLINE std::size_t edit_distance(const ModuleTree& first, const ModuleTree& second) {
  const detail::Postorder a{first};
  const detail::Postorder b{second};
  const std::size_t columns = b.labels.size() + 1;
  std::vector<std::size_t> trees(a.labels.size() * b.labels.size());  // distance of the subtrees of i and j
  std::vector<std::size_t> forests((a.labels.size() + 1) *
                                   columns);  // distance of the parts that precede i and j in the current subtrees
  for (const std::size_t root_a : a.keyroots) {
    for (const std::size_t root_b : b.keyroots) {
      const std::size_t from_a = a.leftmost[root_a];
      const std::size_t from_b = b.leftmost[root_b];
      const auto forest = [&](std::size_t end_a, std::size_t end_b) -> std::size_t& {
        return forests[(end_a - from_a) * columns + (end_b - from_b)];
      };
      forest(from_a, from_b) = 0;
      for (std::size_t i = from_a; i <= root_a; ++i) forest(i + 1, from_b) = forest(i, from_b) + 1;
      for (std::size_t j = from_b; j <= root_b; ++j) forest(from_a, j + 1) = forest(from_a, j) + 1;
      for (std::size_t i = from_a; i <= root_a; ++i) {
        for (std::size_t j = from_b; j <= root_b; ++j) {
          const std::size_t less = std::min(forest(i, j + 1), forest(i + 1, j)) + 1;
          std::size_t& tree = trees[i * b.labels.size() + j];
          if (a.leftmost[i] == from_a && b.leftmost[j] == from_b) {
            tree = std::min(less, forest(i, j) + (a.labels[i] == b.labels[j] ? 0 : 1));
            forest(i + 1, j + 1) = tree;
          } else {
            forest(i + 1, j + 1) = std::min(less, forest(a.leftmost[i], b.leftmost[j]) + tree);
          }
        }
      }
    }
  }
  return trees.back();
}

TROPHIC_INLINE double shannon_number(std::span<const std::size_t> individuals) {
  double all = 0.0;
  for (const std::size_t members : individuals) all += static_cast<double>(members);
  if (all == 0.0) return 0.0;
  double entropy = 0.0;
  for (const std::size_t members : individuals) {
    if (members == 0) continue;
    const double share = static_cast<double>(members) / all;
    entropy -= share * std::log(share);
  }
  return std::exp(entropy);
}

}  // namespace trophic::body
