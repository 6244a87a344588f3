// SPDX-License-Identifier: MIT
// The rule that examples/03_write_a_rule.cpp shows keeps the contract that it is an example of.
#include <conformance/death_suite.hpp>

// Under another name the example's main needs a return statement; it is never called.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wreturn-type"
#define main run_example
#include <examples/03_write_a_rule.cpp>
#undef main
#pragma GCC diagnostic pop

TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, HungryReach);
