// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>
#include <optional>
#include <trophic/io/csv.hpp>
#include <tuple>

using namespace trophic;

namespace {

struct Row {
  double exact = 0.1;
  double rounded = 2.0 / 3.0;
  std::optional<int> none = {};
  bool yes = true;
  std::string text = "plain";
  static constexpr auto columns() {
    return std::tuple{io::column("exact", &Row::exact, "", ""), io::column("rounded", &Row::rounded, "m", "", io::micro),
                      io::column("none", &Row::none, "", ""), io::column("yes", &Row::yes, "", ""),
                      io::column("text", &Row::text, "", "")};
  }
};

}  // namespace

TEST_CASE("csv: cells -> exact unless decimals are stated, empty for a missing value, quoted if with a comma") {
  CHECK(io::header_of<Row>() == "exact,rounded,none,yes,text\n");
  const FoodWeb web{{}, {}};
  std::string text;
  io::append_row(text, Row{}, web);
  CHECK(text == "0.1,0.666667,,1,plain\n");
  text.clear();
  io::append_row(text, Row{.exact = std::numeric_limits<double>::quiet_NaN(), .none = 3, .yes = false, .text = "a,b"}, web);
  CHECK(text == ",0.666667,3,0,\"a,b\"\n");
}
