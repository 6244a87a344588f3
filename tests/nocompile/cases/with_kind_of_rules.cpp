// SPDX-License-Identifier: MIT
// death is a kind of rules, with six slots.
// expect: death is a kind of rules, not a slot; its slots are swapped by with_activation
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
using Rules = trophic::with_senescence<trophic::rules::Paper, trophic::death::senescence::OldAge>;
#else
using Rules = trophic::with_death<trophic::rules::Paper, trophic::death::senescence::OldAge>;
#endif

int main() {}
