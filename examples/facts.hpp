// SPDX-License-Identifier: MIT
// What the manifests of these programs say about the program itself.
#pragma once

#include <unistd.h>

#include <array>
#include <string>
#include <trophic/observe/manifest.hpp>

#include "command.hpp"

/// `git describe` of the sources at the last build: a commit, "-dirty" where files had changed since; "unknown" without git.
extern const char* const source_revision;

namespace trophic::examples {

/// The command line, the host, the revision of the sources and how they were compiled.
[[nodiscard]] inline observe::Facts facts(int argc, char** argv) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return {{"command_line", command_line(argc, argv)},
          {"host", host.data()},
          {"source_revision", source_revision},
          {"build", TROPHIC_BUILD}};
}

}  // namespace trophic::examples
