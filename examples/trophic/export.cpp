// SPDX-License-Identifier: MIT
// `trophic export`.
#include <trophic/command/export_run.hpp>

#include "commands.hpp"

trophic::command::Command commands::export_run() {
  return trophic::command::export_run();
}
