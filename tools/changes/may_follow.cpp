// SPDX-License-Identifier: MIT
// Definitions of may_follow.hpp.
#include <algorithm>
#include <stdexcept>
#include <tools/changes/may_follow.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic::changes {

void check_acts_later(const NamedParam& param, const std::string& value) {
  const std::string what = param.path + " = " + value + ": ";
  if (!param.no_effect.empty()) throw std::invalid_argument{what + "must be omitted, because it has no effect" + param.no_effect};
  if (param.read == Read::at_start) {
    throw std::invalid_argument{what + "must be given to a new run, with --set " + param.path + "=" + value +
                                ", because a run reads it only at its start"};
  }
}

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
    if (is_there && there->value == param.value) continue;
    if (branches && is_there && param.path.starts_with("rules.")) check_acts_later(param, value_text(param));
    if (may_change(param.path)) continue;
    throw std::invalid_argument{
        param.path + " = " + value_text(param) + ": must be " + (is_there ? value_text(*there) : "missing") +
        ", as in the run from which it starts; only the seed, the duration and parameters of rules can change"};
  }
}

}  // namespace trophic::changes
