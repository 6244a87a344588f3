// SPDX-License-Identifier: MIT
// A neutral shadow: the same ecology in which nothing is inherited, as the null of every metric.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/analysis/data/read_run.hpp>
#include <trophic/analysis/data/run_set.hpp>
#include <trophic/params/params.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

/// The slot in which a table and its shadow differ, and the policy that the shadow has there.
inline constexpr std::string_view shadow_slot = "heredity";
inline constexpr std::string_view shadow_policy = "nothing_inherited";

/// Where --shadow put the shadows of these runs: PATH/shadow, where there is such a folder.
[[nodiscard]] inline std::vector<std::filesystem::path> shadow_folders(std::span<const std::filesystem::path> paths) {
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& path : paths) {
    if (std::filesystem::is_directory(path / "shadow")) found.push_back(path / "shadow");
  }
  return found;
}

/// Throws std::invalid_argument, naming both runs and what differs, unless `shadow` is a run of the same rules, numbers, engine
/// and duration as `ours` with nothing inherited. Seeds may differ.
inline void check_shadow(const RunFacts& ours, const RunFacts& shadow) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument{shadow.folder.string() + ": is no neutral shadow of " + ours.folder.string() + ": " + why};
  };
  const std::string slot{shadow_slot};
  const std::string policy = shadow.policies.value(slot, "unknown");
  if (policy != shadow_policy) {
    refuse("its rule in slot " + slot + " is " + policy + ": must be " + std::string{shadow_policy});
  }
  const auto rest_of = [&](const RunFacts& facts) {
    nlohmann::json rest{{"rules", facts.policies}, {"numbers", facts.numbers}, {"backend", facts.backend}};
    rest["rules"].erase(slot);
    rest["numbers"].erase("seed");
    if (rest["numbers"].contains("rules")) rest["numbers"]["rules"].erase(slot);
    return rest.flatten();
  };
  const nlohmann::json a = rest_of(ours);
  const nlohmann::json b = rest_of(shadow);
  const auto text = [](const nlohmann::json& of, const std::string& key) {
    return of.contains(key) ? of[key].dump() : std::string{"missing"};
  };
  for (const nlohmann::json& one : {a, b}) {
    for (const auto& [key, value] : one.items()) {
      if (text(a, key) != text(b, key)) refuse(key.substr(1) + " = " + text(b, key) + ": must be " + text(a, key));
    }
  }
  if (ours.until_s != shadow.until_s || ours.status != shadow.status) {
    refuse("it is " + shadow.status + " at " + number_text(shadow.until_s) + " s: must be " + ours.status + " at " +
           number_text(ours.until_s) + " s");
  }
}

/// A set with its shadow, where there is one.
struct ShadowedSet {
  RunSet ours;
  std::optional<RunSet> shadow;
  /// The shadow's runs; none without one.
  [[nodiscard]] std::span<const RunMetrics> shadow_runs() const {
    return shadow ? std::span<const RunMetrics>{shadow->runs} : std::span<const RunMetrics>{};
  }
};

/// Reads a set and its shadow: `elsewhere`, or else what shadow_folders finds. Throws as read_set and check_shadow do.
[[nodiscard]] inline ShadowedSet read_shadowed_set(std::span<const std::filesystem::path> paths,
                                                   const std::optional<std::filesystem::path>& elsewhere = {},
                                                   std::optional<double> until_s = {}) {
  ShadowedSet set{read_set(paths, until_s), {}};
  const auto folders = elsewhere ? std::vector{*elsewhere} : shadow_folders(paths);
  if (folders.empty()) return set;
  set.shadow = read_set(folders, until_s);
  check_shadow(set.ours.facts.front(), set.shadow->facts.front());
  return set;
}

}  // namespace trophic::analysis
