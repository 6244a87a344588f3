// SPDX-License-Identifier: MIT
// The neutral null: a run that repeats what happened in another one.
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/run.hpp>

using namespace trophic;

namespace {

/// The events of a run but switches of tags, as a history, and the weights of newborns.
struct Writer {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::birth) weights.push_back(event.individual.genome->weights);
    if (event.kind == observe::EventKind::birth) traits.push_back(event.individual.genome->traits);
    if (event.kind == observe::EventKind::tag_switch) return;
    history.push_back({.tick = view.tick,
                       .kind = event.kind,
                       .body = event.body,
                       .id = event.individual.id,
                       .species = event.individual.species,
                       .origin = event.individual.origin,
                       .parents = event.individual.parents,
                       .cause = event.cause,
                       .killer_or_victim = event.other});
  }
  History history;
  std::vector<std::vector<double>> weights;
  std::vector<std::vector<double>> traits;  ///< by id
};

struct HeritableSight {
  static constexpr std::string_view name = "sight_m";
  static constexpr double first = 6.0, least = 1.0, most = 12.0, sd = 0.5;
};

auto fields(const Happening& event) {
  return std::tuple{event.tick,    event.kind,    event.body,
                    event.id,      event.species, event.origin,
                    event.parents, event.cause,   event.killer_or_victim};
}

}  // namespace

TEST_CASE_TEMPLATE("history: a run repeated -> its events with other genomes", Rules, rules::Paper, rules::Released) {
  Writer of_run;
  Ecology<Rules>{{.seed = 3}, backend::Kinematic::Params{}}.run_until(1500.0, of_run);
  const auto history = std::make_shared<const History>(of_run.history);
  Writer of_null;
  Ecology<Rules>{{.seed = 3, .null = Null::neutral, .history = history}, backend::Kinematic::Params{}}.run_until(1500.0, of_null);
  REQUIRE(of_run.history.size() > 150);
  REQUIRE(of_null.history.size() == of_run.history.size());
  for (std::size_t i = 0; i < of_run.history.size(); ++i) CHECK(fields(of_null.history[i]) == fields(of_run.history[i]));
  CHECK(of_null.weights != of_run.weights);
  CHECK(of_null.weights.front() != of_run.weights.front());
}

TEST_CASE(
    "nulls: table with traits -> the neutral null inherits other ones by the same parents, clones have the first founder's") {
  using Rules = with_traits<rules::Paper, reproduction::traits::List<HeritableSight>>;
  const auto written = [](const Experiment<Rules>& experiment) {
    Writer writer;
    Ecology<Rules>{experiment, backend::Kinematic::Params{}}.run_until(1500.0, writer);
    return writer;
  };
  const Writer of_run = written({.seed = 3});
  const Writer of_null = written({.seed = 3, .null = Null::neutral, .history = std::make_shared<const History>(of_run.history)});
  const Writer of_clones = written({.seed = 3, .null = Null::clones});
  REQUIRE(of_null.traits.size() == of_run.traits.size());
  double steps_m = 0.0;
  std::size_t inherited = 0;
  for (const Happening& event : of_null.history) {
    if (event.kind != observe::EventKind::birth) continue;
    CHECK(of_null.traits.at(event.id) != of_run.traits.at(event.id));
    if (event.parents.empty()) continue;
    steps_m += std::abs(of_null.traits.at(event.id).at(0) - of_null.traits.at(event.parents[0]).at(0));
    ++inherited;
  }
  REQUIRE(inherited > 20);
  CHECK(steps_m / static_cast<double>(inherited) == doctest::Approx(0.5 * std::sqrt(2.0 / std::numbers::pi)).epsilon(0.4));
  for (const std::vector<double>& traits : of_clones.traits) CHECK(traits == of_run.traits.front());
}

TEST_CASE("history: none, or of other founders -> refused") {
  Ecology<rules::Paper> without{{.null = Null::neutral}, backend::Kinematic::Params{}};
  CHECK_THROWS_WITH(without.run_until(10.0), "a neutral null: needs the history of a run");
  auto history = std::make_shared<History>(5, Happening{.species = 1});
  Ecology<rules::Paper> ecology{{.null = Null::neutral, .history = history}, backend::Kinematic::Params{}};
  CHECK_THROWS_WITH(ecology.run_until(10.0), "a history with different founders");
}
