// SPDX-License-Identifier: MIT
// Definitions of attempt.hpp.
#pragma once

#include <algorithm>
#include <charconv>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/run/checkpoint/rewind.hpp>
#include <trophic/run/sweep/attempt.hpp>
#include <trophic/run/sweep/claim.hpp>
#include <utility>
#include <vector>

namespace trophic::sweep {

namespace detail {

/// An attempt's folder with its number.
using Numbered = std::pair<std::size_t, std::filesystem::path>;

/// The attempts at a run that have left a folder.
[[nodiscard]] inline std::vector<Numbered> attempts_at(const std::filesystem::path& run) {
  const std::string beginning = run.filename().string() + ".attempt-";
  std::vector<Numbered> attempts;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator{run.parent_path(), error}) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(beginning)) continue;
    std::size_t number = 0;
    const char* end = name.data() + name.size();
    if (std::from_chars(name.data() + beginning.size(), end, number).ptr == end) attempts.emplace_back(number, entry.path());
  }
  return attempts;
}

/// The folder of the next attempt. Where an older one has a checkpoint, it holds a copy of the one that came furthest.
[[nodiscard]] inline std::filesystem::path next_attempt(const std::filesystem::path& run, const std::vector<Numbered>& older) {
  std::size_t number = 0;
  double furthest_s = -1.0;
  std::filesystem::path from;
  for (const auto& [its_number, folder] : older) {
    number = std::max(number, its_number + 1);
    const auto moment_s = checkpoint::last_moment_s(folder);
    if (!moment_s || *moment_s <= furthest_s) continue;
    furthest_s = *moment_s;
    from = folder;
  }
  const std::filesystem::path next = run.string() + ".attempt-" + std::to_string(number);
  if (!from.empty()) checkpoint::copy_until(from, std::numeric_limits<double>::infinity(), next);
  return next;
}

/// Gives a complete attempt the run's name; if another one was faster, its bytes are the same.
inline void publish(const std::filesystem::path& attempt, const std::filesystem::path& run) {
  std::error_code error;
  std::filesystem::rename(attempt, run, error);
  if (error && checkpoint::status_of(run) != "complete") {
    throw std::runtime_error{"cannot rename " + attempt.string() + " to " + run.filename().string() + ": " + error.message()};
  }
}

/// Takes away what attempts at a complete run have left; a program may have been killed before it did.
inline void remove_attempts(const std::filesystem::path& run) {
  std::error_code error;
  for (const auto& [number, folder] : attempts_at(run)) std::filesystem::remove_all(folder, error);
}

}  // namespace detail

TROPHIC_INLINE bool is_complete(const std::filesystem::path& sweep, const PlannedRun& run) {
  return checkpoint::status_of(sweep / run.folder) == "complete";
}

TROPHIC_INLINE Result attempt(const std::filesystem::path& sweep, const PlannedRun& run, double lease_s,
                              const std::function<void(const std::filesystem::path& folder)>& work) {
  const std::filesystem::path folder = sweep / run.folder;
  const auto was_complete = [&] {
    const bool is = is_complete(sweep, run);
    if (is) detail::remove_attempts(folder);
    return is;
  };
  try {
    if (was_complete()) return {Ended::was_complete};
    const auto claim = Claim::take(sweep / claims_name, run.index, lease_s);
    if (!claim) return {Ended::elsewhere, claimant_of(sweep / claims_name, run.index, lease_s)};
    // Between the first look and the claim somebody may have come to the end.
    if (was_complete()) return {Ended::was_complete};
    const std::filesystem::path own = detail::next_attempt(folder, detail::attempts_at(folder));
    work(own);
    const std::string status = checkpoint::status_of(own);
    if (status != "complete") return {status == "stopped" ? Ended::stopped : Ended::failed, "status \"" + status + "\""};
    detail::publish(own, folder);
    detail::remove_attempts(folder);
    return {Ended::complete};
  } catch (const std::exception& error) {
    // One that was faster takes the folders of the others away.
    if (is_complete(sweep, run)) return {Ended::complete};
    return {Ended::failed, error.what()};
  }
}

TROPHIC_INLINE void remove_claims(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan) {
  std::error_code error;
  if (std::ranges::all_of(plan, [&](const PlannedRun& run) { return is_complete(sweep, run); })) {
    std::filesystem::remove_all(sweep / claims_name, error);
  } else {
    std::filesystem::remove(sweep / claims_name, error);
  }
}

}  // namespace trophic::sweep
