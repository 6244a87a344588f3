// SPDX-License-Identifier: MIT
// `trophic film`.
#include <trophic/film/command.hpp>

#include "commands.hpp"

trophic::command::Command commands::film() {
  return trophic::command::film();
}
