// SPDX-License-Identifier: MIT
// contraction FOLDER: a kinematic run, by the headers alone.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/rules/paper.hpp>

int main(int, char** argv) {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  trophic::io::RunFolder files{argv[1]};
  ecology.run_until(3000.0, files);
}
