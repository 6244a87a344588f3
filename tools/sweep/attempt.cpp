// SPDX-License-Identifier: MIT
// Definitions of attempt.hpp.
#include <algorithm>
#include <charconv>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tools/replicates/rewind.hpp>
#include <tools/sweep/attempt.hpp>
#include <tools/sweep/claim.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/no_links.hpp>
#include <trophic/support/unreadable_file.hpp>
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
    const auto read = std::from_chars(name.data() + beginning.size(), end, number);
    if (read.ptr != end || read.ec != std::errc{} || number == std::numeric_limits<std::size_t>::max()) continue;
    check_no_link(entry.path());
    attempts.emplace_back(number, entry.path());
  }
  return attempts;
}

/// The folder of an attempt, and that of the older one of which it is a copy; empty if it begins anew.
struct Next {
  std::filesystem::path folder;
  std::filesystem::path from;
};

/// The next attempt. If older ones have a checkpoint, it is a copy of the one that came furthest.
[[nodiscard]] inline Next next_attempt(const std::filesystem::path& run, const std::vector<Numbered>& older) {
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
  return {next, from};
}

/// Throws std::invalid_argument if a folder on the way from a sweep to its run is a link.
inline void check_way(const std::filesystem::path& sweep, const std::filesystem::path& run) {
  std::filesystem::path at = sweep;
  for (const auto& part : run) check_no_link(at /= part);
}

/// Throws std::invalid_argument if a run's folder holds anything: it is made whole.
inline void check_free(const std::filesystem::path& run) {
  if (!std::filesystem::exists(std::filesystem::symlink_status(run)) || std::filesystem::is_empty(run)) return;
  throw std::invalid_argument{run.string() + ": holds something else than the complete run that was planned: move it away"};
}

/// Does the work in the folder of an attempt. If what an older attempt left there is damaged, it is set aside.
inline void do_work(const Next& next, const std::function<void(const std::filesystem::path& folder)>& work) {
  try {
    work(next.folder);
  } catch (const DamagedFile& error) {
    if (next.from.empty()) throw;
    std::filesystem::remove_all(next.folder);
    throw DamagedFile{std::string{error.what()} + "; kept as " + checkpoint::rename_incomplete(next.from).string() +
                      ", the next attempt begins without it"};
  }
}

/// Gives a complete attempt the run's name; if another one was faster, its bytes are the same.
inline void publish(const std::filesystem::path& attempt, const std::filesystem::path& run) {
  std::error_code error;
  std::filesystem::rename(attempt, run, error);
  if (error && checkpoint::status_of(run) != "complete") {
    throw std::runtime_error{"cannot rename " + attempt.string() + " to " + run.filename().string() + ": " + error.message()};
  }
}

/// Removes the files of attempts at a complete run; a program may have been killed before it did.
inline void remove_attempts(const std::filesystem::path& run) {
  std::error_code error;
  for (const auto& [number, folder] : attempts_at(run)) std::filesystem::remove_all(folder, error);
}

}  // namespace detail

bool is_complete(const std::filesystem::path& sweep, const PlannedRun& run) {
  return checkpoint::holds_complete(sweep / run.folder, run.fingerprint, run.seed, run.until_s);
}

Result attempt(const std::filesystem::path& sweep, const PlannedRun& run, double lease_s,
               const std::function<void(const std::filesystem::path& folder)>& work) {
  const std::filesystem::path folder = sweep / run.folder;
  const auto was_complete = [&] {
    const bool is = is_complete(sweep, run);
    if (is) detail::remove_attempts(folder);
    return is;
  };
  try {
    detail::check_way(sweep, run.folder);
    if (was_complete()) return {Ended::was_complete};
    detail::check_free(folder);
    const auto claim = Claim::take(sweep / claims_name, run.index, lease_s);
    if (!claim) return {Ended::elsewhere, claimant_of(sweep / claims_name, run.index, lease_s)};
    // Between the first look and the claim another program may have completed it.
    if (was_complete()) return {Ended::was_complete};
    const detail::Next next = detail::next_attempt(folder, detail::attempts_at(folder));
    detail::do_work(next, work);
    const std::string status = checkpoint::status_of(next.folder);
    if (status != "complete") return {status == "stopped" ? Ended::stopped : Ended::failed, "status \"" + status + "\""};
    detail::publish(next.folder, folder);
    detail::remove_attempts(folder);
    return {Ended::complete};
  } catch (const std::exception& error) {
    const std::string why = error.what();
    try {
      // A faster one removes the folders of the others.
      if (is_complete(sweep, run)) return {Ended::complete};
    } catch (const UnreadableFile&) {  // the first reason is reported
    }
    return {Ended::failed, why};
  }
}

void check_builds(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan) {
  std::vector<std::filesystem::path> complete;
  for (const PlannedRun& run : plan) {
    if (is_complete(sweep, run)) complete.push_back(sweep / run.folder);
  }
  if (complete.size() == plan.size()) return;
  for (const std::filesystem::path& folder : complete) checkpoint::check_build(folder);
}

void remove_claims(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan) {
  std::error_code error;
  if (std::ranges::all_of(plan, [&](const PlannedRun& run) { return is_complete(sweep, run); })) {
    std::filesystem::remove_all(sweep / claims_name, error);
  } else {
    std::filesystem::remove(sweep / claims_name, error);
  }
}

}  // namespace trophic::sweep
