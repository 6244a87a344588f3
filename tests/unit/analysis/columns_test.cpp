// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sstream>
#include <tools/analysis/report/columns.hpp>

TEST_CASE("Columns: cells -> columns as wide as the widest, no blanks at the ends of lines, headings hold no column") {
  trophic::analysis::Columns columns{{"metric", "mean", "p"}};
  CHECK(columns.empty());
  columns.add({"a long name of a metric"});
  columns.add({"deaths", "1.5", ""});
  columns.add({"m² of floor", "10.25", "0.01"});
  CHECK_FALSE(columns.empty());
  std::ostringstream out;
  columns.print(out, "  ");
  CHECK(out.str() ==
        "  metric       mean   p\n"
        "  a long name of a metric\n"
        "  deaths       1.5\n"
        "  m² of floor  10.25  0.01\n");
}
