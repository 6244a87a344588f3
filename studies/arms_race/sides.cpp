// SPDX-License-Identifier: MIT
// Ecologies of ecologies.hpp in which one side may evolve alone.
#include "ecologies.hpp"

using namespace trophic::arms_race;

template class trophic::Ecology<PaperBySide>;
template class trophic::Ecology<ReleasedBySide>;
template class trophic::Ecology<PondBySide>;
template class trophic::Ecology<GrowingBySide>;
