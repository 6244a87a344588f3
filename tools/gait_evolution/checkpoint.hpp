// SPDX-License-Identifier: MIT
// The state of a pre-experiment as a text that reads back as the same state.
#pragma once

#include <string>
#include <string_view>
#include <tools/gait_evolution/lineage.hpp>
#include <trophic/habitat/load/toml_table.hpp>

namespace trophic::gait_evolution {

/// The lineage as TOML. `fingerprint` names the pre-experiment that it belongs to.
[[nodiscard]] std::string to_toml(const Lineage& lineage, std::string_view fingerprint);

/// The inverse of `to_toml`. Throws std::invalid_argument naming file, key and value for a content that is not a lineage or has
/// another fingerprint.
[[nodiscard]] Lineage read_lineage(const trophic::detail::TomlTable& file, std::string_view fingerprint);

}  // namespace trophic::gait_evolution
