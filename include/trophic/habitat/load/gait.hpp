// SPDX-License-Identifier: MIT
// Gaits from TOML files and to them (format: models/README.md).
#pragma once

#include <filesystem>
#include <string_view>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

class TomlWriter;

/// The gait of a file, by name ("spider_published") or path (format: models/README.md). Throws std::invalid_argument for a file
/// that cannot be found, read or parsed, and "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] Gait load_gait(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

/// Writes what `load_gait` reads back as exactly the same gait (but pairs with weight 0 are left out).
void put_gait(TomlWriter& writer, const Gait& gait);

/// Writes the gait to a new file. Throws std::runtime_error if the file exists or cannot be written completely.
void save_gait(const Gait& gait, const std::filesystem::path& file);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/gait.ipp>
#endif
