// SPDX-License-Identifier: MIT
// The neutral shadow, the same ecology in which nothing is inherited: finds its folder and checks that it is one.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <tools/reading/run_manifest.hpp>
#include <trophic/population/null.hpp>
#include <vector>

namespace trophic::analysis {

/// The slot in which a table and its shadow differ, and the policy that the shadow has there.
inline constexpr std::string_view shadow_slot = "heredity";
inline constexpr std::string_view shadow_policy = "nothing_inherited";

/// The folders PATH/shadow or PATH/neutral that exist, into which --shadow and --neutral put the nulls of these runs.
[[nodiscard]] std::vector<std::filesystem::path> null_folders(std::span<const std::filesystem::path> paths, Null null);

/// Throws std::invalid_argument, naming both runs and what differs, unless `shadow` is a run of the same rules, parameters,
/// engine and duration as `ours` with nothing inherited. Seeds may differ. With `any_parent` the rule in slot Parent may differ
/// too: if nothing is inherited, it changes parents and labels, and no genome and no motion.
void check_shadow(const RunManifest& ours, const RunManifest& shadow, bool any_parent = false);

}  // namespace trophic::analysis
