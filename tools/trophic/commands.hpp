// SPDX-License-Identifier: MIT
// The subcommands of the program trophic, one file each, so that they compile side by side.
#pragma once

#include <tools/command/option.hpp>

namespace trophic::command {

[[nodiscard]] Command convert_body();
[[nodiscard]] Command evolve_gait();
[[nodiscard]] Command export_run();
[[nodiscard]] Command film();
[[nodiscard]] Command measure_gait();
[[nodiscard]] Command show();

}  // namespace trophic::command
