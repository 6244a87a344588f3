// SPDX-License-Identifier: MIT
// Definitions of policy.hpp.
#pragma once

#include <trophic/params/policy.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic::detail {

TROPHIC_INLINE void reject_policy(std::string_view policy, std::string_view slot, const std::string& path) {
  throw RuleError{"the policy " + std::string{policy} + (slot.empty() ? "" : " in rules.") + std::string{slot} +
                  " holds another " + path + " than it was made from"};
}

}  // namespace trophic::detail
