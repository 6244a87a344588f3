// SPDX-License-Identifier: MIT
// Reads and writes gaits as TOML files (format: models/README.md).
#pragma once

#include <filesystem>
#include <string_view>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

class TomlWriter;

/// Loads the gait of a file, by name ("spider_published") or path. Throws std::invalid_argument for a file that cannot be
/// found, read or parsed, and "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] Gait load_gait(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

/// Returns a text that `load_gait` reads back as exactly the same gait; pairs with weight 0 are omitted.
void put_gait(TomlWriter& writer, const Gait& gait);

/// Writes the gait to a new file. Throws std::runtime_error if the file exists or cannot be written completely.
void save_gait(const Gait& gait, const std::filesystem::path& file);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/gait.ipp>
#endif
