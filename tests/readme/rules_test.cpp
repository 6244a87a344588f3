// SPDX-License-Identifier: MIT
// The rule that README.md writes keeps the contract that it is an example of.
#include <conformance/death_suite.hpp>
#include TROPHIC_README_RULE

TEST_CASE_TEMPLATE_INVOKE(trophic_senescence_suite, Gompertz);
