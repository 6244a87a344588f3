// SPDX-License-Identifier: MIT
// `trophic cross-check`.
#include <trophic/command/cross_check.hpp>

#include "commands.hpp"

trophic::command::Command commands::cross_check() {
  return trophic::command::cross_check_engines();
}
