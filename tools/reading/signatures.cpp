// SPDX-License-Identifier: MIT
// Definitions of signatures.hpp.
#include <tools/reading/signatures.hpp>

namespace trophic::analysis {

namespace {

int side_of(const control::Decision& decision) {
  return (decision.target_angle_rad > 0.0 ? 1 : 0) - (decision.target_angle_rad < 0.0 ? 1 : 0);
}

}  // namespace

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
    const control::Decision decision = decide_(species, inputs, weights);
    decisions += static_cast<char>('b' + side_of(decision));
    decisions += std::to_string(decision.tag);
  }
  return types_.try_emplace(std::move(decisions), static_cast<Type>(types_.size())).first->second;
}

std::size_t Signatures::complexity(Species species, std::span<const double> weights) const {
  const std::vector<Inputs>& met = inputs_.at(species);
  if (met.empty()) return 0;
  std::vector<std::array<bool, 2>> depends(met.front().size());
  for (const Inputs& inputs : met) {
    const control::Decision before = decide_(species, inputs, weights);
    Inputs changed = inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (const Inputs& end : extremes_.at(species)) {
        if (depends[i][0] && depends[i][1]) break;
        changed[i] = end[i];
        const control::Decision after = decide_(species, changed, weights);
        depends[i][0] = depends[i][0] || side_of(before) != side_of(after);
        depends[i][1] = depends[i][1] || before.tag != after.tag;
      }
      changed[i] = inputs[i];
    }
  }
  std::size_t pairs = 0;
  for (const auto& [side, tag] : depends) pairs += (side ? 1U : 0U) + (tag ? 1U : 0U);
  return pairs;
}

}  // namespace trophic::analysis
