// SPDX-License-Identifier: MIT
// A user's program with a backend of one's own, which is its default.
#include <support/toy_backend.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/experiment.hpp>
#include <trophic/rules/paper.hpp>

int main(int argc, char** argv) {
  return trophic::experiment<trophic::rules::Paper>(
      argc, argv, {.backends = {trophic::test::ToyBackend::Params{}, trophic::backend::Kinematic::Params{}}});
}
