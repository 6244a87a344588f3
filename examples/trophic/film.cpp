// SPDX-License-Identifier: MIT
// `trophic film`.
#include <trophic/command/film.hpp>

#include "commands.hpp"

trophic::command::Command commands::film() {
  return trophic::command::film();
}
