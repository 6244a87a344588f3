// SPDX-License-Identifier: MIT
// A user's program in one file: a table of one's own beside the paper's.
#include <string_view>
#include <trophic/command/experiment.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/rules/paper.hpp>

using Ageing = trophic::named<trophic::with_senescence<trophic::rules::Paper, trophic::death::senescence::OldAge>, "ageing">;

int main(int argc, char** argv) {
  return trophic::command::experiment<Ageing, trophic::rules::Paper>(argc, argv);
}
