// SPDX-License-Identifier: MIT
// Definitions of go_on.hpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <trophic/params/params.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/version.hpp>
#include <trophic/support/whole_file.hpp>
#include <trophic/support/without_slash.hpp>
#include <utility>

namespace trophic::checkpoint {

namespace detail {

/// manifest.json; null if it cannot be read.
[[nodiscard]] inline Json manifest_in(const std::filesystem::path& folder) {
  try {
    auto manifest = parse_json_or_null(read_whole_file(folder / "manifest.json"));
    return manifest.is_object() ? manifest : Json{};
  } catch (const std::invalid_argument&) {  // what cannot be read says nothing
    return {};
  }
}

[[nodiscard]] inline std::string status_in(const Json& manifest) {
  const auto status = manifest.find("status");
  return status != manifest.end() && status->is_string() ? status->get<std::string>() : "unreadable";
}

/// When the run of a complete manifest was to end; 0 where it does not say.
[[nodiscard]] inline double until_in(const Json& manifest) {
  const auto clock = manifest.find("clock");
  if (clock == manifest.end() || !clock->is_object() || !clock->contains("until_s")) return 0.0;
  return (*clock)["until_s"].is_number() ? (*clock)["until_s"].get<double>() : 0.0;
}

/// Whether a manifest says that its run is complete, so long or longer.
[[nodiscard]] inline bool is_complete(const Json& manifest, double until_s) {
  return status_in(manifest) == "complete" && until_in(manifest) >= until_s;
}

/// Throws std::invalid_argument unless a manifest is of this run.
inline void check_manifest(const std::filesystem::path& folder, const Json& manifest, const observe::RunDescription& run) {
  const auto check = [&](const char* key, const Json& ours) {
    const auto there = manifest.find(key);
    if (there != manifest.end() && *there == ours) return;
    throw std::invalid_argument{(folder / "manifest.json").string() + ": " + key + " = " +
                                (there == manifest.end() ? "nothing" : json_text(*there)) + ": must be " + json_text(ours) +
                                ", as of the run that is to go on"};
  };
  check("fingerprint", run.fingerprint);
  check("seed", run.seed);
}

/// The last checkpoint of this version that can be read, or why there is none.
[[nodiscard]] inline std::pair<std::optional<Checkpoint>, std::string> last_in(const std::filesystem::path& folder) {
  if (!checkpoint::exists(folder)) return {std::nullopt, "it has no checkpoint"};
  try {
    Checkpoint last = read_last(folder);
    if (last.program_version != version) return {std::nullopt, "its checkpoint is of trophic " + last.program_version};
    return {std::move(last), ""};
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

TROPHIC_INLINE RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run) {
  if (!std::filesystem::exists(folder)) return {};
  const FolderLock alone{folder};
  const Json manifest = detail::manifest_in(folder);
  const std::string status = detail::status_in(manifest);
  const double until_s = detail::until_in(manifest);
  if (detail::is_complete(manifest, run.until_s)) {
    detail::check_manifest(folder, manifest, run);
    return {.complete = true, .from = {}, .remark = "is complete already, to " + number_text(until_s) + " s"};
  }
  auto [last, why] = detail::last_in(folder);
  if (last) {
    try {
      check_same_run(*last, run);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{folder.string() + ": " + error.what()};
    }
    // A run ends with the first tick at or after its end, by the same arithmetic.
    const double before_s = static_cast<double>(last->tick - 1) * run.tick_s;
    if (last->tick > 0 && before_s >= run.until_s) {
      throw std::invalid_argument{"until_s = " + number_text(run.until_s) + ": must be > " + number_text(before_s) +
                                  ", beyond which the run in " + folder.string() + " has come"};
    }
    std::string remark = "goes on from its checkpoint at " + number_text(last->time_s) + " s";
    return {.complete = false, .from = std::move(last), .remark = std::move(remark)};
  }
  if (status == "complete") {
    throw std::invalid_argument{folder.string() + ": is complete to " + number_text(until_s) + " s and cannot go on: " + why};
  }
  return {.complete = false,
          .from = {},
          .remark = "was incomplete (status \"" + status + "\"; " + why + "): kept as " +
                    rename_incomplete(folder).filename().string() + ", run anew"};
}

}  // namespace trophic::checkpoint
