// SPDX-License-Identifier: MIT
// Preparations of a program before it reads its arguments, for run_command.cpp.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <tools/command/run_command.hpp>
#include <tools/command/this_program.hpp>

namespace trophic::command::detail {

/// Lets an installed program find the models that were installed with it: PREFIX/share/trophic/models next to PREFIX/bin, unless
/// TROPHIC_MODELS names others.
inline void use_installed_models() {
  std::error_code error;
  const std::filesystem::path program = program_path(error);
  const std::filesystem::path models = program.parent_path().parent_path() / "share/trophic/models";
  if (!error && std::filesystem::is_directory(models, error)) ::setenv("TROPHIC_MODELS", models.c_str(), 0);
}

/// Keeps the numbers of standard streams that were closed (`>&-`) from files that the program opens: otherwise its messages would
/// go into a table. Writing to the replacement fails, so that it is noticed.
inline void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // This opens the lowest free number, which is this stream's.
    static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

inline std::terminate_handler die_otherwise = nullptr;  ///< the handler that exit_with_message replaces

/// If memory runs out where exceptions are impossible, such as in a library's destructor, prints one line and exits with
/// `run_error`; files are as a killed program leaves them.
[[noreturn]] inline void exit_with_message() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc& error) {
    static_cast<void>(report_failure(invocation_name(), error));
    std::_Exit(run_error);
  } catch (...) {  // a bug: dies as without this
  }
  die_otherwise();
  std::abort();
}

inline void prepare_process() {
  occupy_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes makes a write fail, as a full disk does
  if (die_otherwise == nullptr) die_otherwise = std::set_terminate(&exit_with_message);
  use_installed_models();
}

}  // namespace trophic::command::detail
