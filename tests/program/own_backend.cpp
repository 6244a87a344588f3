// SPDX-License-Identifier: MIT
// A user's program with a backend of one's own, which is its default.
#include <support/toy_backend.hpp>
#include <trophic/experiment.hpp>
#include <trophic/rules/paper.hpp>

int main(int argc, char** argv) {
  using Backends = trophic::BackendList<trophic::test::ToyBackend, trophic::backend::Kinematic>;
  return trophic::experiment_on<Backends, trophic::rules::Paper>(argc, argv);
}
