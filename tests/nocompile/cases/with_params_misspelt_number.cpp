// SPDX-License-Identifier: MIT
// A misspelt number of a table made of another one.
// expect: 'flor'
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Rules = trophic::with_params<trophic::rules::Paper, [](auto& params) { params.floor.floor = 5; }>;
#else
using Rules = trophic::with_params<trophic::rules::Paper, [](auto& params) { params.floor.flor = 5; }>;
#endif

int main() {
  return trophic::RuleParams<Rules>{}.floor.floor == 5 ? 0 : 1;
}
