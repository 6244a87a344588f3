// SPDX-License-Identifier: MIT
// A misspelt number of a named type is said by its name.
// expect: sed
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

int main() {
  using Ecology = trophic::Ecology<trophic::rules::Paper>;
#ifdef VALID
  Ecology ecology(Ecology::Params{.seed = 42}, trophic::backend::Kinematic::Params{});
#else
  Ecology ecology(Ecology::Params{.sed = 42}, trophic::backend::Kinematic::Params{});
#endif
}
