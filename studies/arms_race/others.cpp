// SPDX-License-Identifier: MIT
// Ecologies of ecologies.hpp: births without a death, criteria and ageing in `released`, and more room.
#include "ecologies.hpp"

using namespace trophic::arms_race;

template class trophic::Ecology<PaperAfterEscapes>;
template class trophic::Ecology<ReleasedMostEscapes>;
template class trophic::Ecology<ReleasedAgeing>;
template class trophic::Ecology<ReleasedMostEscapesAgeing>;
template class trophic::Ecology<PaperRoom>;
template class trophic::Ecology<PaperMostEscapesRoom>;
