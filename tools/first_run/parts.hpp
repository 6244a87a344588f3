// SPDX-License-Identifier: MIT
// The parts of the first run that compile side by side, from headers alone.
#pragma once

#include <filesystem>
#include <trophic/backend/backend_choice.hpp>

namespace trophic::first_run {

/// MuJoCo with its defaults, on two threads.
[[nodiscard]] BackendChoice mujoco();

/// Writes the page of `trophic show` of a run's folder. Throws std::invalid_argument if the run cannot be read or `page` exists.
void write_page(const std::filesystem::path& folder, const std::filesystem::path& page);

}  // namespace trophic::first_run
