// SPDX-License-Identifier: MIT
// Definitions of shadow.hpp.
#include <tools/reading/shadow.hpp>

#include <trophic/support/json.hpp>

namespace trophic::analysis {

std::vector<std::filesystem::path> null_folders(std::span<const std::filesystem::path> paths, Null null) {
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& path : paths) {
    if (std::filesystem::is_directory(path / enum_name(null))) found.push_back(path / enum_name(null));
  }
  return found;
}

void check_shadow(const RunManifest& ours, const RunManifest& shadow, bool any_parent) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument{shadow.folder.string() + ": is not a neutral shadow of " + ours.folder.string() + ": " + why};
  };
  const std::string slot{shadow_slot};
  const std::string policy = shadow.policies.value(slot, "unknown");
  if (policy != shadow_policy) {
    refuse("its rule in slot " + slot + " is " + policy + ": must be " + std::string{shadow_policy});
  }
  const auto rest_of = [&](const RunManifest& manifest) {
    Json rest{{"backend", manifest.backend}, {"params", manifest.params}, {"rules", manifest.policies}};
    rest["params"].erase("seed");
    for (const std::string& free : any_parent ? std::vector{slot, std::string{"parent"}} : std::vector{slot}) {
      rest["rules"].erase(free);
      if (rest["params"].contains("rules")) rest["params"]["rules"].erase(free);
    }
    return rest;
  };
  if (const std::string why = first_difference(rest_of(ours), rest_of(shadow)); !why.empty()) refuse(why);
  if (!lasted_alike(ours, shadow)) refuse("it has " + lasted_text(shadow) + ": must be as " + lasted_text(ours));
}

}  // namespace trophic::analysis
