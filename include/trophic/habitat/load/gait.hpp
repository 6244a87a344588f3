// SPDX-License-Identifier: MIT
// Reads gaits from TOML files (format: models/README.md).
#pragma once

#include <string_view>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Loads the gait of a file, by name ("spider_published") or path. Throws std::invalid_argument for a file that cannot be
/// found, read or parsed, and "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] Gait load_gait(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/gait.ipp>
#endif
