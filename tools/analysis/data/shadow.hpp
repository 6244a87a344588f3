// SPDX-License-Identifier: MIT
// A neutral shadow: the same ecology in which nothing is inherited. Where it lies, and whether it is one.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/analysis/data/run_manifest.hpp>
#include <trophic/support/json.hpp>
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
inline void check_shadow(const RunManifest& ours, const RunManifest& shadow) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument{shadow.folder.string() + ": is no neutral shadow of " + ours.folder.string() + ": " + why};
  };
  const std::string slot{shadow_slot};
  const std::string policy = shadow.policies.value(slot, "unknown");
  if (policy != shadow_policy) {
    refuse("its rule in slot " + slot + " is " + policy + ": must be " + std::string{shadow_policy});
  }
  const auto rest_of = [&](const RunManifest& manifest) {
    Json rest{{"backend", manifest.backend}, {"params", manifest.params}, {"rules", manifest.policies}};
    rest["rules"].erase(slot);
    rest["params"].erase("seed");
    if (rest["params"].contains("rules")) rest["params"]["rules"].erase(slot);
    return rest;
  };
  if (const std::string why = first_difference(rest_of(ours), rest_of(shadow)); !why.empty()) refuse(why);
  if (!lasted_alike(ours, shadow)) refuse("it has " + lasted_text(shadow) + ": must be as " + lasted_text(ours));
}

}  // namespace trophic::analysis
