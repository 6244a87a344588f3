// SPDX-License-Identifier: MIT
// `trophic flip-table`.
#include <trophic/command/flip_table.hpp>

#include "commands.hpp"

trophic::command::Command commands::flip_table() {
  return trophic::command::flip_table();
}
