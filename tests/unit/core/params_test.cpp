// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <stdexcept>
#include <trophic/params/params.hpp>
#include <vector>

using namespace trophic;

namespace {

enum class Paint { red, green };
constexpr std::array<std::string_view, 2> enum_names(Paint) {
  return {"red", "green"};
}

struct Inner {
  double share = 0.5;
  static constexpr auto fields() { return std::tuple{field("share", &Inner::share, between(0.0, 1.0), "a share")}; }
};

struct Outer {
  double length_m = 1.0;
  std::int64_t count = 3;
  std::size_t robots = 30;
  bool on = true;
  Paint colour = Paint::green;
  double offset = 0.0;
  double temperature = -5.0;
  Inner inner = {};
  static constexpr auto fields() {
    return std::tuple{field("length_m", &Outer::length_m, above(0.0)),
                      field("count", &Outer::count, at_least(2)),
                      field("robots", &Outer::robots, between(1, 100)),
                      field("on", &Outer::on),
                      field("colour", &Outer::colour),
                      field("offset", &Outer::offset, any_number()),
                      field("temperature", &Outer::temperature, Bound{.upper = 0.0}),
                      field("inner", &Outer::inner)};
  }
};

std::string message(const Outer& params, std::string_view path = "rules.outer") {
  try {
    validate(params, path);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("params: numbers within their bounds, closed bounds included -> accepted") {
  CHECK(message({}) == "");
  CHECK(message({.count = 2}) == "");
  CHECK(message({.robots = 1}) == "");
  CHECK(message({.robots = 100}) == "");
  CHECK(message({.temperature = 0.0}) == "");
  CHECK(message({.inner = {.share = 0.0}}) == "");
  CHECK(message({.inner = {.share = 1.0}}) == "");
  CHECK(message({.length_m = 1e-300}) == "");
  CHECK(message({.offset = -1e300}) == "");
}

TEST_CASE("params: number outside its bound -> error with path, value and bound") {
  CHECK(message({.length_m = 0.0}) == "rules.outer.length_m = 0: must be > 0");
  CHECK(message({.length_m = -1.5}) == "rules.outer.length_m = -1.5: must be > 0");
  CHECK(message({.count = 1}) == "rules.outer.count = 1: must be >= 2");
  CHECK(message({.robots = 0}) == "rules.outer.robots = 0: must be >= 1 and <= 100");
  CHECK(message({.robots = 101}) == "rules.outer.robots = 101: must be >= 1 and <= 100");
  CHECK(message({.temperature = 0.1}) == "rules.outer.temperature = 0.1: must be <= 0");
  CHECK(message({.inner = {.share = 1.0000001}}) == "rules.outer.inner.share = 1.0000001: must be >= 0 and <= 1");
  CHECK(message({.length_m = 0.0}, "") == "length_m = 0: must be > 0");
}

TEST_CASE("params: number that is not finite -> error for every bound") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(message({.length_m = nan}) == "rules.outer.length_m = nan: must be finite");
  CHECK(message({.length_m = infinity}) == "rules.outer.length_m = inf: must be finite");
  CHECK(message({.offset = nan}) == "rules.outer.offset = nan: must be finite");
  CHECK(message({.offset = -infinity}) == "rules.outer.offset = -inf: must be finite");
  CHECK(message({.temperature = -infinity}) == "rules.outer.temperature = -inf: must be finite");
}

TEST_CASE("params: several numbers out of bounds -> error for the first") {
  CHECK(message({.length_m = 0.0, .count = 0}) == "rules.outer.length_m = 0: must be > 0");
}

TEST_CASE("params: fields -> visited in order, writable") {
  Outer params;
  std::vector<std::string> names;
  for_each_field(params, [&](const auto& f, auto& value) {
    names.emplace_back(f.name);
    if constexpr (std::same_as<std::remove_cvref_t<decltype(value)>, double>) value = 0.25;
  });
  CHECK(names == std::vector<std::string>{"length_m", "count", "robots", "on", "colour", "offset", "temperature", "inner"});
  CHECK(params.length_m == 0.25);
  CHECK(params.temperature == 0.25);
  CHECK(params.inner.share == 0.5);
}

TEST_CASE("params: number -> text -> same number") {
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(1.0 / 3.0) == "0.3333333333333333");
  CHECK(number_text(1e-20) == "1e-20");
  CHECK(number_text(std::int64_t{-7}) == "-7");
  CHECK(std::stod(number_text(0.1 + 0.2)) == 0.1 + 0.2);
}

TEST_CASE("params: enumerator -> name") {
  CHECK(enum_name(Paint::red) == "red");
  CHECK(enum_name(Paint::green) == "green");
}

TEST_CASE("params: above_to -> excludes only its lower end") {
  constexpr Bound bound = above_to(0.0, 1.0);
  CHECK(bound.lower_excluded);
  CHECK(bound_text(bound) == "must be > 0 and <= 1");
  CHECK(bound_text(at_least(2)) == "must be >= 2");
  CHECK(bound_text(any_number()) == "must be finite");
}

TEST_CASE("params: two that differ -> path of the first difference, nested ones included") {
  CHECK(first_difference(Outer{}, Outer{}) == "");
  CHECK(first_difference(Outer{}, Outer{.robots = 31, .on = false}) == "robots");
  CHECK(first_difference(Outer{}, Outer{.colour = Paint::red}, "rules.outer") == "rules.outer.colour");
  CHECK(first_difference(Outer{}, Outer{.inner = {.share = 0.25}}) == "inner.share");
}

TEST_CASE("params: seed -> whole number up to 2^53") {
  CHECK(bound_text(any_seed()) == "must be >= 0 and <= 9007199254740992");
  CHECK(detail::within(std::uint64_t{1} << 53U, any_seed()));
  CHECK_FALSE(detail::within((std::uint64_t{1} << 53U) + 1, any_seed()));
  CHECK_FALSE(detail::within(std::numeric_limits<std::uint64_t>::max(), between(0.0, 0x1p63)));
}
