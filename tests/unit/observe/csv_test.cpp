// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <trophic/io/csv.hpp>
#include <trophic/support/rng.hpp>
#include <tuple>
#include <vector>

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

TEST_CASE("csv: cells -> exact or with decimals, empty without a value, commas quoted") {
  CHECK(io::header_of<Row>() == "exact,rounded,none,yes,text\n");
  const FoodWeb web{{}, {}};
  std::string text;
  io::append_row(text, Row{}, web);
  CHECK(text == "0.1,0.666667,,1,plain\n");
  text.clear();
  io::append_row(text, Row{.exact = std::numeric_limits<double>::quiet_NaN(), .none = 3, .yes = false, .text = "a,b"}, web);
  CHECK(text == ",0.666667,3,0,\"a,b\"\n");
}

TEST_CASE("csv: numbers with one to seven decimals -> the digits of std::to_chars") {
  std::vector<double> numbers{0.0, 1.0 / 128, 3.0 / 128, 0.5, 1.5, 2.5, 1e-320, 9.9999999, 0x1p40, 123456.7, 1e300};
  numbers.push_back(std::numeric_limits<double>::infinity());
  Rng rng{5, Stream::user};
  for (int i = 0; i < 20000; ++i) numbers.push_back(std::exp(rng.uniform(-25.0, 35.0)));
  for (int i = 0; i < 2000; ++i) numbers.push_back(std::round(rng.uniform(-1e5, 1e5)) * 0.0000005);
  for (const double number : numbers) {
    for (const int decimals : {1, 6, 7}) {
      for (const double value : {number, -number}) {
        std::array<char, 400> digits;
        const auto end =
            std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
        std::string text;
        io::detail::append_cell(text, value, {.decimals = decimals});
        REQUIRE(text == std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
      }
    }
  }
}
