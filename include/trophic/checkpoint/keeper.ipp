// SPDX-License-Identifier: MIT
// Definitions of keeper.hpp.
#pragma once

#include <stdexcept>
#include <string>
#include <trophic/checkpoint/keeper.hpp>

namespace trophic::checkpoint {

namespace detail {

inline void same(const std::string& what, const std::string& there, const std::string& ours) {
  if (there == ours) return;
  throw std::invalid_argument{"the checkpoint's " + what + " = " + there + ": must be " + ours +
                              ", as of the run that is to go on"};
}

}  // namespace detail

TROPHIC_INLINE void check_same_rules(const Checkpoint& checkpoint, const observe::RunDescription& run) {
  detail::same("version of trophic", checkpoint.program_version, std::string{version});
  if (checkpoint.fingerprint == run.fingerprint) return;
  throw std::invalid_argument{"the checkpoint's fingerprint = " + checkpoint.fingerprint + ": must be " + run.fingerprint +
                              ", as of the run that is to go on; its rules, numbers, models or engine are others"};
}

TROPHIC_INLINE void check_same_run(const Checkpoint& checkpoint, const observe::RunDescription& run) {
  check_same_rules(checkpoint, run);
  detail::same("seed", std::to_string(checkpoint.seed), std::to_string(run.seed));
}

}  // namespace trophic::checkpoint
