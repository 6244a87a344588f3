// SPDX-License-Identifier: MIT
// The end of a run according to the manifest in its folder.
#pragma once

#include <filesystem>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/unreadable_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::checkpoint::detail {

/// Reads manifest.json; null if it is missing, damaged or was modified. Throws UnreadableFile.
[[nodiscard]] inline Json manifest_in(const std::filesystem::path& folder) {
  try {
    return parse_sealed(read_whole_file(folder / "manifest.json", largest_manifest));
  } catch (const UnreadableFile&) {  // it may be that of a complete run
    throw;
  } catch (const std::invalid_argument&) {
    return {};
  }
}

[[nodiscard]] inline std::string status_in(const Json& manifest) {
  const auto status = manifest.find("status");
  const bool is_text = status != manifest.end() && status->is_string() && is_plain(status->get_ref<const std::string&>());
  return is_text ? status->get<std::string>() : "unreadable";
}

/// Planned end of the run in a complete manifest; 0 if it has none.
[[nodiscard]] inline double until_in(const Json& manifest) {
  const auto clock = manifest.find("clock");
  if (clock == manifest.end() || !clock->is_object() || !clock->contains("until_s")) return 0.0;
  return (*clock)["until_s"].is_number() ? (*clock)["until_s"].get<double>() : 0.0;
}

/// Whether a manifest's run is complete, to this duration or longer.
[[nodiscard]] inline bool is_complete(const Json& manifest, double until_s) {
  return status_in(manifest) == "complete" && until_in(manifest) >= until_s;
}

}  // namespace trophic::checkpoint::detail
