// SPDX-License-Identifier: MIT
// Commands of trophic that are programs of their own, as git finds its own: trophic-NAME.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace trophic::command {

/// The programs trophic-NAME in this program's folder and in those of PATH, by NAME; of equal names the first.
[[nodiscard]] std::map<std::string, std::filesystem::path> found_programs();

/// The program trophic-NAME in this program's folder or in one of PATH; empty if there is none. Lists no folder.
[[nodiscard]] std::filesystem::path found_program(const std::string& name);

/// Becomes the program with the arguments that follow NAME in `argv`. Throws std::invalid_argument if it cannot be started.
[[noreturn]] void become(const std::filesystem::path& program, char** argv);

}  // namespace trophic::command
