// SPDX-License-Identifier: MIT
// A rule table of one's own for Python: the paper's, with death at a fixed age.
#pragma once

#include <trophic/death/senescence/old_age.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/with.hpp>

using MyTable = trophic::named<trophic::with_senescence<trophic::rules::Paper, trophic::death::senescence::OldAge>, "my_table">;
