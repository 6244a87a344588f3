// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <trophic/backend/contract.hpp>
#include <trophic/habitat/world.hpp>
#include <trophic/params/settings.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

const Setting& find(const Settings& settings, const std::string& path) {
  for (const Setting& setting : settings) {
    if (setting.path == path) return setting;
  }
  FAIL("no setting " << path);
  throw std::logic_error{path};
}

}  // namespace

TEST_CASE("settings: numbers, switches, texts and names by their path, with help") {
  const Settings rules = settings_of(RuleParams<rules::Released>{});
  CHECK(value_text(find(rules, "tag_switch.period_s")) == "100");
  CHECK(value_text(find(rules, "sensors.distance_over_scale.full_scale_m")) == "20");
  CHECK(value_text(find(rules, "genome_source.random_share")) == "0.34");
  CHECK(std::get<std::int64_t>(find(rules, "starvation_schedule.base_ticks").value) == 25);
  CHECK_FALSE(find(rules, "tag_switch.period_s").help.empty());
  const Settings physics = settings_of(Physics{});
  CHECK(value_text(find(physics, "integrator")) == "semi_implicit_euler");
  CHECK(std::get<double>(find(physics, "timestep_s").value) == 0.0012);
  CHECK(value_text(find(settings_of(World{}), "robot")) == "spider");
}

TEST_CASE("settings: every number of a rule set once") {
  const Settings settings = settings_of(RuleParams<rules::Paper>{});
  for (std::size_t i = 0; i < settings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK(settings[i].path != settings[j].path);
  }
  CHECK(settings.size() > 15);
}

TEST_CASE("settings: FNV-1a of texts") {
  CHECK(hash_text("") == "cbf29ce484222325");
  CHECK(hash_text("a") == "af63dc4c8601ec8c");
  CHECK(hash_text("foobar") == "85944171f73967e8");
}
