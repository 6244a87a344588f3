// SPDX-License-Identifier: MIT
// The ecologies of the rule tables that trophic ships, compiled once in trophic::compiled.
#pragma once

#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>

#if !TROPHIC_HEADER_ONLY
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
namespace trophic {
extern template class Ecology<rules::Paper>;
extern template class Ecology<rules::Released>;
}  // namespace trophic
#endif
