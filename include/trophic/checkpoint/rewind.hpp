// SPDX-License-Identifier: MIT
// Rewinding the tape: a new run that begins at a moment of an old one, with another seed or other rules.
#pragma once

#include <filesystem>
#include <optional>
#include <trophic/checkpoint/checkpoint_file.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::checkpoint {

/// When a run's last checkpoint was taken, seconds of its clock; none without one.
[[nodiscard]] std::optional<double> last_moment_s(const std::filesystem::path& run);

/// Makes `folder` a copy of a run's folder as far as its latest checkpoint at or before `at_s`, which another run can go on from.
/// Does nothing if there is none: then that other run begins at its beginning. Throws std::invalid_argument if `folder` exists,
/// std::runtime_error if a file cannot be copied.
void copy_until(const std::filesystem::path& run, double at_s, const std::filesystem::path& folder);

/// Throws std::invalid_argument naming the first number in which two runs differ that a run cannot change on its way: all but
/// rules, seed, duration and threads.
void check_may_follow(const observe::RunDescription& origin, const observe::RunDescription& run);

}  // namespace trophic::checkpoint

#if TROPHIC_HEADER_ONLY
#include <trophic/checkpoint/rewind.ipp>
#endif
