// SPDX-License-Identifier: MIT
// Finds the data files of robots, arenas and gaits by name.
#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace trophic {

enum class ModelKind { robot, arena, gait };
[[nodiscard]] constexpr std::array<std::string_view, 3> folder_names(ModelKind) {
  return {"robots", "arenas", "gaits"};
}

/// The folders that hold `robots/`, `arenas/` and `gaits/`, in the order in which they are searched: the environment variable
/// TROPHIC_MODELS where it is set, then the folder that the library was built or installed with.
[[nodiscard]] inline std::vector<std::filesystem::path> model_folders() {
  std::vector<std::filesystem::path> folders;
  if (const char* chosen = std::getenv("TROPHIC_MODELS"); chosen != nullptr && *chosen != '\0') folders.emplace_back(chosen);
#ifdef TROPHIC_MODEL_DIR
  folders.emplace_back(TROPHIC_MODEL_DIR);
#endif
  return folders;
}

/// The file of a model. A text with a '/' or ending in ".toml" is a path and taken as it is; any other is a name:
/// FOLDER/robots/NAME.toml and so on. Throws std::runtime_error listing every place that was searched.
[[nodiscard]] inline std::filesystem::path find_model(ModelKind kind, std::string_view name_or_path) {
  const std::string_view folder = folder_names(kind).at(static_cast<std::size_t>(kind));
  std::vector<std::filesystem::path> places;
  if (name_or_path.find('/') != std::string_view::npos || name_or_path.ends_with(".toml")) {
    places.emplace_back(name_or_path);
  } else {
    for (const std::filesystem::path& root : model_folders())
      places.push_back(root / folder / (std::string{name_or_path} + ".toml"));
  }
  std::string searched;
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) return place;
    searched += (searched.empty() ? "" : ", ") + place.string();
  }
  throw std::runtime_error{"no " + std::string{folder.substr(0, folder.size() - 1)} + " \"" + std::string{name_or_path} +
                           "\"; searched: " + (searched.empty() ? "nowhere (set TROPHIC_MODELS)" : searched)};
}

}  // namespace trophic
