// SPDX-License-Identifier: MIT
// `trophic analyze`.
#include <trophic/command/analyze.hpp>

#include "commands.hpp"

trophic::command::Command commands::analyze() {
  return trophic::command::analyze();
}
