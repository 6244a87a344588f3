// SPDX-License-Identifier: MIT
// Definitions of signatures.hpp.
#include <set>
#include <tools/reading/signatures.hpp>

namespace trophic::analysis {

Signatures::Signatures(Decide decide, std::vector<std::vector<Inputs>> inputs)
    : decide_{std::move(decide)}, inputs_{std::move(inputs)} {
  for (const std::vector<Inputs>& met : inputs_) {
    std::vector<Inputs> ends;
    for (const Inputs& one : met) {
      if (ends.empty()) ends.assign(2, one);
      for (std::size_t i = 0; i < one.size(); ++i) {
        ends[0][i] = std::min(ends[0][i], one[i]);
        ends[1][i] = std::max(ends[1][i], one[i]);
      }
    }
    extremes_.push_back(std::move(ends));
  }
}

Type Signatures::type_of(Species species, std::span<const double> weights) {
  std::string decisions = std::to_string(species) + ":";
  for (const Inputs& inputs : inputs_.at(species)) {
    for (const int choice : decide_(species, inputs, weights)) decisions += std::to_string(choice) + ',';
  }
  return types_.try_emplace(std::move(decisions), static_cast<Type>(types_.size())).first->second;
}

std::size_t Signatures::complexity(Species species, std::span<const double> weights) const {
  const std::vector<Inputs>& met = inputs_.at(species);
  if (met.empty()) return 0;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const Inputs& inputs : met) {
    const std::vector<int> before = decide_(species, inputs, weights);
    Inputs changed = inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (const Inputs& end : extremes_.at(species)) {
        changed[i] = end[i];
        const std::vector<int> after = decide_(species, changed, weights);
        for (std::size_t act = 0; act < before.size(); ++act) {
          if (before[act] != after[act]) pairs.emplace(i, act);
        }
      }
      changed[i] = inputs[i];
    }
  }
  return pairs.size();
}

}  // namespace trophic::analysis
