// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <limits>
#include <string>
#include <tools/command/toml_writer.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/params/parse_toml.hpp>
#include <trophic/params/toml_text.hpp>
#include <trophic/support/rng.hpp>
#include <tuple>
#include <vector>

using namespace trophic;

namespace {

enum class Shade { red, green };
constexpr std::array<std::string_view, 2> enum_names(Shade) {
  return {"red", "green"};
}

struct Gene {
  std::uint32_t id = 3;
  double weight = 0.5;
  bool enabled = true;
  Shade colour = Shade::green;
  static constexpr auto fields() {
    return std::tuple{field("id", &Gene::id), field("weight", &Gene::weight), field("enabled", &Gene::enabled),
                      field("colour", &Gene::colour)};
  }
};

}  // namespace

TEST_CASE("toml: double -> text -> same bits") {
  std::vector<double> values{0.0,
                             -0.0,
                             0.1,
                             1.0,
                             -7.0,
                             1e22,
                             123456789012345678.0,
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};
  Rng rng{1, Stream::null_model};
  while (values.size() < 20'000) {
    const double value = std::bit_cast<double>(rng.bits());
    if (!std::isnan(value)) values.push_back(value);
  }
  TomlWriter writer;
  writer.put("values", values);
  const std::vector<double> read = trophic::detail::TomlTable::parse(writer.text(), "memory").numbers("values");
  REQUIRE(read.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    CAPTURE(values[i]);
    CHECK(std::bit_cast<std::uint64_t>(read[i]) == std::bit_cast<std::uint64_t>(values[i]));
  }
}

TEST_CASE("toml: written numbers -> keys in order, table headings, help as comments") {
  TomlWriter writer;
  writer.put("name", "it's");
  writer.put("colour", Shade::red);
  writer.put("none", std::vector<double>{});
  writer.put("pairs", std::vector<std::pair<int, int>>{{1, 2}, {3, 4}});
  writer.put("genes", std::vector<Gene>(2));
  writer.element("part");
  writer.put("size_m", 2.0, "metres");
  CHECK(writer.text() ==
        "name = \"it's\"\ncolour = 'red'\nnone = []\npairs = [[1, 2], [3, 4]]\n"
        "genes = [\n  { id = 3, weight = 0.5, enabled = true, colour = 'green' },\n"
        "  { id = 3, weight = 0.5, enabled = true, colour = 'green' }\n]\n\n[[part]]\nsize_m = 2.0  # metres\n");
  const auto table = trophic::detail::TomlTable::parse(writer.text(), "memory");
  CHECK(table.text("name") == "it's");
  CHECK(table.tables("genes")[1].truth("enabled"));
}

TEST_CASE("toml: named params -> tables of their paths, below the root") {
  const NamedParams named_params{{"seed", std::int64_t{3}, {}}, {"ecology.tick_s", 2.0, "seconds"}, {"rules.a.b", true, {}}};
  CHECK(toml_text(named_params) == "seed = 3\n\n[ecology]\ntick_s = 2.0  # seconds\n\n[rules.a]\nb = true\n");
  TomlWriter writer;
  writer.put_all(named_params, "made.by");
  CHECK(writer.text() == "[made.by]\nseed = 3\n\n[made.by.ecology]\ntick_s = 2.0  # seconds\n\n[made.by.rules.a]\nb = true\n");
}

TEST_CASE("toml: value in a message -> one line, shortest form") {
  const auto table = parse_toml(
      "a = 0.05\nb = 2.0\nc = [[1, 0.05], [], ['x']]\nd = {e = 1, f.g = nan}\nh = 1979-05-27\ni = \"1\\n2\"\nj = true\nk = "
      "1e300\n");
  const auto text = [&](const char* key) { return toml_text(*table.get(key)); };
  CHECK(text("a") == "0.05");
  CHECK(text("b") == "2.0");
  CHECK(text("c") == "[[1, 0.05], [], ['x']]");
  CHECK(text("d") == "{e = 1, f = {g = nan}}");
  CHECK(text("h") == "1979-05-27");
  CHECK(text("i") == R"("1\n2")");
  CHECK(text("j") == "true");
  CHECK(text("k") == "1e+300");
}
