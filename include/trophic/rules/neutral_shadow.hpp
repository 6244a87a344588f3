// SPDX-License-Identifier: MIT
// The null of a rule table: the same table without inheritance.
#pragma once

#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::rules {

/// The neutral shadow of a table: the same rules and numbers, but every inherited genome is drawn anew. Labels, places and times
/// of birth come about as in the table itself, so a metric that differs between the two shows what inheritance does.
template <class Table>
using neutral_shadow = with_heredity<Table, reproduction::heredity::NothingInherited>;

}  // namespace trophic::rules
