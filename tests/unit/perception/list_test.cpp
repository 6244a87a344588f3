// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/odometer.hpp>
#include <tools/command/read_parameters.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>
#include <trophic/perception/sensors/distance_over_terrain.hpp>
#include <trophic/perception/sensors/list.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>
#include <trophic/perception/sensors/tag_ratio_of_all.hpp>

using namespace trophic;
using perception::SensorList;
using perception::sensors::DistanceOverScale;
using perception::sensors::DistanceOverTerrain;
using perception::sensors::List;
using perception::sensors::SideOfAdversary;
using perception::sensors::TagRatioOfAll;

namespace {

/// Where a robot stands: two numbers.
struct Place {
  static constexpr std::string_view name = "place";
  static constexpr std::size_t size = 2;
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    return {view.poses[self].x_m, view.poses[self].y_m};
  }
};

/// Nothing but noise, of which it draws as much as it is told.
struct Noise {
  static constexpr std::string_view name = "noise";
  static constexpr std::size_t size = 1;
  struct Params {
    std::size_t draws = 1;
    static constexpr auto fields() { return std::tuple{field("draws", &Params::draws, at_least(1))}; }
  };
  Params params;
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>&, const View&, Rng& rng) const {
    const double first = rng.uniform();
    for (std::size_t i = 1; i < params.draws; ++i) rng.uniform();
    return {first};
  }
};
struct OtherNoise : Noise {
  static constexpr std::string_view name = "other_noise";
};

/// How long a robot has seen nobody; its offspring begin with half of that.
struct Loneliness {
  static constexpr std::string_view name = "loneliness";
  static constexpr std::size_t size = 1;
  struct State {
    double ticks = 0.0;
    static constexpr auto fields() { return std::tuple{field("ticks", &State::ticks)}; }
  };
  [[nodiscard]] State born(const Individual&, const State* parent, const State&) const {
    return {.ticks = parent != nullptr ? parent->ticks / 2.0 : 0.0};
  }
  void on_sighting(State& own, BodyIndex, const std::optional<Sighting>& sighting, const View&) const {
    own.ticks = sighting ? 0.0 : own.ticks + 1.0;
  }
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>&, const View&, Rng&,
                                               const State& own) const {
    return {own.ticks};
  }
};

using Sensors = List<Place, TagRatioOfAll, DistanceOverScale>;

template <class Any>
std::vector<double> values(const Any& list, const test::HandPopulation& robots, const std::optional<Sighting>& sighting) {
  const auto all = list.sense(NoState{}, 0, sighting, robots.view(), list.sense_common(robots.view()), [](std::size_t sensor) {
    return Rng{5, Stream::sensors, 0, 0, sensor};
  });
  return {all.begin(), all.end()};
}

}  // namespace

TEST_CASE("list: several sensors -> sizes add up, values in order") {
  static_assert(Sensors::size == 4 && Sensors::count == 3);
  static_assert(Sensors::is_sensor_list && !List<Place, int>::is_sensor_list);
  static_assert(List<>::size == 0);
  const test::HandPopulation robots{{{.x_m = 3.0, .y_m = -2.0, .tag = 1}, {.tag = 1}, {.tag = 1}, {.tag = -1}}};
  CHECK(values(Sensors{}, robots, Sighting{.distance_m = 5.0}) == std::vector<double>{3.0, -2.0, 0.25, 0.25});
  CHECK(values(Sensors{}, robots, std::nullopt) == std::vector<double>{3.0, -2.0, 0.25, 1.0});
  CHECK(values(List<TagRatioOfAll, Place>{}, robots, std::nullopt) == std::vector<double>{0.25, 3.0, -2.0});
}

TEST_CASE("list: name -> names of its sensors") {
  CHECK(Sensors::name == "place + tag_ratio_of_all + distance_over_scale");
  CHECK(List<Place>::name == "place");
}

TEST_CASE("list: numbers -> under the name of each sensor") {
  Sensors::Params params;
  command::read_parameters(params, command::read_assignment("distance_over_scale.full_scale_m=10"));
  const NamedParams settings = named_params_of(params);
  REQUIRE(settings.size() == 1);
  CHECK(settings[0].path == "distance_over_scale.full_scale_m");
  CHECK(value_text(settings[0]) == "10");
  const test::HandPopulation robots{{{}}};
  CHECK(values(make_policy<Sensors>(params), robots, Sighting{.distance_m = 5.0})[3] == 0.5);
  CHECK(first_difference(make_policy<Sensors>(params).params, params) == "");
  CHECK(first_difference(Sensors::with<DistanceOverScale>({.full_scale_m = 10.0}), params) == "");
  CHECK(first_difference(Sensors::Params{}, params) == "distance_over_scale.full_scale_m");
  CHECK_THROWS_WITH_AS(validate(Sensors::with<DistanceOverScale>({.full_scale_m = -1.0}), "rules.sensors"),
                       "rules.sensors.distance_over_scale.full_scale_m = -1: must be > 0", std::invalid_argument);
  CHECK_THROWS_WITH_AS(command::read_parameters(params, command::read_assignment("place.x=1")),
                       "place.x: unknown key; this rule has no parameters", std::invalid_argument);
}

TEST_CASE("list: swap -> sensor replaced in its place") {
  static_assert(
      std::same_as<Sensors::Replaced<DistanceOverScale, DistanceOverTerrain>, List<Place, TagRatioOfAll, DistanceOverTerrain>>);
  static_assert(std::same_as<Sensors::At<1>, TagRatioOfAll>);
  static_assert(Sensors::contains<Place> && !Sensors::contains<SideOfAdversary>);
}

TEST_CASE("list: draws of one sensor -> others unchanged") {
  using Noisy = List<Noise, OtherNoise>;
  const test::HandPopulation robots{{{}}};
  const auto frugal = values(Noisy{}, robots, std::nullopt);
  CHECK(values(Noisy{Noisy::with<Noise>({.draws = 9})}, robots, std::nullopt) == frugal);
  CHECK(frugal[0] != frugal[1]);
}

TEST_CASE("list: sensor with a State -> under its name, hooks called, born by the sensor") {
  using Remembering = List<Place, Loneliness, TagRatioOfAll, test::Odometer>;
  static_assert(!Stateful<Sensors> && Stateful<Remembering> && SensorList<Remembering>);
  const Remembering list;
  const test::HandPopulation robots{{{.x_m = 3.0, .tag = 1}, {.tag = 1}}};
  const View view = robots.view();
  const auto no_stream = [](std::size_t) { return Rng{5, Stream::sensors}; };
  Remembering::State own = list.born(robots.individuals[0], nullptr, {});
  for (int tick = 0; tick < 6; ++tick) list.on_sighting(own, 0, std::nullopt, view);
  list.on_walk(own, 0, 1.5, view);
  CHECK(list.sense(own, 0, std::nullopt, view, list.sense_common(view), no_stream) ==
        Remembering::Values{3.0, 0.0, 6.0, 0.5, 1.5});

  const Remembering::State child = list.born(robots.individuals[1], &own, own);
  CHECK(list.sense(child, 0, std::nullopt, view, {}, no_stream) == Remembering::Values{3.0, 0.0, 3.0, 0.0, 0.0});
  list.on_sighting(own, 0, Sighting{}, view);
  CHECK(list.sense(own, 0, std::nullopt, view, {}, no_stream)[2] == 0.0);

  std::vector<std::string> names;
  for_each_field(own, [&](const auto& f, const auto&) { names.emplace_back(f.name); });
  CHECK(names == std::vector<std::string>{"place", "loneliness", "tag_ratio_of_all", "odometer"});
}
