// SPDX-License-Identifier: MIT
// Whole runs: balances, floors, lineages, starvation intervals, reproducibility, observers.
#include <doctest/doctest.h>

#include <map>
#include <set>
#include <support/hand_population.hpp>
#include <support/recorder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using observe::Event;
using observe::EventKind;

namespace {

/// Follows every event and tick of a run and checks what must hold in any.
struct Auditor {
  explicit Auditor(std::size_t bodies) : founders{bodies} {}

  void on_event(const Event& event, const View& view) {
    if (promised) {
      CHECK(event.kind == promised->kind);
      CHECK(event.body == promised->body);
      if (promised->kind == EventKind::death) {
        CHECK(event.individual.id == promised->id);
        CHECK(event.cause == Cause::caught);
        CHECK(event.other == promised->killer);
      }
      promised.reset();
    } else {
      CHECK(((event.kind == EventKind::birth) == (births < founders)));  // later births follow deaths
    }
    if (event.kind == EventKind::birth) birth(event);
    if (event.kind == EventKind::death) death(event, view);
    if (event.kind == EventKind::capture) {
      ++catches;
      CHECK(event.individual.fed_tick == view.tick);
      BodyIndex victim = 0;
      while (view.robots[victim].id != event.other) ++victim;
      CHECK(view.robots[victim].active);
      CHECK(view.web.eats(event.individual.species, view.robots[victim].species));
      promised = Promise{.kind = EventKind::death, .body = victim, .id = *event.other, .killer = event.individual.id};
    }
    if (event.kind == EventKind::activation) CHECK(view.web.is_hunted(event.individual.species));
    if (event.kind == EventKind::tag_switch) {
      CHECK(event.individual.tag_since_s == view.time_s);
      CHECK(view.time_s - tag_since_s[event.individual.id] >= cool_down_s);
      tag_since_s[event.individual.id] = view.time_s;
    }
  }

  void birth(const Event& event) {
    const Individual& born = event.individual;
    CHECK(born.id == births);
    ++births;
    if (born.parent()) {
      CHECK(*born.parent() < born.id);
      CHECK(born.origin == Origin::inherited);
      CHECK(born.mutation_distance > 0.0);
      ++with_parent;
    }
    if (born.origin == Origin::inherited) ++inherited;
    tag_since_s[born.id] = born.born_s;
    genomes.try_emplace(born.genome->id, born.genome, born.genome->weights);
  }

  void death(const Event& event, const View& view) {
    ++deaths;
    ++by_cause[*event.cause];
    CHECK(((event.cause == Cause::caught) == event.other.has_value()));
    if (event.cause == Cause::starved) starved_at = {view.tick, view.count_hunters()};
    if (event.cause == Cause::sacrificed) ++sacrificed_now;
    promised = Promise{.kind = EventKind::birth, .body = event.body};
  }

  void on_tick(const View& view) {
    CHECK_FALSE(promised);
    CHECK(view.robots.size() == founders);
    CHECK(view.tick == ticks);
    ++ticks;
    CHECK(births - founders == deaths);
    std::size_t total = 0;
    for (Species species = 0; species < view.web.size(); ++species) {
      fewest[species] = std::min(fewest.contains(species) ? fewest[species] : founders, view.count(species));
      total += view.count(species);
    }
    CHECK(total == founders);
    CHECK(sacrificed_now <= view.web.size());
    for (const Individual& individual : view.robots) {
      CHECK((individual.tag == 1 || individual.tag == -1));
      CHECK((individual.active || view.web.is_hunted(individual.species)));
      if (!individual.adversary) continue;
      CHECK(view.web.opponents(individual.species, view.robots[*individual.adversary].species));
      CHECK(individual.adversary_distance_m ==
            view.distance_m(static_cast<BodyIndex>(&individual - view.robots.data()), *individual.adversary));
    }
    const bool starved = starved_at && starved_at->first == view.tick;
    hunters_when_starving.push_back(starved ? starved_at->second : view.count_hunters() - sacrificed_now);
    starvation.push_back(starved);
    sacrificed_now = 0;
  }

  [[nodiscard]] std::size_t changed_genomes() const {
    std::size_t changed = 0;
    for (const auto& [id, genome] : genomes)
      if (genome.first->weights != genome.second) ++changed;
    return changed;
  }

  struct Promise {
    EventKind kind;
    BodyIndex body;
    IndividualId id = 0;
    std::optional<IndividualId> killer = {};
  };
  std::size_t founders;
  double cool_down_s = 50.0;
  std::int64_t ticks = 0;
  std::size_t births = 0;
  std::size_t deaths = 0;
  std::size_t catches = 0;
  std::size_t inherited = 0;
  std::size_t with_parent = 0;
  std::size_t sacrificed_now = 0;
  std::map<Cause, std::size_t> by_cause;
  std::map<Species, std::size_t> fewest;
  std::map<IndividualId, double> tag_since_s;
  std::map<std::uint64_t, std::pair<std::shared_ptr<Genome>, std::vector<double>>> genomes;  ///< with the weights when first seen
  std::optional<Promise> promised;                                                           ///< what the next event must be
  std::optional<std::pair<std::int64_t, std::size_t>> starved_at;
  std::vector<std::size_t> hunters_when_starving;  ///< at each tick, after catches and before starvation
  std::vector<bool> starvation;                    ///< at each tick
};

template <class Rules>
std::vector<std::string> record(typename Ecology<Rules>::Params params, double until_s) {
  Ecology<Rules> ecology{params, backend::Kinematic::Params{}};
  test::Recorder recorder;
  ecology.run_until(until_s, recorder);
  return recorder.all;
}

}  // namespace

TEST_CASE("runs: paper's rules, 6000 s -> balances and floors hold") {
  for (const auto seed : {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{3}}) {
    CAPTURE(seed);
    Ecology<rules::Paper> ecology{{.seed = seed}, backend::Kinematic::Params{}};
    Auditor audit{30};
    ecology.run_until(6000.0, audit);
    CHECK(audit.ticks == 3001);
    CHECK(audit.fewest[test::prey] >= 7);
    CHECK(audit.fewest[test::predator] >= 7);
    CHECK(audit.inherited == audit.with_parent);
    CHECK(audit.changed_genomes() == 0);
    CHECK(audit.catches == audit.by_cause[Cause::caught]);
    CHECK(audit.by_cause[Cause::caught] > 10);
    CHECK(audit.by_cause[Cause::starved] > 10);
    CHECK(audit.by_cause[Cause::senescence] == 0);
    CHECK(audit.with_parent > 10);
  }
}

TEST_CASE("runs: released rules, 6000 s -> balances and floors hold") {
  for (const auto seed : {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{3}}) {
    CAPTURE(seed);
    Ecology<rules::Released> ecology{{.seed = seed}, backend::Kinematic::Params{}};
    Auditor audit{30};
    audit.cool_down_s = 100.0;
    ecology.run_until(6000.0, audit);
    CHECK(audit.ticks == 3001);
    CHECK(audit.fewest[test::prey] >= 6);
    CHECK(audit.fewest[test::predator] >= 8);
    CHECK(audit.inherited >= audit.with_parent);
    CHECK(audit.changed_genomes() > 0);
    CHECK(audit.by_cause[Cause::starved] > 10);
    CHECK(audit.with_parent > 10);
  }
}

TEST_CASE("runs: paper's rules -> starvation procedures 25 - p ticks apart, p after the last one") {
  using Rules =
      with_starvation_exemption<rules::Paper, death::starvation::exemption::NoExemption>;  // so that each procedure has a victim
  Ecology<Rules> ecology{{.seed = 4}, backend::Kinematic::Params{}};
  Auditor audit{30};
  ecology.run_until(6000.0, audit);
  std::int64_t next = 25 - 14;
  std::size_t procedures = 0;
  std::set<std::int64_t> intervals;
  for (std::int64_t tick = 0; tick < audit.ticks; ++tick) {
    const auto at = static_cast<std::size_t>(tick);
    CAPTURE(tick);
    CHECK(audit.starvation[at] == (tick == next));
    if (tick != next) continue;
    ++procedures;
    const auto left = static_cast<std::int64_t>(audit.hunters_when_starving[at]) - 1;
    intervals.insert(25 - left);
    next += std::max<std::int64_t>(2, 25 - left);
  }
  CHECK(procedures > 100);
  CHECK(intervals.size() >= 3);
}

TEST_CASE("runs: released rules -> a predator starves after 50 - 2 p seconds, p of this tick and above 7") {
  Ecology<rules::Released> ecology{{.seed = 5}, backend::Kinematic::Params{}};
  Auditor audit{30};
  audit.cool_down_s = 100.0;
  ecology.run_until(6000.0, audit);
  double last_s = 0.0;
  std::size_t starved = 0;
  for (std::size_t tick = 1; tick < audit.starvation.size(); ++tick) {
    const double time_s = 2.0 * static_cast<double>(tick);
    const auto p = static_cast<double>(audit.hunters_when_starving[tick]);
    CAPTURE(tick);
    CHECK(audit.starvation[tick] == (p > 7.0 && time_s - last_s >= std::max(4.0, 50.0 - 2.0 * p)));
    if (!audit.starvation[tick]) continue;
    last_s = time_s;
    ++starved;
  }
  CHECK(starved > 100);
}

TEST_CASE("runs: same seed -> same bits, another seed -> another run") {
  const auto paper = record<rules::Paper>({.seed = 6}, 1000.0);
  CHECK(record<rules::Paper>({.seed = 6}, 1000.0) == paper);
  CHECK(record<rules::Paper>({.seed = 7}, 1000.0) != paper);
  const auto released = record<rules::Released>({.seed = 6}, 1000.0);
  CHECK(record<rules::Released>({.seed = 6}, 1000.0) == released);
  CHECK(record<rules::Released>({.seed = 7}, 1000.0) != released);
  CHECK(paper != released);
}

TEST_CASE("runs: observers and pauses -> same run") {
  const auto alone = record<rules::Paper>({.seed = 8}, 800.0);
  Ecology<rules::Paper> ecology{{.seed = 8}, backend::Kinematic::Params{}};
  test::Recorder recorder;
  Auditor audit{30};
  struct Counter {
    int starts = 0;
    int ends = 0;
    void on_start(const observe::RunDescription&, const View&) { ++starts; }
    void on_end(const View&) { ++ends; }
  } counter;
  ecology.run_until(0.0, recorder, audit, counter);
  ecology.run_until(501.0, counter, recorder, audit);
  ecology.run_until(502.0, recorder, audit, counter);
  ecology.run_until(800.0, audit, recorder, counter);
  CHECK(recorder.all == alone);
  CHECK(counter.starts == 4);
  CHECK(counter.ends == 4);

  Ecology<rules::Paper> unobserved{{.seed = 8}, backend::Kinematic::Params{}};
  unobserved.run_until(800.0);
  CHECK(unobserved.view().robots[7].id == ecology.view().robots[7].id);
  CHECK(unobserved.view().poses[7].x_m == ecology.view().poses[7].x_m);
}

TEST_CASE("runs: observer throws -> on_failure for all, no on_end, exception rethrown") {
  struct Thrower {
    void on_tick(const View& view) {
      if (view.tick == 5) throw std::runtime_error{"disk full"};
    }
    void on_failure(std::string_view what) { told = what; }
    std::string told;
  } thrower;
  struct Other {
    void on_end(const View&) { ended = true; }
    void on_failure(std::string_view what) { told = what; }
    bool ended = false;
    std::string told;
  } other;
  Ecology<rules::Paper> ecology{{.seed = 9}, backend::Kinematic::Params{}};
  CHECK_THROWS_WITH_AS(ecology.run_until(100.0, other, thrower), "disk full", std::runtime_error);
  CHECK(thrower.told == "disk full");
  CHECK(other.told == "disk full");
  CHECK_FALSE(other.ended);
}

TEST_CASE("runs: observer stops -> clean end after that tick") {
  struct Stop {
    void on_tick(const View& view) { last = view.tick; }
    [[nodiscard]] bool keep_running() const { return last < 10; }
    void on_end(const View& view) { ended_at = view.tick; }
    std::int64_t last = -1;
    std::int64_t ended_at = -1;
  } stop;
  Ecology<rules::Paper> ecology{{.seed = 10}, backend::Kinematic::Params{}};
  ecology.run_until(100.0, stop);
  CHECK(ecology.tick() == 10);
  CHECK(stop.ended_at == 10);
  ecology.run_until(100.0);
  CHECK(ecology.tick() == 50);
}

namespace {

/// 30 bodies: 14 plants, 9 grazers, 7 hunters.
struct Pasture {
  static constexpr std::string_view name = "pasture";
  [[nodiscard]] FoodWeb web() const { return test::chain_web(); }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const {
    std::vector<Species> species(robots, test::plant);
    for (std::size_t body = 14; body < robots; ++body) species[body] = body < 23 ? test::grazer : test::hunter;
    return species;
  }
};

}  // namespace

TEST_CASE("runs: food chain of three species -> survives under both rule tables") {
  const auto live = [](auto ecology) {
    Auditor audit{30};
    const auto& clock = ecology->params().rules.tag_switch;
    if constexpr (requires { clock.period_s; }) {
      audit.cool_down_s = clock.period_s;
    } else {
      audit.cool_down_s = clock.cool_down_s;
    }
    ecology->run_until(2000.0, audit);
    CHECK(audit.ticks == 1001);
    CHECK(audit.by_cause[Cause::caught] > 0);
    CHECK(audit.by_cause[Cause::starved] > 0);
    CHECK(ecology->view().web.size() == 3);
  };
  using Paper = with_community<rules::Paper, Pasture>;
  using Released = with_community<rules::Released, Pasture>;
  for (const auto seed : {std::uint64_t{11}, std::uint64_t{12}}) {
    CAPTURE(seed);
    live(std::make_unique<Ecology<Paper>>(typename Ecology<Paper>::Params{.seed = seed}, backend::Kinematic::Params{}));
    live(std::make_unique<Ecology<Released>>(typename Ecology<Released>::Params{.seed = seed}, backend::Kinematic::Params{}));
  }
}
