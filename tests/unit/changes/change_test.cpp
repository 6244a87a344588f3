// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/changes/change.hpp>
#include <trophic/io/csv.hpp>

using namespace trophic;

namespace {

std::vector<changes::Change> read(const std::string& text) {
  const test::TemporaryFolder folder;
  std::ofstream{folder.path() / "changes.csv"} << text;
  return changes::read_changes(folder.path() / "changes.csv");
}

}  // namespace

TEST_CASE("changes: table of a run, or three columns in any order -> read") {
  const std::vector<changes::Change> expected{{4.0, "rules.a", "0.5"}, {4.0, "rules.b", "true"}, {10.5, "rules.a", "1e-3"}};
  std::string text = io::header_of<changes::ChangeRow>();
  for (const auto& change : expected)
    io::append_row(text, changes::ChangeRow{change.time_s, 2, change.number, change.value, "7"}, {{}, {}});
  CHECK(read(text) == expected);
  CHECK(read("value,number,time_s\r\n0.5,rules.a,4\r\ntrue,rules.b,4\r\n1e-3,rules.a,10.5") == expected);
  CHECK(read("time_s,number,value\n").empty());
}

TEST_CASE("changes: wrong line -> error with its number") {
  for (const auto& [text, what] :
       {std::pair{"", "line 1: the column time_s is missing"},
        std::pair{"time_s,number,value\nx,a,1\n", "line 2: time_s = x: must be >= 0"},
        std::pair{"time_s,number,value\n1 ,a,1\n", "line 2: time_s = 1 : must be >= 0"},
        std::pair{"time_s,number,value\nnan,a,1\n", "line 2: time_s = nan: must be >= 0"},
        std::pair{"time_s,number,value\ninf,a,1\n", "line 2: time_s = inf: must be >= 0"},
        std::pair{"time_s,number,value\n0x10,a,1\n", "line 2: time_s = 0x10: must be >= 0"},
        std::pair{"time_s,number,value\n2,a,1\n1,a,2\n", "line 3: time_s = 1: must be >= 2, as in the line above"},
        std::pair{"time_s,number,value\n2,a\n", "line 2: 2 cells: must be 3, as in the first line"},
        std::pair{"time_s,number,value\n2e8,a,1\n", "line 2: time_s = 2e8: must be >= 0 and <= 1e+08"},
        std::pair{"time_s,number,value\n2,a,\n", "line 2: value: must not be empty"}}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(read(text), doctest::Contains(what), std::invalid_argument);
  }
}

TEST_CASE("changes: as many and as long as a run may have -> read, one more -> refused") {
  std::string text = "time_s,number,value\n";
  const std::string longest(changes::longest_value, '1');
  for (std::size_t i = 0; i < changes::most_changes; ++i) text += "2,a," + longest + "\n";
  CHECK(read(text).size() == changes::most_changes);
  CHECK_THROWS_WITH_AS(read(text + "2,a,1\n"), doctest::Contains("line 20002: must be omitted"), std::invalid_argument);
  CHECK_THROWS_WITH_AS(read("time_s,number,value\n2,a,1" + longest), doctest::Contains("must have <= 200 bytes"),
                       std::invalid_argument);
}
