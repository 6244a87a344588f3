// SPDX-License-Identifier: MIT
// The ecologies of the study, each compiled in one of three files.
#pragma once

#include <trophic/ecology/shipped.hpp>

#include "tables.hpp"

namespace trophic {

// In criteria.cpp.
extern template class Ecology<arms_race::PaperLastEscapee>;
extern template class Ecology<arms_race::PaperMostEscapes>;
extern template class Ecology<arms_race::PaperFastestEscape>;
extern template class Ecology<arms_race::PaperAgeing>;
extern template class Ecology<arms_race::PaperLastEscapeeAgeing>;
extern template class Ecology<arms_race::PaperMostEscapesAgeing>;
extern template class Ecology<arms_race::PaperFastestEscapeAgeing>;

// In others.cpp.
extern template class Ecology<arms_race::PaperAfterEscapes>;
extern template class Ecology<arms_race::ReleasedMostEscapes>;
extern template class Ecology<arms_race::ReleasedAgeing>;
extern template class Ecology<arms_race::ReleasedMostEscapesAgeing>;
extern template class Ecology<arms_race::PaperRoom>;
extern template class Ecology<arms_race::PaperMostEscapesRoom>;

// In sides.cpp.
extern template class Ecology<arms_race::PaperBySide>;
extern template class Ecology<arms_race::ReleasedBySide>;
extern template class Ecology<arms_race::PondBySide>;
extern template class Ecology<arms_race::GrowingBySide>;

}  // namespace trophic
