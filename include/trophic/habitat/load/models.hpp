// SPDX-License-Identifier: MIT
// Finds the data files of robots, arenas and gaits by name.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <trophic/habitat/load/installed_models.hpp>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic {

enum class ModelKind { robot, arena, gait };
[[nodiscard]] constexpr std::array<std::string_view, 3> folder_names(ModelKind) {
  return {"robots", "arenas", "gaits"};
}

/// The folders that contain `robots/`, `arenas/` and `gaits/`, in search order: the environment variable TROPHIC_MODELS if it
/// is set, then `installed` unless it is empty.
[[nodiscard]] std::vector<std::filesystem::path> model_folders(std::string_view installed = TROPHIC_MODEL_DIR);

/// Returns the file of a model. A text with a '/' or ending in ".toml" is a path; any other is a name: FOLDER/robots/NAME.toml
/// and so on. Throws std::invalid_argument listing every place that was searched.
[[nodiscard]] std::filesystem::path find_model(ModelKind kind, std::string_view name_or_path,
                                               std::string_view installed = TROPHIC_MODEL_DIR);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/models.ipp>
#endif
