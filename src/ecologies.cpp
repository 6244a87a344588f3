// SPDX-License-Identifier: MIT
// trophic::compiled: the ecologies that trophic/ecology/shipped.hpp declares.
#include <trophic/ecology/shipped.hpp>

template class trophic::Ecology<trophic::rules::Paper>;
template class trophic::Ecology<trophic::rules::Released>;
