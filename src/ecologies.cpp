// SPDX-License-Identifier: MIT
// The ecologies of the shipped tables on one backend: TROPHIC_ECOLOGIES_ON is its class, TROPHIC_ECOLOGIES_BACKEND its header.
#include TROPHIC_ECOLOGIES_BACKEND
#include <trophic/ecology/ecology.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

template class trophic::Ecology<trophic::rules::Paper, trophic::backend::TROPHIC_ECOLOGIES_ON>;
template class trophic::Ecology<trophic::rules::Released, trophic::backend::TROPHIC_ECOLOGIES_ON>;
