// SPDX-License-Identifier: MIT
// Definitions of innovations.hpp.
#include <tools/gait_evolution/innovations.hpp>

#include <algorithm>

namespace trophic::gait_evolution {

Innovations::Innovations() {
  for (std::uint32_t input = 0; input < Genome::inputs; ++input) link(input, Genome::output);
}

Innovations::Innovations(const std::vector<Ends>& links, std::vector<Split> splits) : splits_{std::move(splits)} {
  for (const auto& [from, to] : links) link(from, to);
}

std::uint32_t Innovations::link(std::uint32_t from, std::uint32_t to) {
  const auto [entry, is_new] = number_of_link_.try_emplace({from, to}, static_cast<std::uint32_t>(links_.size()));
  if (is_new) links_.emplace_back(from, to);
  return entry->second;
}

std::uint32_t Innovations::node(std::uint32_t split_link, const Genome& genome) {
  const auto known =
      std::ranges::find_if(splits_, [&](const Split& split) { return split.link == split_link && !genome.has_node(split.node); });
  if (known != splits_.end()) return known->node;
  splits_.push_back({split_link, Genome::output + 1 + static_cast<std::uint32_t>(splits_.size())});
  return splits_.back().node;
}

}  // namespace trophic::gait_evolution
