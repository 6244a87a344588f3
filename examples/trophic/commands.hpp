// SPDX-License-Identifier: MIT
// The subcommands of the program trophic, one file each, so that they compile side by side.
#pragma once

#include <trophic/command/option.hpp>

namespace commands {

[[nodiscard]] trophic::command::Command analyze();
[[nodiscard]] trophic::command::Command export_run();
[[nodiscard]] trophic::command::Command film();
[[nodiscard]] trophic::command::Command flip_table();
[[nodiscard]] trophic::command::Command cross_check();
[[nodiscard]] trophic::command::Command evolve_gait();
[[nodiscard]] trophic::command::Command measure_gait();
[[nodiscard]] trophic::command::Command show();

}  // namespace commands
