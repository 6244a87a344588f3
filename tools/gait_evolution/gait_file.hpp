// SPDX-License-Identifier: MIT
// A gait file that records how its gait was evolved, and from what.
#pragma once

#include <tools/command/toml_writer.hpp>
#include <tools/gait_evolution/genome.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic::gait_evolution {

/// Writes a gait so that `load_gait` reads back exactly the same one; pairs with weight 0 are omitted.
void put_gait(TomlWriter& writer, const Gait& gait);

/// The text of a gait file (format: models/README.md) with the tables [cppn], the genome, and [evolution], the provenance with
/// all parameters below it. `load_gait` reads the gait, `load_cppn` the genome.
[[nodiscard]] std::string gait_file(const Gait& gait, const Genome& genome, const NamedParams& provenance,
                                    const NamedParams& parameters);

/// The genome in a gait file, by name or path. Errors as `load_gait`.
[[nodiscard]] Genome load_cppn(std::string_view name_or_path);

}  // namespace trophic::gait_evolution
