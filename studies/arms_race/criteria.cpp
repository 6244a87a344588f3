// SPDX-License-Identifier: MIT
// Ecologies of ecologies.hpp: criteria and ageing in `paper`.
#include "ecologies.hpp"

using namespace trophic::arms_race;

template class trophic::Ecology<PaperLastEscapee>;
template class trophic::Ecology<PaperMostEscapes>;
template class trophic::Ecology<PaperFastestEscape>;
template class trophic::Ecology<PaperAgeing>;
template class trophic::Ecology<PaperLastEscapeeAgeing>;
template class trophic::Ecology<PaperMostEscapesAgeing>;
template class trophic::Ecology<PaperFastestEscapeAgeing>;
