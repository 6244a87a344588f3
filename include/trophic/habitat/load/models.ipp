// SPDX-License-Identifier: MIT
// Definitions of models.hpp.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <trophic/habitat/load/models.hpp>

namespace trophic {

TROPHIC_INLINE std::vector<std::filesystem::path> model_folders(std::string_view installed) {
  std::vector<std::filesystem::path> folders;
  if (const char* chosen = std::getenv("TROPHIC_MODELS"); chosen != nullptr && *chosen != '\0') folders.emplace_back(chosen);
  if (!installed.empty()) folders.push_back(std::filesystem::path{installed}.lexically_normal());
  return folders;
}

TROPHIC_INLINE std::filesystem::path find_model(ModelKind kind, std::string_view name_or_path, std::string_view installed) {
  const std::string_view folder = folder_names(kind).at(static_cast<std::size_t>(kind));
  std::vector<std::filesystem::path> places;
  if (name_or_path.find('/') != std::string_view::npos || name_or_path.ends_with(".toml")) {
    places.emplace_back(name_or_path);
  } else {
    for (const std::filesystem::path& root : model_folders(installed))
      places.push_back(root / folder / (std::string{name_or_path} + ".toml"));
  }
  std::string searched;
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) return place;
    searched += (searched.empty() ? "" : ", ") + place.string();
  }
  std::set<std::string> names;
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (place == name_or_path) continue;
    for (const auto& entry : std::filesystem::directory_iterator{place.parent_path(), ignored}) {
      if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
    }
  }
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "; there are " : ", ") + name;
  throw std::invalid_argument{"no " + std::string{folder.substr(0, folder.size() - 1)} + " \"" + std::string{name_or_path} +
                              "\"; searched: " + (searched.empty() ? "none (set TROPHIC_MODELS)" : searched) + known};
}

}  // namespace trophic
