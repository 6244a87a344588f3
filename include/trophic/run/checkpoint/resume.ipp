// SPDX-License-Identifier: MIT
// Definitions of resume.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <trophic/io/program_code.hpp>
#include <trophic/run/checkpoint/manifest_in.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/checksum.hpp>
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

/// Throws std::invalid_argument unless a manifest belongs to this run.
inline void check_manifest(const std::filesystem::path& folder, const Json& manifest, const observe::RunDescription& run) {
  const auto check = [&](const char* key, const Json& ours) {
    const auto there = manifest.find(key);
    if (there != manifest.end() && *there == ours) return;
    throw std::invalid_argument{(folder / "manifest.json").string() + ": " + key + " = " +
                                (there == manifest.end() ? "nothing" : json_text(*there)) + ": must be " + json_text(ours) +
                                ", as in the run to resume"};
  };
  check("fingerprint", run.fingerprint);
  check("seed", run.seed);
}

/// Throws std::invalid_argument for a folder that is not empty but has neither a trophic manifest nor a file that every run
/// starts with.
inline void check_of_a_run(const std::filesystem::path& folder, const Json& manifest) {
  constexpr std::array<std::string_view, 5> files{"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp"};
  const bool has_one = std::ranges::any_of(files, [&](auto name) { return std::filesystem::exists(folder / name); });
  if (has_one || checkpoint::exists(folder) || !manifest.is_null() || std::filesystem::is_empty(folder)) return;
  throw std::invalid_argument{folder.string() + ": is not the folder of a run: it has files, but no events.csv"};
}

/// Returns how the tables and the recording of a manifest differ from its checksums; empty if they do not.
[[nodiscard]] inline std::string wrong_sum_in(const std::filesystem::path& folder, const Json& manifest) {
  constexpr std::size_t piece_bytes = std::size_t{1} << 20U;
  Json sums = manifest.value("tables", Json::object());
  if (manifest.contains("recording")) sums["replay.trp"] = manifest["recording"];
  for (const auto& [name, sum] : sums.items()) {
    const std::filesystem::path path = folder / std::filesystem::path{name}.filename();
    std::uint32_t is = 0;
    std::uint64_t at = 0;
    for (std::string piece = read_part(path, piece_bytes); !piece.empty();
         piece = read_part(path, piece_bytes, at += piece.size()))
      is = checksum(piece, is);
    const auto was = whole_number<std::uint32_t>(sum, "crc32");
    if (is == was) continue;
    return path.string() + ": has checksum " + std::to_string(is) + ": must be " + std::to_string(was) +
           ", as its manifest says; the file was cut or changed after the run";
  }
  return "";
}

/// Returns the last complete checkpoint of this version, or why there is none. Throws UnreadableFile.
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

TROPHIC_INLINE std::string damage_in(const std::filesystem::path& folder) {
  const std::string path = (folder / "manifest.json").string();
  const Json manifest = detail::manifest_in(folder);
  if (manifest.is_null()) return path + ": is missing, cut short, or was changed after trophic wrote it";
  try {
    if (std::string wrong = detail::wrong_sum_in(folder, manifest); !wrong.empty()) return wrong;
    const bool has_checkpoint =
        std::filesystem::exists(folder / file_name) && manifest.contains("format") && manifest.at("trophic") == Json(version);
    if (!has_checkpoint || detail::status_in(manifest) != "complete") return "";
    const std::string checkpoint = (folder / file_name).string();
    const std::vector<Checkpoint> whole = read_all(folder);
    if (whole.empty()) return checkpoint + ": is cut short or damaged; without this file the run can be read, but not continued";
    const Checkpoint& first = whole.front();
    if (manifest.at("fingerprint") == Json(first.fingerprint) && manifest.at("seed") == Json(first.seed)) return "";
    return checkpoint + ": is of another run than manifest.json";
  } catch (const Json::exception& error) {
    return path + ": " + reason_of(error);
  } catch (const UnreadableFile&) {
    throw;
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
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
         detail::until_in(manifest) == until_s;
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
  if (!manifest.is_null())
    for (const Json& one : manifest.value("continued", Json::array())) add(one);
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
                                     const Schedule& schedule) {
  if (!std::filesystem::exists(folder)) return {};
  const FolderLock alone{folder};
  check_no_links_in(folder);
  const Json manifest = detail::manifest_in(folder);
  detail::check_of_a_run(folder, manifest);
  const std::string status = detail::status_in(manifest);
  const double until_s = detail::until_in(manifest);
  if (detail::is_complete(manifest, run.until_s)) {
    detail::check_manifest(folder, manifest, run);
    const std::string damage = schedule.verifies ? damage_in(folder) : "";
    if (damage.empty()) {
      std::filesystem::remove(folder / "manifest.json.part");  // of a program that was killed as it wrote its speed
      return {.complete = true, .from = {}, .remark = "is complete already, to " + number_text(until_s) + " s"};
    }
    return {.complete = false,
            .from = {},
            .remark = "was complete, but damaged (" + damage + "): kept as " + rename_incomplete(folder).filename().string() +
                      ", run anew"};
  }
  auto [last, why] = detail::last_in(folder);
  if (last) {
    const bool is_other = last->code != program_code() && schedule.other_build == OtherBuild::accepted;
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
    std::string remark = "resumes from its checkpoint at " + number_text(last->time_s) + " s" +
                         (manifest.is_null() ? ", because its manifest.json is incomplete" : "") +
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
