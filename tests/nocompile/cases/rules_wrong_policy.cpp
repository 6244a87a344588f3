// SPDX-License-Identifier: MIT
// A policy of another kind in a slot of a table that is written out.
// expect: the policy in Rules::Reprieve needs bool spared(BodyIndex hunter, const View&) const
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Table : trophic::rules::Paper {
#ifdef VALID
  using Reprieve = trophic::rules::Paper::Reprieve;
#else
  using Reprieve = trophic::rules::Paper::Floor;
#endif
};

int main() {
  trophic::Ecology<Table, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0);
}
