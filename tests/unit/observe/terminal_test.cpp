// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <string>
#include <trophic/observe/terminal.hpp>

namespace {

using namespace trophic::observe;
const std::array<std::string, 3> parts{"10 of 20 s", "50 %", "1 left"};

TEST_CASE("terminal: parts of a line -> as many whole ones as leave the last column free") {
  CHECK(fitting_line(parts, 200) == "10 of 20 s  50 %  1 left");
  CHECK(fitting_line(parts, 25) == "10 of 20 s  50 %  1 left");
  CHECK(fitting_line(parts, 24) == "10 of 20 s  50 %");
  CHECK(fitting_line(parts, 17) == "10 of 20 s  50 %");
  CHECK(fitting_line(parts, 16) == "10 of 20 s");
  CHECK(fitting_line(parts, 5) == "10 o");
  CHECK(fitting_line(parts, 1).empty());
  CHECK(fitting_line(parts, 0).empty());
  CHECK(fitting_line(std::array<std::string, 3>{"a", "", "b"}, 80) == "a  b");
}

TEST_CASE("terminal: character of several bytes -> takes one column and is never cut") {
  const std::array<std::string, 1> hares{"l\u00e8vres"};
  CHECK(columns_of(hares[0]) == 6);
  CHECK(fitting_line(hares, 7) == hares[0]);
  CHECK(fitting_line(hares, 3) == "l\u00e8");
  CHECK(fitting_line(hares, 2) == "l");
}

TEST_CASE("terminal: no terminal -> width of the environment, else 80") {
  constexpr int no_terminal = -1;
  ::setenv("COLUMNS", "33", 1);
  CHECK(terminal_columns(no_terminal) == 33);
  for (const char* nonsense : {"", "wide", "-3", "0", "99999999999999999999"}) {
    ::setenv("COLUMNS", nonsense, 1);
    CHECK(terminal_columns(no_terminal) == 80);
  }
  ::unsetenv("COLUMNS");
  CHECK(terminal_columns(no_terminal) == 80);
}

}  // namespace
