// SPDX-License-Identifier: MIT
// alone
// expect: an Ecology made from numbers alone reads model files: #include <trophic/habitat/load/habitat.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/rules/paper.hpp>
#ifdef VALID
#include <trophic/habitat/load/habitat.hpp>
#endif

int main() {
  trophic::Ecology<trophic::rules::Paper, trophic::backend::Kinematic> ecology({.seed = 1});
  ecology.run_until(1.0);
}
