// SPDX-License-Identifier: MIT
// Tag symmetry: whether two species show opposite tags, and what tags without any meaning would give.
#pragma once

#include <tools/analysis/metrics/series.hpp>
#include <tools/reading/tables.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::analysis {

/// E|mean of `a` fair coins + mean of `b` fair coins|, coins showing -1 or +1: the tag symmetry that populations of these numbers
/// have if each robot tosses a coin. Exact for up to 1000 coins in all. Beyond that the mean of the more is taken as normal, and
/// of the fewer, too, from 250 on: sqrt(2 (1/a + 1/b) / pi). The relative error is then below 1e-3. Both must be > 0.
[[nodiscard]] double bernoulli_symmetry(std::size_t a, std::size_t b);

/// The paper's baseline: the mean of |u + v| over `pairs` pairs of numbers uniform in [-1, 1) (2/3 in the limit). Two draws per
/// pair. It stands for two infinitely large species whose mean tags can be anything, not for 30 robots.
[[nodiscard]] double uniform_pair_symmetry(Rng& rng, std::size_t pairs = 100'000);

/// E|mean tag of `a` robots + mean tag of `b` robots| if `plus` tags of +1 and the others of -1 are dealt out among all of them:
/// exact, by the hypergeometric distribution. It keeps what all robots have in common, such as a bias to one tag. a and b must be
/// > 0.
[[nodiscard]] double permuted_symmetry(std::size_t a, std::size_t b, std::size_t plus);

/// Tag symmetry of two species over a run, and what the same ticks would give with tags that say nothing about the species.
struct TagSymmetry {
  WindowMean observed;
  WindowMean permuted;        ///< the null: the tags alive at the tick dealt out between the species
  WindowMean bernoulli_tags;  ///< for reference: every robot's tag a fair coin
};

/// At each tick |mean tag of one species + mean tag of the other|, members of the group only: the inherited ones (Sec. "Metrics
/// for system dynamics"); ticks at which either species has no such member are left out. Close to 0: the species show opposite
/// tags. The mean of the tags (-1, 1, 1, 1) is 0.5; the paper's example of an average tag gives 0.75 for it, which is wrong.
[[nodiscard]] TagSymmetry tag_symmetry(Agents agents, Species a, Species b, Group group = Group::inherited,
                                       double window_s = 200.0);

}  // namespace trophic::analysis
