// SPDX-License-Identifier: MIT
// The subcommands of the program trophic, one file each, so that they compile side by side.
#pragma once

#include <tools/command/option.hpp>
#include <tools/trophic/analyze.hpp>

namespace trophic::command {

[[nodiscard]] Command cite();
[[nodiscard]] Command contest_command();
[[nodiscard]] Command convert_body();
[[nodiscard]] Command cross_check_engines();
[[nodiscard]] Command evolve_gait();
[[nodiscard]] Command export_run();
[[nodiscard]] Command film();
[[nodiscard]] Command ablation_table();
[[nodiscard]] Command help(const std::function<Command()>& program);
[[nodiscard]] Command measure_gait();
[[nodiscard]] Command plan();
[[nodiscard]] Command plot();
[[nodiscard]] Command show();

}  // namespace trophic::command
