// SPDX-License-Identifier: MIT
// Definitions of habitat.hpp.
#pragma once

#include <string>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/numbers_text.hpp>

namespace trophic {

TROPHIC_INLINE std::string numbers_text(const Habitat& habitat) {
  return numbers_text<Habitat>(habitat);
}

}  // namespace trophic
