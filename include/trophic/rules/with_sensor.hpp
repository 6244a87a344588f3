// SPDX-License-Identifier: MIT
// A table with one sensor swapped.
#pragma once

#include <trophic/rules/table.hpp>

namespace trophic::rules {

namespace detail {

template <class Sensors, class Old, class New>
struct swap_sensor {
  static_assert(Sensors::template contains<Old>, "with_sensor: the table's Sensors have no such sensor to swap");
  using type = typename Sensors::template Replaced<Old, New>;
};

}  // namespace detail

/// The table with the sensor New in place of Old, and the numbers of its sensors at their own defaults.
template <class Table, class Old, class New>
using with_sensor = with_sensors<Table, typename detail::swap_sensor<typename Table::Sensors, Old, New>::type>;

}  // namespace trophic::rules
