// SPDX-License-Identifier: MIT
// A CPPN genome as TOML, exact to the bit.
#pragma once

#include <tools/command/toml_writer.hpp>
#include <tools/gait_evolution/genome.hpp>
#include <trophic/habitat/load/toml_table.hpp>

namespace trophic::gait_evolution {

/// `nodes = [{id, activation}, ...]` and `links = [{innovation, from, to, weight, enabled}, ...]`, into the table at hand.
void put_genome(TomlWriter& writer, const Genome& genome);

/// The genome of a table that `put_genome` wrote; other keys of the table are left to the caller. Throws std::invalid_argument
/// "FILE: KEY = VALUE: must be ...", for a genome that is not valid too.
[[nodiscard]] Genome read_genome(const trophic::detail::TomlTable& table);

}  // namespace trophic::gait_evolution
