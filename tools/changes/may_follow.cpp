// SPDX-License-Identifier: MIT
// Definitions of may_follow.hpp.
#include <algorithm>
#include <stdexcept>
#include <tools/changes/may_follow.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic::changes {

void check_may_follow(const observe::RunDescription& origin, const observe::RunDescription& run, bool branches) {
  const auto may_change = [](const std::string& path) {
    return path == "seed" || path.starts_with("rules.") || path == "ecology.duration_s" || path == "backend.threads";
  };
  if (origin.backend != run.backend) {
    throw std::invalid_argument{"engine " + run.backend + ": must be " + origin.backend + ", as in the run from which it starts"};
  }
  for (const NamedParam& param : run.named_params) {
    const auto there = std::ranges::find(origin.named_params, param.path, &NamedParam::path);
    const bool is_there = there != origin.named_params.end();
    if (may_change(param.path) && !(branches && is_there && acts_at_start(param.path))) continue;
    if (is_there && there->value == param.value) continue;
    throw std::invalid_argument{
        param.path + " = " + value_text(param) + ": must be " + (is_there ? value_text(*there) : "missing") +
        ", as in the run from which it starts; only the seed, the duration and rules that act after the start can change"};
  }
}

}  // namespace trophic::changes
