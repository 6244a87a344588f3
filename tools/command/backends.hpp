// SPDX-License-Identifier: MIT
// The backends with which trophic was built: the only list behind --backend, its help and its errors.
#pragma once

#include <trophic/backend/backend_choice.hpp>

namespace trophic::command {

/// The default backend of trophic's own programs, even if it was not found when they were built.
inline constexpr std::string_view default_backend = "mujoco";

/// The kinematic backend and the engines, with their default parameters.
[[nodiscard]] std::vector<BackendChoice> built_backends();

[[nodiscard]] std::vector<std::string> backend_names(const std::vector<BackendChoice>& backends);

/// The names of the built backends that have joints.
[[nodiscard]] std::vector<std::string> joint_driven_names();

/// The built backend with joints that has this name. Throws std::invalid_argument for any other name.
[[nodiscard]] BackendChoice joint_driven_backend(const std::string& name);

/// "kinematic 1, mujoco 2.2.2".
[[nodiscard]] std::string backend_versions(const std::vector<BackendChoice>& backends);

/// The error message for a backend that is not in `names`: an engine without which trophic was built, or an unknown name.
[[nodiscard]] std::string about_missing_backend(const std::string& name, const std::vector<std::string>& names);

/// "physics: kinematic, mujoco (default: mujoco)": the help of --backend.
[[nodiscard]] std::string backend_help(const std::vector<std::string>& names, std::string_view otherwise = default_backend);

}  // namespace trophic::command
