// SPDX-License-Identifier: MIT
// Ablations of the differences between the paper's text and its released code: each swapped alone, and in groups, from either
// table towards the other, in replicates.
#include <tools/ablations/ablations.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

int main(int argc, char** argv) {
  return trophic::command::ablations<trophic::rules::Paper, trophic::rules::Released>(argc, argv);
}
