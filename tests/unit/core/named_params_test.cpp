// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/backend/contract.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/params/parse_toml.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

const NamedParam& find(const NamedParams& named_params, const std::string& path) {
  for (const NamedParam& param : named_params) {
    if (param.path == path) return param;
  }
  FAIL("no number " << path);
  throw std::logic_error{path};
}

}  // namespace

TEST_CASE("named params: numbers, switches, texts and names -> paths with help") {
  const NamedParams rules = named_params_of(RuleParams<rules::Released>{});
  CHECK(value_text(find(rules, "tag_switch.period_s")) == "100");
  CHECK(value_text(find(rules, "sensors.distance_over_scale.full_scale_m")) == "20");
  CHECK(value_text(find(rules, "genome_source.random_share")) == "0.34");
  CHECK(std::get<std::int64_t>(find(rules, "starvation.interval.base_ticks").value) == 25);
  CHECK_FALSE(find(rules, "tag_switch.period_s").help.empty());
  const NamedParams physics = named_params_of(Physics{});
  CHECK(value_text(find(physics, "integrator")) == "semi_implicit_euler");
  CHECK(std::get<double>(find(physics, "timestep_s").value) == 0.0012);
  CHECK(value_text(find(named_params_of(EcologyParams{}), "robot")) == "spider");
}

TEST_CASE("named params: text of a number -> read as the same number") {
  for (const auto& [value, text] :
       {std::pair{-0.0, "-0.0"}, std::pair{0.0, "0"}, std::pair{2.0, "2"}, std::pair{0x1p53 + 2, "9007199254740994.0"},
        std::pair{1.2345678901234567e19, "12345678901234567168.0"}, std::pair{1e20, "1e+20"}}) {
    CHECK(value_text({.path = "", .value = value, .help = ""}) == text);
    CHECK(std::bit_cast<std::uint64_t>(parse_toml("a=" + std::string{text})["a"].value<double>().value()) ==
          std::bit_cast<std::uint64_t>(value));
  }
}

TEST_CASE("named params: rule table -> every number once") {
  const NamedParams named_params = named_params_of(RuleParams<rules::Paper>{});
  for (std::size_t i = 0; i < named_params.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK(named_params[i].path != named_params[j].path);
  }
  CHECK(named_params.size() > 15);
}

TEST_CASE("named params: texts -> FNV-1a") {
  CHECK(hash_text("") == "cbf29ce484222325");
  CHECK(hash_text("a") == "af63dc4c8601ec8c");
  CHECK(hash_text("foobar") == "85944171f73967e8");
}
