// SPDX-License-Identifier: MIT
// What a run may change halfway.
#pragma once

#include <string_view>
#include <trophic/observe/run_description.hpp>

namespace trophic::changes {

/// Whether a parameter of a rule has no effect but on founders, so that its change during a run would have none.
[[nodiscard]] constexpr bool acts_at_start(std::string_view path) {
  return path.starts_with("rules.community.") || path.starts_with("rules.placement.") || path == "rules.newborn_tag.founder_tag";
}

/// Throws std::invalid_argument naming the first number in which two runs differ that a run cannot change halfway: all but
/// rules, seed, duration and threads. `branches`: the run begins there, so that rules that act on founders alone cannot change.
void check_may_follow(const observe::RunDescription& origin, const observe::RunDescription& run, bool branches = true);

}  // namespace trophic::changes
