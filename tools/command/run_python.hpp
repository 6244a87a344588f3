// SPDX-License-Identifier: MIT
// From a command's options to the Python module, which analyses and draws.
#pragma once

#include <tools/command/option.hpp>
#include <trophic/support/json.hpp>

namespace trophic::command {

/// Becomes `python3 -m trophic.command`, which reads the request from its standard input and whose exit code is the program's.
/// "command" names what is done and "who" begins its messages; "program" is added. TROPHIC_PYTHON names another interpreter.
/// Destructors do not run: the module removes the folder under "temporary". Throws std::invalid_argument if the module or the
/// interpreter is missing, std::runtime_error if the request cannot be passed on.
[[noreturn]] int run_python(Json request);

/// The same command of a program, whose work is that of the Python module: the request has the values of its options by their
/// names, as "with_captions" for --with-captions, null if not given. `prepare` checks them before and may add to the request.
[[nodiscard]] Command python_command(const std::string& program, Command command, std::function<void(Json&)> prepare);

}  // namespace trophic::command
