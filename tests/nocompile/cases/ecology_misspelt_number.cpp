// SPDX-License-Identifier: MIT
// A misspelt number in braces fits no constructor. The language gives a library no way to say more; written with the type's name,
// Params{.sed = 42}, both compilers name it.
// expect: no matching
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

int main() {
#ifdef VALID
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
#else
  trophic::Ecology<trophic::rules::Paper> ecology({.sed = 42}, trophic::backend::Kinematic::Params{});
#endif
}
