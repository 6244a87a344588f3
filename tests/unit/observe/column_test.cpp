// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <trophic/io/column.hpp>
#include <trophic/io/tables.hpp>

using namespace trophic;

namespace {

struct NoColumns {};

template <class Row>
void check_columns() {
  std::set<std::string_view> names;
  io::for_each_column<Row>([&](const auto& column) {
    CAPTURE(std::string{column.name});
    CHECK(names.insert(column.name).second);
    CHECK_FALSE(column.help.empty());
    using Kind = std::remove_cvref_t<decltype(column)>;
    if constexpr (!io::is_species_column<Kind>) {
      // a column whose name ends in a unit has that unit
      for (const std::string_view unit : {"s", "m", "rad"}) {
        if (column.name.ends_with("_" + std::string{unit})) CHECK(column.unit == unit);
      }
    }
  });
}

}  // namespace

TEST_CASE("columns: all tables -> unique names with help, ending in their unit") {
  static_assert(io::TableRow<io::EventRow> && !io::TableRow<NoColumns> && !io::TableRow<int>);
  check_columns<io::EventRow>();
  check_columns<io::AgentRow>();
  check_columns<io::TaxonRow>();
  check_columns<io::GenomeRow>();
}
