// SPDX-License-Identifier: MIT
// A misspelt slot in a derived table would run the paper's rule: a table cannot be derived from.
// expect: 'final'
#include <trophic/reproduction/mutation/uniform_mutation.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Mine = trophic::with_mutation<trophic::rules::Paper, trophic::reproduction::mutation::UniformMutation>;
#else
struct Mine final : trophic::rules::Paper {
  using Mutatoin = trophic::reproduction::mutation::UniformMutation;
};
#endif

int main() {}
