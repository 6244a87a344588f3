// SPDX-License-Identifier: MIT
// Provenance of the program itself, for manifests and --version.
#pragma once

#include <string>
#include <tools/command/host_name.hpp>
#include <tools/command/run_command.hpp>
#include <trophic/io/manifest.hpp>
#include <trophic/io/program_code.hpp>
#include <trophic/support/version.hpp>

/// `git describe` of the program's sources at the last build, its build type and flags. The CMake function trophic_add_experiment
/// sets them by definitions that replace these; a program that is built differently lacks them.
extern "C" {
[[gnu::weak]] const char* trophic_source_revision = nullptr;
[[gnu::weak]] const char* trophic_build = nullptr;
extern const char* trophic_revision;  ///< the same of trophic itself, by its own build
}

namespace trophic::command {

/// A commit, with "-dirty" if files had changed since; "unknown" if the build did not set it.
[[nodiscard]] inline std::string source_revision() {
  return trophic_source_revision == nullptr ? "unknown" : trophic_source_revision;
}

/// Build type and flags, or as much of them as the compiler's macros show.
[[nodiscard]] inline std::string build() {
  if (trophic_build != nullptr) return trophic_build;
#ifdef __OPTIMIZE__
  return "optimised";
#else
  return "not optimised";
#endif
}

/// For manifests: the command line, the host, the revision of the sources and how they were compiled.
[[nodiscard]] inline io::Provenance provenance(int argc, const char* const* argv) {
  return {{"command_line", command_line(argc, argv)},
          {"host", host_name()},
          {"trophic_revision", trophic_revision},
          {"source_revision", source_revision()},
          {"build", build()}};
}

/// For --version. `backends`: names and versions.
[[nodiscard]] inline std::string version_text(const std::string& backends) {
  return "trophic   " + std::string{version} + "\nrevision  " + trophic_revision + "\nsource    " + source_revision() +
         "\ncode      " + program_code() + "\ncompiler  " + io::compiler() + "\nbuild     " + build() + "\nbackends  " + backends;
}

}  // namespace trophic::command
