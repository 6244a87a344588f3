// SPDX-License-Identifier: MIT
// Definitions of resume.hpp.
#pragma once

#include <system_error>
#include <trophic/io/program_code.hpp>
#include <trophic/run/checkpoint/manifest_in.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/no_links.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/unreadable_file.hpp>
#include <trophic/support/version.hpp>
#include <trophic/support/whole_file.hpp>
#include <trophic/support/without_slash.hpp>

namespace trophic::checkpoint {

namespace detail {

/// Returns the files that a manifest lists and its folder lacks; empty if it has all of them.
[[nodiscard]] inline std::string missing_in(const std::filesystem::path& folder, const Json& manifest) {
  const auto tables = manifest.find("tables");
  if (tables == manifest.end() || !tables->is_object() || tables->empty()) return "a list of its tables";
  for (const auto& [name, sum] : tables->items()) {
    const auto status = std::filesystem::symlink_status(folder / name);
    if (std::filesystem::path{name}.has_parent_path() || !std::filesystem::is_regular_file(status)) return name;
  }
  return "";
}

/// Throws std::invalid_argument unless a manifest is of this run and its folder has the tables that it lists.
inline void check_manifest(const std::filesystem::path& folder, const Json& manifest, const observe::RunDescription& run) {
  const auto check = [&](const char* key, const Json& ours) {
    const auto there = manifest.find(key);
    if (there != manifest.end() && *there == ours) return;
    throw std::invalid_argument{(folder / "manifest.json").string() + ": " + key + " = " +
                                (there == manifest.end() ? "nothing" : json_text(*there)) + ": must be " + json_text(ours) +
                                ", as of the run that is to be resumed"};
  };
  check("fingerprint", run.fingerprint);
  check("seed", run.seed);
  if (const std::string missing = missing_in(folder, manifest); !missing.empty()) {
    throw std::invalid_argument{folder.string() + ": its manifest says that it is complete, but it lacks " + missing};
  }
}

/// The last checkpoint of this version that is whole, or why there is none. Throws UnreadableFile.
[[nodiscard]] inline std::pair<std::optional<Checkpoint>, std::string> last_in(const std::filesystem::path& folder) {
  if (!checkpoint::exists(folder)) return {std::nullopt, "it has no checkpoint"};
  try {
    Checkpoint last = read_last(folder);
    if (last.program_version != version) return {std::nullopt, "its checkpoint is of trophic " + last.program_version};
    return {std::move(last), ""};
  } catch (const UnreadableFile&) {
    throw;
  } catch (const std::invalid_argument& error) {
    return {std::nullopt, error.what()};
  }
}

}  // namespace detail

TROPHIC_INLINE std::string status_of(const std::filesystem::path& folder) {
  std::error_code unknown;
  if (!std::filesystem::exists(folder, unknown) && !unknown) return "missing";
  return detail::status_in(detail::manifest_in(folder));
}

TROPHIC_INLINE bool holds_complete(const std::filesystem::path& folder, const std::string& fingerprint, std::uint64_t seed,
                                   double until_s) {
  if (!std::filesystem::is_directory(std::filesystem::symlink_status(folder))) return false;
  const Json manifest = detail::manifest_in(folder);
  const auto is = [&](const char* key, const Json& ours) {
    const auto there = manifest.find(key);
    return there != manifest.end() && *there == ours;
  };
  return detail::status_in(manifest) == "complete" && is("fingerprint", fingerprint) && is("seed", seed) &&
         detail::until_in(manifest) == until_s && detail::missing_in(folder, manifest).empty();
}

TROPHIC_INLINE std::filesystem::path rename_incomplete(const std::filesystem::path& folder) {
  const std::filesystem::path from = without_slash(folder);
  std::filesystem::path aside;
  std::size_t k = 1;
  do {
    aside = from.string() + ".incomplete-" + std::to_string(k++);
  } while (std::filesystem::exists(std::filesystem::symlink_status(aside)));
  std::filesystem::rename(from, aside);
  return aside;
}

TROPHIC_INLINE std::vector<std::string> builds_of(const std::filesystem::path& folder) {
  const Json manifest = detail::manifest_in(folder);
  std::vector<std::string> builds;
  const auto add = [&](const Json& of) {
    if (of.is_object() && of.contains("code") && of["code"].is_string()) builds.push_back(of["code"].get<std::string>());
  };
  add(manifest);
  if (!manifest.is_null()) {
    for (const Json& one : manifest.value("continued", Json::array())) add(one);
  }
  std::ranges::sort(builds);
  builds.erase(std::unique(builds.begin(), builds.end()), builds.end());
  return builds;
}

TROPHIC_INLINE void check_build(const std::filesystem::path& folder) {
  const std::vector<std::string> builds = builds_of(folder);
  if (builds.size() == 1 && builds.front() == program_code()) return;
  const std::string theirs = builds.empty() ? "unknown" : builds.front() == program_code() ? builds.back() : builds.front();
  throw std::invalid_argument{(folder / "manifest.json").string() + ": code = " + theirs + ": must be " + program_code() +
                              ", as of this program; another build made it, whose rules may be others (--accept-other-build "
                              "takes it)"};
}

TROPHIC_INLINE RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run,
                                     OtherBuild other_build) {
  if (!std::filesystem::exists(folder)) return {};
  const FolderLock alone{folder};
  check_no_links_in(folder);
  const Json manifest = detail::manifest_in(folder);
  const std::string status = detail::status_in(manifest);
  const double until_s = detail::until_in(manifest);
  if (detail::is_complete(manifest, run.until_s)) {
    detail::check_manifest(folder, manifest, run);
    return {.complete = true, .from = {}, .remark = "is complete already, to " + number_text(until_s) + " s"};
  }
  auto [last, why] = detail::last_in(folder);
  if (last) {
    const bool is_other = last->code != program_code() && other_build == OtherBuild::accepted;
    if (is_other) last->code = program_code();
    try {
      check_same_run(*last, run);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{folder.string() + ": " + error.what()};
    }
    // A run ends with the first tick at or after its end, by the same arithmetic.
    const double before_s = clock_s(last->tick - 1, run.tick_s);
    if (last->tick > 0 && before_s >= run.until_s) {
      throw std::invalid_argument{"until_s = " + number_text(run.until_s) + ": must be > " + number_text(before_s) +
                                  ", which the run in " + folder.string() + " has passed"};
    }
    std::string remark = "continues from its checkpoint at " + number_text(last->time_s) + " s" +
                         (is_other ? ", which another build of this program wrote" : "");
    return {.complete = false, .from = std::move(last), .remark = std::move(remark)};
  }
  if (status == "complete") {
    throw std::invalid_argument{folder.string() + ": is complete to " + number_text(until_s) +
                                " s and cannot be resumed: " + why};
  }
  return {.complete = false,
          .from = {},
          .remark = "was incomplete (status \"" + status + "\"; " + why + "): kept as " +
                    rename_incomplete(folder).filename().string() + ", run anew"};
}

}  // namespace trophic::checkpoint
