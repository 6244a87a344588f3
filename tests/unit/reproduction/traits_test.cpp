// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <map>
#include <numeric>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/reproduction/heredity/all_but.hpp>
#include <trophic/reproduction/heredity/crossover.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::traits::List;

namespace {

struct Sight {
  static constexpr std::string_view name = "sight_m";
  static constexpr double first = 8.0, least = 1.0, most = 12.0, sd = 0.5;
};
struct Diet {
  static constexpr std::string_view name = "diet";
  static constexpr double first = 0.5, least = 0.0, most = 1.0, sd = 0.1;
};

/// All that are active, as far as one sees.
struct AsFarAsItSees {
  static constexpr std::string_view name = "as_far_as_it_sees";
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng&) const {
    return view.robots[other].active && view.distance_m(self, other) <= view.trait<Sight>(self);
  }
};

using Seeing = with_traits<with_visibility<rules::Paper, AsFarAsItSees>, List<Sight, Diet>>;

template <class Rules>
[[nodiscard]] Experiment<Rules> short_run(std::uint64_t seed = 1) {
  Experiment<Rules> experiment{.seed = seed};
  experiment.ecology.duration_s = 1500.0;
  return experiment;
}

/// Compares the traits of newborn with those of their parents.
struct SightOfNewborn {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind != observe::EventKind::birth) return;
    const double sight_m = view.trait<Sight>(event.body);
    CHECK(sight_m >= 1.0);
    CHECK(sight_m <= 12.0);
    if (const auto parent = event.individual.parent()) {
      steps += std::abs(sight_m - sight_of.at(*parent));
      inherited += 1;
    } else {
      others_m.push_back(sight_m);
    }
    sight_of[event.individual.id] = sight_m;
  }
  /// Perceived opponents are within sight.
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].adversary) CHECK(view.robots[body].adversary_distance_m <= view.trait<Sight>(body));
    }
  }
  std::map<IndividualId, double> sight_of;
  std::vector<double> others_m;
  double steps = 0.0;
  int inherited = 0;
};

}  // namespace

TEST_CASE("list: founders -> one mutation from the first value, offspring one from their parent, rules read it") {
  Ecology<Seeing> ecology{short_run<Seeing>(), backend::Kinematic::Params{}};
  SightOfNewborn births;
  ecology.run_until(1500.0, births);
  REQUIRE(births.inherited > 20);
  CHECK(births.steps / births.inherited == doctest::Approx(0.5 * 0.798).epsilon(0.3));
  REQUIRE(births.others_m.size() > 30);
  const double mean_m = std::accumulate(births.others_m.begin(), births.others_m.end(), 0.0) / double(births.others_m.size());
  CHECK(mean_m == doctest::Approx(8.0).epsilon(0.05));
  CHECK(std::ranges::count(births.others_m, 8.0) == 0);
}

TEST_CASE("list: shadow and a heredity without traits -> traits drawn anew") {
  const auto spread = [](auto experiment) {
    Ecology ecology{std::move(experiment), backend::Kinematic::Params{}};
    SightOfNewborn births;
    ecology.run_until(1500.0, births);
    REQUIRE(births.inherited > 20);
    return births.steps / births.inherited;
  };
  const double two_draws = 0.5 * 0.798 * std::sqrt(2.0);
  CHECK(spread(under(Null::shadow, short_run<Seeing>())) == doctest::Approx(two_draws).epsilon(0.3));
  CHECK(spread(short_run<with_heredity<Seeing, reproduction::heredity::AllButTraits>>()) ==
        doctest::Approx(two_draws).epsilon(0.3));
}

TEST_CASE("list: parameters by species, of the command line -> kept within their bounds") {
  using Rules = with_traits<rules::Paper, rules::by_species<List<Sight>>>;
  auto experiment = short_run<Rules>();
  experiment.rules.traits.get<predator>().get<0>() = {.first = 3.0, .least = 3.0, .most = 3.0, .sd = 1.0};
  Ecology<Rules> ecology{experiment, backend::Kinematic::Params{}};
  ecology.run_until(2.0);
  const View view = ecology.view();
  for (BodyIndex body = 0; body < view.robots.size(); ++body)
    CHECK((view.trait<Sight>(body) == 3.0) == (view.robots[body].species == predator));
  CHECK(message_of<std::invalid_argument>([&] {
          experiment.rules.traits.get<prey>().get<0>().first = 13.0;
          Ecology<Rules>{experiment, backend::Kinematic::Params{}};
        }) == "rules.traits.sight_m.first = 13: must be >= least, 1, and <= most, 12");
}

TEST_CASE("list: trait that the table does not have -> error that names it") {
  using Rules = with_visibility<rules::Paper, AsFarAsItSees>;
  CHECK(message_of<std::invalid_argument>([] {
          Ecology<Rules> ecology{short_run<Rules>(), backend::Kinematic::Params{}};
          ecology.run_until(2.0);
        }) == "trait sight_m: must be in the list Traits of the rule table");
}

TEST_CASE("list: state read with a bound that individuals are beyond -> refused by bound and count, with a wider one read") {
  Ecology<Seeing> ecology{short_run<Seeing>(), backend::Kinematic::Params{}};
  ecology.run_until(200.0);
  double farthest_m = 0.0;
  for (BodyIndex body = 0; body < ecology.view().robots.size(); ++body)
    farthest_m = std::max(farthest_m, ecology.view().trait<Sight>(body));
  REQUIRE(farthest_m > 8.1);
  Archive archive;
  ecology.persist(archive);
  const std::string state = std::move(archive).bytes();
  const auto read_with = [&](double most_m) {
    auto experiment = short_run<Seeing>();
    experiment.rules.traits.get<0>().most = most_m;
    Ecology<Seeing> other{experiment, backend::Kinematic::Params{}};
    Archive same{state};
    other.persist(same);
  };
  const std::string refused = message_of<std::invalid_argument>([&] { read_with(8.1); });
  CHECK(refused.starts_with("rules.traits.sight_m.most = 8.1: must be >= " + number_text(farthest_m) + ", as "));
  CHECK(refused.ends_with(" living individuals have traits beyond it"));
  CHECK_NOTHROW(read_with(farthest_m));
}

TEST_CASE("list: interrupted run -> the same bytes, with a column for each trait in genomes.csv") {
  const TemporaryFolder folder;
  using Rules = with_heredity<Seeing, reproduction::heredity::Crossover>;
  auto experiment = short_run<Rules>();
  experiment.ecology.duration_s = 400.0;
  check_resumed(experiment, backend::Kinematic::Params{}, folder.path(), {60, 130}, 50.0, [](std::size_t, auto&) {});
  const std::string genomes = content(folder.path() / "whole" / "genomes.csv");
  CHECK(genomes.find(",w14,sight_m,diet\n") != std::string::npos);
  const std::string second = genomes.substr(genomes.find('\n') + 1);
  CHECK(std::ranges::count(second.substr(0, second.find('\n')), ',') == 3 + 15 + 1);
}

TEST_CASE("no traits: genomes without a part for them") {
  Ecology<rules::Paper> ecology{short_run<rules::Paper>(), backend::Kinematic::Params{}};
  CHECK(ecology.view().traits.empty());
  CHECK(ecology.view().robots[0].genome->traits.empty());
}
