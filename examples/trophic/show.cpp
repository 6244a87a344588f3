// SPDX-License-Identifier: MIT
// `trophic show`.
#include <trophic/command/show.hpp>

#include "commands.hpp"

trophic::command::Command commands::show() {
  return trophic::command::show();
}
