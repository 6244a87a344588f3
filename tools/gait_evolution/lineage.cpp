// SPDX-License-Identifier: MIT
// Definitions of lineage.hpp.
#include <tools/gait_evolution/lineage.hpp>

#include <algorithm>

namespace trophic::gait_evolution {

std::vector<std::size_t> Lineage::living() const {
  std::vector<std::size_t> ids;
  for (std::size_t id = 0; id < individuals.size(); ++id) {
    if (!individuals[id].died) ids.push_back(id);
  }
  return ids;
}

std::size_t Lineage::champion() const {
  return static_cast<std::size_t>(std::ranges::max_element(individuals, {}, &Individual::fitness) - individuals.begin());
}

}  // namespace trophic::gait_evolution
