// SPDX-License-Identifier: MIT
// Arenas from TOML files (format: models/README.md).
#pragma once

#include <cstddef>
#include <string_view>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Half side of the largest centred square of nodes that all have height 0, m; 0 if there is none.
[[nodiscard]] double flat_half_side_m(const HeightField& field);

/// Loads the arena of a file, by name ("walled_square") or path. The file has `side_m` for a plane with four walls, or
/// `robots_per_m2` for one whose side depends on the number of `robots`, or `half_extent_m` and the rows `height_m` for a height
/// field. Its slopes are the rings of nodes at the edge that are higher than all nodes inside, or begin at the side
/// `floor_side_m`; the floor may be rough. Tables `obstacle` and `zone` are those of any arena. Throws std::invalid_argument for
/// a file that cannot be found, read or parsed, and "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] Arena load_arena(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR,
                               std::size_t robots = 1);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/arena.ipp>
#endif
