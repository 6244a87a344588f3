// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <tools/analysis/metrics/velocity.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::test;
using analysis::AgentRow;

using analysis::stored_velocity_samples;
using analysis::velocity_samples;

/// A prey (0) at rest at the origin and a predator (1) on the x axis, at ticks 0 to 6 only.
std::vector<AgentRow> approach(double from_x_m, double to_x_m) {
  std::vector<AgentRow> agents;
  for (std::int64_t tick = 0; tick <= 6; ++tick) {
    const double x_m = from_x_m + (to_x_m - from_x_m) * static_cast<double>(tick) / 6.0;
    agents.push_back(robot(tick, 0, prey, 0.0, 0.0));
    agents.push_back(robot(tick, 1, predator, x_m, 0.0, 0));
  }
  return agents;
}

}  // namespace

TEST_CASE("velocity: approach to the adversary's place within 12 s -> positive") {
  const auto samples = velocity_samples(approach(5.0, 4.4));
  REQUIRE(samples.size() == 1);  // tick 0 only: the others have no tick six later; the prey has no adversary
  CHECK(samples[0].species == predator);
  CHECK(samples[0].time_s == 0.0);
  CHECK(samples[0].velocity_m_s == doctest::Approx(0.6 / 12.0));
  CHECK(velocity_samples(approach(5.0, 5.3))[0].velocity_m_s == doctest::Approx(-0.3 / 12.0));
}

TEST_CASE("the adversary's own walk does not count") {
  auto agents = approach(5.0, 4.4);
  for (AgentRow& row : agents) {
    if (row.id == 0 && row.tick > 0) row.x_m = -100.0;
  }
  CHECK(velocity_samples(agents)[0].velocity_m_s == doctest::Approx(0.6 / 12.0));
}

TEST_CASE("an adversary that dies meanwhile counts with its position at the start") {
  auto agents = approach(5.0, 4.4);
  for (AgentRow& row : agents) {
    if (row.body == 0 && row.tick >= 3) row.id = 77;
  }
  const auto samples = velocity_samples(agents);
  REQUIRE(samples.size() == 1);
  CHECK(samples[0].velocity_m_s == doctest::Approx(0.6 / 12.0));
}

TEST_CASE("a robot that is reborn meanwhile gives no sample") {
  auto agents = approach(5.0, 4.4);
  for (AgentRow& row : agents) {
    if (row.body == 1 && row.tick >= 5) row.id = 78;
  }
  CHECK(velocity_samples(agents).empty());
}

TEST_CASE("no sample without adversary, in an empty run and in one that is too short") {
  auto alone = approach(5.0, 4.4);
  for (AgentRow& row : alone) row.adversary.reset();
  CHECK(velocity_samples(alone).empty());
  CHECK(velocity_samples({}).empty());
  auto brief = approach(5.0, 4.4);
  brief.resize(brief.size() - 2);
  const auto samples = velocity_samples(brief);
  CHECK(samples.empty());
  CHECK_FALSE(analysis::velocity(samples, predator, analysis::Group::all).mean_of_points());
  CHECK(analysis::velocity(samples, predator, analysis::Group::all).series().empty());
}

TEST_CASE("the stored adversary is kept while its robot is blind, and follows the body that it lived in") {
  // The predator sees the prey at tick 0 only; from then on the prey stands elsewhere, and is another individual.
  std::vector<AgentRow> agents;
  for (std::int64_t tick = 0; tick <= 7; ++tick) {
    agents.push_back(robot(tick, tick == 0 ? 0 : 77, prey, tick == 0 ? 0.0 : 10.0, 0.0));
    agents[agents.size() - 1].body = 0;
    agents.push_back(robot(tick, 1, predator, 5.0 + 0.1 * static_cast<double>(tick), 0.0,
                           tick == 0 ? std::optional<IndividualId>{0} : std::nullopt));
  }
  CHECK(velocity_samples(agents).size() == 1);
  const auto samples = stored_velocity_samples(agents);
  REQUIRE(samples.size() == 2);
  CHECK(samples[0].velocity_m_s == doctest::Approx(-0.6 / 12.0));  // away from where it was seen
  CHECK(samples[1].velocity_m_s == doctest::Approx(0.6 / 12.0));   // towards where its body is now
}

TEST_CASE("the stored adversary outlives a birth: the next one in the body has it") {
  std::vector<AgentRow> agents;
  for (std::int64_t tick = 0; tick <= 7; ++tick) {
    agents.push_back(robot(tick, 0, prey, 0.0, 0.0));
    agents.push_back(robot(tick, tick == 0 ? 1 : 78, predator, 5.0 - 0.1 * static_cast<double>(tick), 0.0,
                           tick == 0 ? std::optional<IndividualId>{0} : std::nullopt));
    agents[agents.size() - 1].body = 1;
  }
  const auto samples = stored_velocity_samples(agents);
  REQUIRE(samples.size() == 1);  // at tick 1; the individual of tick 0 is dead at tick 6
  CHECK(samples[0].time_s == 2.0);
  CHECK(samples[0].velocity_m_s == doctest::Approx(0.6 / 12.0));
}

TEST_CASE("velocity: body that has never perceived a robot -> no stored adversary") {
  auto alone = approach(5.0, 4.4);
  for (AgentRow& row : alone) row.adversary.reset();
  CHECK(stored_velocity_samples(alone).empty());
  CHECK(stored_velocity_samples({}).empty());
  CHECK(stored_velocity_samples(approach(5.0, 4.4)).size() == 1);
}

TEST_CASE("velocity: robot inactive at the start of the stretch -> not in group active") {
  auto agents = approach(5.0, 4.4);
  for (AgentRow& row : agents) row.active = row.tick > 0;
  CHECK_FALSE(analysis::velocity(velocity_samples(agents), predator, analysis::Group::active).mean_of_points());
  for (AgentRow& row : agents) row.active = row.tick == 0;
  CHECK(*analysis::velocity(velocity_samples(agents), predator, analysis::Group::active).mean_of_points() ==
        doctest::Approx(0.6 / 12.0));
}

TEST_CASE("velocity_points: stretches that end at 200, 400, ..., 6000 s -> 30 points") {
  // A predator that walks 1 m from 188 to 200 s, ..., and stands in between, towards a prey at rest.
  std::vector<AgentRow> agents;
  double x_m = 100.0;
  for (std::int64_t tick = 0; tick <= 3000; ++tick) {
    if (tick > 0 && (tick - 1) % 100 >= 94) x_m -= 1.0 / 6.0;
    agents.push_back(robot(tick, 0, prey, 0.0, 0.0));
    agents.push_back(robot(tick, 1, predator, x_m, 0.0, 0));
  }
  const auto points = analysis::samples_at_marks(velocity_samples(agents), agents);
  REQUIRE(points.size() == 30);
  CHECK(points.front().end_s == 200.0);
  CHECK(points.back().end_s == 6000.0);
  const auto curve = analysis::velocity(points, predator, analysis::Group::all);
  CHECK(*curve.mean_of_points() == doctest::Approx(1.0 / 12.0));
  CHECK(curve.series().front().time_s == 200.0);
  CHECK(*analysis::velocity(velocity_samples(agents), predator, analysis::Group::all).mean_of_points() < 0.5 / 12.0);
}

TEST_CASE("velocity_points: no row at the mark -> the next stretch that ends after it") {
  std::vector<AgentRow> agents;
  for (std::int64_t tick = 0; tick <= 210; tick += 3) {
    agents.push_back(robot(tick, 0, prey, 0.0, 0.0));
    agents.push_back(robot(tick, 1, predator, 5.0, 0.0, 0));
  }
  const auto points = analysis::samples_at_marks(velocity_samples(agents), agents);
  REQUIRE(points.size() == 2);
  CHECK(points[0].end_s == 204.0);
  CHECK(points[1].end_s == 402.0);
  const auto brief = approach(5.0, 4.4);
  CHECK(analysis::samples_at_marks(velocity_samples(brief), brief).empty());
  CHECK(analysis::samples_at_marks({}, {}).empty());
}

TEST_CASE("velocity is split by origin and averaged in windows of 200 s: 30 points in 6000 s") {
  std::vector<analysis::VelocitySample> samples;
  for (double time_s = 0.0; time_s <= 5988.0; time_s += 2.0) {
    samples.push_back({.time_s = time_s, .species = prey, .origin = Origin::random, .velocity_m_s = 1.0});
    samples.push_back(
        {.time_s = time_s, .species = prey, .origin = Origin::inherited, .velocity_m_s = time_s <= 200.0 ? 3.0 : 5.0});
  }
  const auto inherited = analysis::velocity(samples, prey, analysis::Group::inherited);
  REQUIRE(inherited.series().size() == 30);
  CHECK(*inherited.series()[0].value == 3.0);
  CHECK(inherited.series()[0].time_s == 200.0);
  CHECK(*inherited.series()[1].value == 5.0);
  CHECK(*inherited.mean_of_points() == doctest::Approx((3.0 + 29.0 * 5.0) / 30.0));
  CHECK(*analysis::velocity(samples, prey, analysis::Group::random).mean_of_points() == 1.0);
  CHECK(*analysis::velocity(samples, prey, analysis::Group::all).series()[0].value == doctest::Approx(2.0));
  CHECK_FALSE(analysis::velocity(samples, predator, analysis::Group::all).mean_of_points());
}
