// SPDX-License-Identifier: MIT
// The rule of README.md satisfies the conformance suite of its slot.
#include <conformance/death_suite.hpp>
#include TROPHIC_README_RULE

TEST_CASE_TEMPLATE_INVOKE(trophic_senescence_suite, Gompertz);
