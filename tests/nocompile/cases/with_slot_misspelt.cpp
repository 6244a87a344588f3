// SPDX-License-Identifier: MIT
// A misspelt slot would leave the rule that was to be swapped in place.
// expect: did you mean 'with_mutation'
#include <trophic/reproduction/mutation/uniform_mutation.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Rules = trophic::with_mutation<trophic::rules::Paper, trophic::reproduction::mutation::UniformMutation>;
#else
using Rules = trophic::with_mutatoin<trophic::rules::Paper, trophic::reproduction::mutation::UniformMutation>;
#endif

int main() {}
