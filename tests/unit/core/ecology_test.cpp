// SPDX-License-Identifier: MIT
// The order within a tick and what each step does, on scenes of a few robots that stand still.
#include <doctest/doctest.h>

#include <map>
#include <support/hand_population.hpp>
#include <support/recorder.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/death/starvation/exemption/near_remembered_adversary.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/perception/newborn_tag/random_tag.hpp>
#include <trophic/perception/tag_switch/tag_sampling.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <trophic/reproduction/parent/last_seen_victim.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using Lines = std::vector<std::string>;

namespace {

/// Robots where the scene puts them.
struct Places {
  static constexpr std::string_view name = "places";
  static inline std::vector<GroundPose> poses;
  [[nodiscard]] std::vector<GroundPose> place(std::size_t, const Arena&, double, Rng&) const { return poses; }
};

/// One plant, one grazer and one hunter for every three bodies.
struct Chain {
  static constexpr std::string_view name = "chain";
  [[nodiscard]] FoodWeb web() const { return test::chain_web(); }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const {
    std::vector<Species> species(robots);
    for (std::size_t body = 0; body < robots; ++body) species[body] = body % 3;
    return species;
  }
};

/// A brain that always turns right and wants tag -1.
struct AlwaysMinus {
  static constexpr std::string_view name = "always_minus";
  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return 1; }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }
  [[nodiscard]] control::Decision decide(std::span<const double>, std::span<const double>) const {
    return {.target_angle_rad = 0.7, .tag = -1};
  }
};

/// Faces nearly the other way.
struct Backwards {
  static constexpr std::string_view name = "backwards";
  [[nodiscard]] double heading_rad(const Pose& root, double forward_rad) const {
    return wrap_angle(ground_pose(root, forward_rad).heading_rad + 3.0);
  }
};

const backend::Kinematic::Params still{.speed_scale = 0.0, .turn_scale = 0.0};

/// A scene's numbers: nobody moves, no floors, newborn become active at once unless somebody stands on them.
template <class Rules>
typename Ecology<Rules>::Params scene(std::vector<GroundPose> poses, std::size_t predators = 1) {
  Places::poses = std::move(poses);
  typename Ecology<Rules>::Params params;
  params.ecology.robots = Places::poses.size();
  params.rules.activation.distance_m = 0.1;
  params.rules.floor.floor = 0;
  if constexpr (requires { params.rules.community.predators; }) params.rules.community.predators = predators;
  if constexpr (requires { params.rules.minimum_predators.below; }) params.rules.minimum_predators.below = 0;
  return params;
}

using Scene = with_placement<rules::Paper, Places>;
using ChainScene = with_community<Scene, Chain>;

template <class Rules>
Lines events(const typename Ecology<Rules>::Params& params, double until_s) {
  Ecology<Rules> ecology{params, still};
  test::Recorder recorder;
  ecology.run_until(until_s, recorder);
  return recorder.events;
}

/// Those lines of `lines` that begin with "TICK ".
Lines at_tick(std::int64_t tick, const Lines& lines) {
  Lines found;
  for (const std::string& line : lines) {
    if (line.starts_with(std::to_string(tick) + " ")) found.push_back(line.substr(line.find(' ') + 1));
  }
  return found;
}

}  // namespace

TEST_CASE("ecology: start -> births, then at tick 0 activation before catches, each with death and birth") {
  auto params = scene<Scene>({{.x_m = 0.0}, {.x_m = 0.5}});
  CHECK(events<Scene>(params, 0.0) == Lines{"0 birth body 0 id 0 species 0", "0 birth body 1 id 1 species 1",
                                            "0 activation body 0 id 0 species 0", "0 catch body 1 id 1 species 1 other 0",
                                            "0 death body 0 id 0 species 0 caught other 1", "0 birth body 0 id 2 species 1"});
}

TEST_CASE("ecology: one tick -> starvation, then minimum predators, then perception") {
  auto params = scene<Scene>({{.x_m = 9.0, .y_m = 9.0}, {.x_m = -9.0, .y_m = -9.0}, {.x_m = -9.0, .y_m = 9.0}}, 2);
  params.rules.minimum_predators.below = 2;
  struct Perception {
    void on_tick(const View& view) {
      for (BodyIndex body = 0; body < view.robots.size(); ++body) {
        const auto seen = perception::adversary(body, view, [&](BodyIndex self, BodyIndex other) {
          return view.robots[self].tag == view.robots[other].tag && view.robots[other].active;
        });  // no tag may change before 50 s
        CHECK(view.robots[body].adversary == (seen ? std::optional{seen->adversary} : std::nullopt));
      }
    }
  } perception;
  Ecology<Scene> ecology{params, still};
  test::Recorder recorder;
  ecology.run_until(46.0, recorder, perception);
  // Delta = 25 - 2 = 23 ticks; the two predators are equally hungry, so the earlier born starves
  const Lines lines = at_tick(23, recorder.events);
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] == "death body 1 id 1 species 1 starved");
  CHECK(lines[1] == "birth body 1 id 3 species 0");
  CHECK((lines[2] == "death body 0 id 0 species 0 sacrificed" || lines[2] == "death body 1 id 3 species 0 sacrificed"));
  CHECK(lines[3].ends_with("id 4 species 1"));
  for (std::int64_t tick = 1; tick < 23; ++tick) CHECK(at_tick(tick, recorder.events).empty());
}

TEST_CASE("ecology: catch -> hunter fed, victim's body remembers its killer") {
  using Rules = with_parent_after<with_parent_after<Scene, Cause::starved, reproduction::parent::LastSeenVictim>,
                                  Cause::sacrificed, reproduction::parent::LastKiller>;
  auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}, {.x_m = 8.0}});
  params.rules.genome_source.random_share = 0.0;
  params.rules.capture.reach_m = 7.6;
  Places::poses = {{.x_m = 8.0}, {.x_m = 0.5}, {.x_m = 0.5}};
  params.rules.activation.distance_m = 0.2;  // body 1 stands on the predator and stays inactive
  Ecology<Rules> ecology{params, still};
  ecology.run_until(0.0);
  const auto robots = ecology.view().robots;
  CHECK(robots[0].parent() == 2);
  CHECK(robots[0].species == 1);
  const auto& killers = ecology.states().parent.part<static_cast<std::size_t>(Cause::sacrificed)>();
  REQUIRE(killers[0].killer);
  CHECK(killers[0].killer->id == 2);
  CHECK(robots[1].id == 1);
  CHECK_FALSE(robots[1].active);
  CHECK(robots[2].fed_tick == 0);
  const auto& seen = ecology.states().parent.part<static_cast<std::size_t>(Cause::starved)>();
  CHECK_FALSE(seen[2].body);
  CHECK_FALSE(seen[2].victim);
}

namespace {

/// Returns what a test tells it to, right or wrong.
struct Scripted {
  static constexpr std::string_view name = "scripted";
  static inline std::vector<death::Capture> captures_at_0;
  [[nodiscard]] std::vector<death::Capture> captures(const View& view, Rng&) const {
    return view.tick == 0 ? captures_at_0 : std::vector<death::Capture>{};
  }
};

/// Turns right and lists what a test tells it to.
struct ScriptedTags {
  static constexpr std::string_view name = "scripted_tags";
  static inline std::vector<int> listed;
  static inline double angle_rad = 0.7;
  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return 1; }
  [[nodiscard]] std::vector<int> tags() const { return listed; }
  [[nodiscard]] control::Decision decide(std::span<const double>, std::span<const double>) const {
    return {.target_angle_rad = angle_rad, .tag = 1};
  }
};

struct ScriptedTag {
  static constexpr std::string_view name = "scripted_tag";
  static inline int given = 1;
  [[nodiscard]] int tag(std::optional<int>, std::span<const int>, Rng&) const { return given; }
};

/// The sentence of the RuleError that a run ends with; empty if there is none.
template <class Rules>
std::string rule_error(const typename Ecology<Rules>::Params& params, double until_s = 0.0) {
  return test::message_of<RuleError>([&] { Ecology<Rules>{params, still}.run_until(until_s); });
}

}  // namespace

TEST_CASE("ecology: tags of the brain -> in the description, none or duplicates -> error before the run") {
  using Rules = with_brain<Scene, ScriptedTags>;
  auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}});
  const auto made_with = [&](std::vector<int> tags) {
    ScriptedTags::listed = std::move(tags);
    return test::message_of<RuleError>([&] { Ecology<Rules>{params, still}; });
  };
  CHECK(made_with({1, -1}) == "");
  CHECK(Ecology<Rules>{params, still}.describe(1.0).tags == std::vector<int>{1, -1});
  CHECK(made_with({}) == "the policy in rules.brain returned no tags(): must list every tag that it may choose");
  CHECK(made_with({1, -1, 1}) == "the policy in rules.brain returned tags() with 1 twice: must list each tag once");
}

namespace {

/// Wants each of three tags in turn, by the sign of nothing but its first weight and the tag ratio.
struct ThreeTags {
  static constexpr std::string_view name = "three_tags";
  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t) const { return inputs; }
  [[nodiscard]] std::vector<int> tags() const { return {5, 6, 7}; }
  [[nodiscard]] control::Decision decide(std::span<const double> inputs, std::span<const double> weights) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) sum += inputs[i] * weights[i];
    return {.target_angle_rad = sum, .tag = sum < -0.3 ? 5 : sum < 0.3 ? 6 : 7};
  }
};

}  // namespace

TEST_CASE("ecology: brain with three tags -> all can be shown") {
  using Rules = with_newborn_tag<with_brain<rules::Paper, ThreeTags>, perception::newborn_tag::RandomTag>;
  struct Tags {
    void on_tick(const View& view) {
      for (const Individual& one : view.robots) {
        ++shown[one.tag];
        if (one.adversary) CHECK((one.tag >= 5 && one.tag <= 7));
      }
    }
    std::map<int, std::size_t> shown;
  } tags;
  Ecology<Rules> ecology{{.seed = 3}, backend::Kinematic::Params{}};
  test::Recorder recorder;
  ecology.run_until(300.0, tags, recorder);
  REQUIRE(tags.shown.size() == 3);
  for (const int tag : {5, 6, 7}) CHECK(tags.shown[tag] > 100);
  CHECK(
      std::ranges::any_of(recorder.events, [](const std::string& line) { return line.find("tag_switch") != std::string::npos; }));
  CHECK(ecology.describe(1.0).tags == std::vector<int>{5, 6, 7});
}

TEST_CASE("ecology: policy returns a victim twice -> one catch") {
  using Rules = with_capture<Scene, Scripted>;
  auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}, {.x_m = 0.9}, {.x_m = -0.9}}, 3);
  Scripted::captures_at_0 = {{.hunter = 1, .victim = 0}, {.hunter = 2, .victim = 0}, {.hunter = 3, .victim = 0}};
  CHECK(at_tick(0, events<Rules>(params, 0.0)) ==
        Lines{"birth body 0 id 0 species 0", "birth body 1 id 1 species 1", "birth body 2 id 2 species 1",
              "birth body 3 id 3 species 1", "activation body 0 id 0 species 0", "catch body 1 id 1 species 1 other 0",
              "death body 0 id 0 species 0 caught other 1", "birth body 0 id 4 species 1"});
}

TEST_CASE("ecology: policy returns a value that does not exist -> RuleError with its slot") {
  using Rules = with_capture<Scene, Scripted>;
  const auto message = [](std::vector<death::Capture> captures) {
    auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}});
    Scripted::captures_at_0 = std::move(captures);
    return rule_error<Rules>(params);
  };
  CHECK(message({{.hunter = 1, .victim = 0}}).empty());
  CHECK(message({{.hunter = 2, .victim = 0}}) == "the policy in rules.capture returned hunter 2: must be < 2");
  CHECK(message({{.hunter = 1, .victim = 7}}) == "the policy in rules.capture returned victim 7: must be < 2");
  CHECK(message({{.hunter = 0, .victim = 1}}) ==
        "the policy in rules.capture returned hunter 0 and victim 1: species prey does not eat predator");
}

namespace {

/// Gives up the body in which somebody has just been born, too.
struct TwiceTheSame {
  static constexpr std::string_view name = "twice_the_same";
  [[nodiscard]] std::vector<death::Sacrifice> sacrifices(const View& view, Rng&) const {
    if (view.tick > 0) return {};
    return {{.victim = 0, .successor = test::predator}, {.victim = 0, .successor = test::predator}};
  }
};

/// One founder too few.
struct Short {
  static constexpr std::string_view name = "short";
  [[nodiscard]] FoodWeb web() const { return test::predator_prey_web(); }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const { return std::vector<Species>(robots - 1, test::prey); }
};

/// Prey of a given name.
struct Named {
  static constexpr std::string_view name = "named";
  static inline std::string given;
  [[nodiscard]] FoodWeb web() const { return {{"predator", given}, {{.hunter = test::predator, .victim = test::prey}}}; }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const { return std::vector<Species>(robots, test::prey); }
};

/// Names a parent without anything to inherit.
struct Nobody {
  static constexpr std::string_view name = "nobody";
  [[nodiscard]] std::optional<Ancestor> parent(const reproduction::Vacancy&, const View&, Rng&) const {
    return Ancestor{.id = 0, .species = test::predator, .genome = nullptr};
  }
};

}  // namespace

TEST_CASE("ecology: policy sacrifices a victim twice -> its newborn is not sacrificed") {
  using Rules = with_minimum_predators<Scene, TwiceTheSame>;
  auto params = scene<Rules>({{.x_m = 9.0}, {.x_m = -9.0}});
  const Lines lines = at_tick(0, events<Rules>(params, 0.0));
  CHECK(std::ranges::count(lines, "death body 0 id 0 species 0 sacrificed") == 1);
  CHECK(std::ranges::count_if(lines, [](const std::string& line) { return line.starts_with("death"); }) == 1);
}

TEST_CASE("ecology: wrong number of founders or places, or a place that is not finite -> RuleError") {
  using Few = with_community<Scene, Short>;
  const auto few = scene<Few>({{.x_m = 0.0}, {.x_m = 0.5}});
  CHECK(rule_error<Few>(few) == "the policy in rules.community returned 1 founders: must be 2, the number of robots");
  auto params = scene<Scene>({{.x_m = 0.0}, {.x_m = 0.5}});
  params.ecology.robots = 3;
  CHECK(rule_error<Scene>(params) == "the policy in rules.placement returned 2 places: must be 3, the number of robots");
  params.ecology.robots = 2;
  Places::poses[1].y_m = std::numeric_limits<double>::quiet_NaN();
  CHECK(rule_error<Scene>(params) == "the policy in rules.placement returned the place of body 1: must be finite");
}

TEST_CASE("ecology: a species' name that breaks a row of a table -> RuleError") {
  using Rules = with_community<Scene, Named>;
  const auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}});
  const auto made_with = [&](std::string name) {
    Named::given = std::move(name);
    return rule_error<Rules>(params);
  };
  CHECK(made_with("gr\xc3\xbcne Beute") == "");
  CHECK(made_with("prey, small") ==
        "the policy in rules.community returned the name of species 1, \"prey, small\": must have no comma, quote or control "
        "character");
  for (const char* name : {"\"prey\"", "prey\nprey", "\x1b[2J"}) CHECK(made_with(name).ends_with("control character"));
}

TEST_CASE("ecology: parent without a genome -> RuleError with its id") {
  using Rules = with_parent_after<with_capture<Scene, Scripted>, Cause::caught, Nobody>;
  auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}});
  params.rules.genome_source.random_share = 0.0;
  Scripted::captures_at_0 = {{.hunter = 1, .victim = 0}};
  CHECK(rule_error<Rules>(params) ==
        "the policy in rules.parent returned individual 0 as a parent: must have a genome of 15 weights");
}

TEST_CASE("ecology: newborn or brain tag that is not listed -> RuleError") {
  using Rules = with_newborn_tag<Scene, ScriptedTag>;
  auto params = scene<Rules>({{.x_m = 0.0}}, 0);
  ScriptedTag::given = -1;
  CHECK(rule_error<Rules>(params).empty());
  ScriptedTag::given = 2;
  CHECK(rule_error<Rules>(params) == "the policy in rules.newborn_tag returned tag 2: must be one of the brain's tags() (-1, 1)");
}

TEST_CASE("ecology: values of rules that are not finite -> RuleError before they are written") {
  typename Ecology<rules::Paper>::Params params;
  params.rules.initial_genome.limit = 1e308;
  CHECK(rule_error<rules::Paper>(params) == "the policy in rules.initial_genome returned weights: must be finite");
  using Rules = with_brain<Scene, ScriptedTags>;
  ScriptedTags::listed = {1};
  ScriptedTags::angle_rad = std::numeric_limits<double>::quiet_NaN();
  auto turning = scene<Rules>({{.x_m = 0.0}, {.x_m = 0.5}});
  CHECK(rule_error<Rules>(turning) == "the policy in rules.brain returned a target angle: must be finite");
  ScriptedTags::angle_rad = 0.7;
}

TEST_CASE("ecology: hunter caught earlier in the tick -> no more catches") {
  // the hunter is 0.2 m from the grazer, which is 0.7 m from the plant: the closer pair comes first
  const auto params = scene<ChainScene>({{.x_m = 0.9}, {.x_m = 0.2}, {.x_m = 0.0}});
  CHECK(at_tick(0, events<ChainScene>(params, 0.0)) ==
        Lines{"birth body 0 id 0 species 0", "birth body 1 id 1 species 1", "birth body 2 id 2 species 2",
              "activation body 0 id 0 species 0", "activation body 1 id 1 species 1", "catch body 2 id 2 species 2 other 1",
              "death body 1 id 1 species 1 caught other 2", "birth body 1 id 3 species 2"});
  // now the grazer is closer to the plant and eats before it is eaten
  const auto reverse = scene<ChainScene>({{.x_m = 0.9}, {.x_m = 0.7}, {.x_m = 0.0}});
  const Lines lines = at_tick(0, events<ChainScene>(reverse, 0.0));
  REQUIRE(lines.size() == 11);
  CHECK(lines[5] == "catch body 1 id 1 species 1 other 0");
  CHECK(lines[8] == "catch body 2 id 2 species 2 other 1");
}

TEST_CASE("ecology: floor reached within a tick -> no more catches") {
  for (const std::size_t floor : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    auto params = scene<Scene>({{.x_m = 0.3}, {.x_m = 0.5}, {.x_m = 0.0}});
    params.rules.floor.floor = floor;
    Ecology<Scene> ecology{params, still};
    ecology.run_until(0.0);
    CHECK(ecology.view().count(test::prey) == floor);
    if (floor == 1) CHECK(ecology.view().robots[0].species == test::predator);  // the closer one was caught
  }
}

TEST_CASE("ecology: floor reached -> no sacrifices") {
  auto params = scene<Scene>({{.x_m = 9.0}, {.x_m = -9.0}, {.x_m = 0.0}}, 0);
  params.rules.minimum_predators.below = 3;
  params.rules.floor.floor = 1;
  Ecology<Scene> ecology{params, still};
  ecology.run_until(0.0);
  CHECK(ecology.view().count(test::predator) == 1);  // one a tick
  ecology.run_until(20.0);
  CHECK(ecology.view().count(test::predator) == 2);
}

TEST_CASE("ecology: together -> all perceive the tags before the first change") {
  using Rules = with_starvation_exemption<with_brain<Scene, AlwaysMinus>, death::starvation::exemption::NearRememberedAdversary>;
  auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 3.0}});
  params.rules.tag_switch.cool_down_s = 0.0;
  Ecology<Rules> ecology{params, still};
  test::Recorder recorder;
  ecology.run_until(0.0, recorder);
  for (BodyIndex body = 0; body < 2; ++body) {
    const Individual& individual = ecology.view().robots[body];
    CHECK(individual.adversary);
    CHECK(individual.adversary_distance_m == 3.0);
    CHECK(ecology.states().starvation.part<1>()[body].adversary_distance_m == 3.0);
    CHECK(individual.tag == -1);
  }
  const Lines lines = at_tick(0, recorder.events);
  REQUIRE(lines.size() == 5);
  CHECK(lines[3] == "tag_switch body 0 id 0 species 0");
  CHECK(lines[4] == "tag_switch body 1 id 1 species 1");
}

TEST_CASE("ecology: in turn -> later robots see tags chosen earlier in the tick") {
  using Rules = with_brain<Scene, AlwaysMinus>;
  auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 3.0}});
  params.rules.tag_switch.cool_down_s = 0.0;
  params.ecology.decision_order = DecisionOrder::in_turn;
  Ecology<Rules> ecology{params, still};
  ecology.run_until(0.0);
  CHECK(ecology.view().robots[0].adversary == 1);   // both showed +1 when body 0 looked
  CHECK_FALSE(ecology.view().robots[1].adversary);  // body 0 has switched meanwhile
  CHECK(ecology.view().robots[1].tag == -1);
}

TEST_CASE("ecology: no switch -> tag clock restarts with sampling, not with cool-down") {
  using Brain = with_brain<Scene, AlwaysMinus>;
  const auto clocks = [](auto rules, double until_s) {
    using Rules = typename decltype(rules)::type;
    auto params = scene<Rules>({{.x_m = 0.0}, {.x_m = 3.0}}, 0);
    Ecology<Rules> ecology{params, still};
    ecology.run_until(until_s);
    return ecology.view().robots[0].tag_since_s;
  };
  using Sampled = with_tag_switch<Brain, perception::tag_switch::TagSampling>;
  CHECK(clocks(std::type_identity<Sampled>{}, 98.0) == 0.0);
  CHECK(clocks(std::type_identity<Sampled>{}, 150.0) == 100.0);
  CHECK(clocks(std::type_identity<Sampled>{}, 250.0) == 200.0);  // the tag was -1 already
  CHECK(clocks(std::type_identity<Brain>{}, 250.0) == 50.0);
}

TEST_CASE("ecology: before first_tick_s -> no events") {
  auto params = scene<Scene>({{.x_m = 0.0}, {.x_m = 0.5}});
  params.ecology.first_tick_s = 2.0;
  const Lines lines = events<Scene>(params, 4.0);
  CHECK(at_tick(0, lines) == Lines{"birth body 0 id 0 species 0", "birth body 1 id 1 species 1"});
  REQUIRE(at_tick(1, lines).size() == 4);
  CHECK(at_tick(1, lines)[1] == "catch body 1 id 1 species 1 other 0");
}

TEST_CASE("ecology: heading rule of the table -> headings in the view") {
  using Rules = with_heading<Scene, Backwards>;
  auto params = scene<Rules>({{.x_m = 0.0, .heading_rad = 0.25}}, 0);
  Ecology<Rules> ecology{params, still};
  ecology.run_until(2.0);
  CHECK(ecology.view().poses[0].heading_rad == doctest::Approx(wrap_angle(3.25)));
}

TEST_CASE("ecology: memory of the last seen prey -> changes only when another body becomes the closest") {
  using Ageing = with_senescence<Scene, death::senescence::OldAge>;
  using Rules = with_parent_after<Ageing, Cause::starved, reproduction::parent::LastSeenVictim>;
  auto params = scene<Rules>({{.x_m = 3.0}, {.x_m = 0.0}});
  params.rules.senescence.max_age_s = 20.0;
  params.rules.starvation.interval.base_ticks = 1000;
  params.rules.tag_switch.cool_down_s = 1e6;
  Ecology<Rules> ecology{params, still};
  ecology.run_until(24.0);
  const auto robots = ecology.view().robots;
  CHECK(robots[0].id == 2);  // reborn at tick 10, seen again from tick 11 on
  CHECK(robots[1].adversary == 0);
  const auto& seen = ecology.states().parent.part<static_cast<std::size_t>(Cause::starved)>();
  CHECK(seen[1].body == 0);
  REQUIRE(seen[1].victim);
  CHECK(seen[1].victim->id == 0);
}

TEST_CASE("ecology: no target perceived -> the brain decides, or the last decision stays") {
  auto params = scene<Scene>({{.x_m = 0.0}}, 0);
  Ecology<Scene> asked{params, still};
  asked.run_until(0.0);
  CHECK(std::abs(asked.view().robots[0].target_angle_rad) == 0.7);
  CHECK_FALSE(asked.view().robots[0].adversary);
  CHECK(std::isnan(asked.view().robots[0].adversary_distance_m));

  params.ecology.without_target = WithoutTarget::keeps_decision;
  Ecology<Scene> kept{params, still};
  kept.run_until(200.0);
  CHECK(kept.view().robots[0].target_angle_rad == 0.0);
  CHECK(kept.view().robots[0].tag == 1);
}

TEST_CASE("ecology: death of old age -> body stays with its species") {
  using Rules = with_senescence<Scene, death::senescence::OldAge>;
  auto params = scene<Rules>({{.x_m = 9.0}, {.x_m = -9.0}});
  params.rules.senescence.max_age_s = 20.0;
  params.rules.starvation.interval.base_ticks = 1000;
  const Lines lines = events<Rules>(params, 40.0);
  CHECK(at_tick(10, lines) == Lines{"death body 0 id 0 species 0 senescence", "birth body 0 id 2 species 0",
                                    "death body 1 id 1 species 1 senescence", "birth body 1 id 3 species 1"});
  CHECK(at_tick(11, lines) == Lines{"activation body 0 id 2 species 0"});
  CHECK(at_tick(20, lines) == Lines{"death body 0 id 2 species 0 senescence", "birth body 0 id 4 species 0",
                                    "death body 1 id 3 species 1 senescence", "birth body 1 id 5 species 1"});
}

TEST_CASE("ecology: prey die of age -> prey, with a parent of their species or none") {
  using Ageing = with_senescence<Scene, death::senescence::OldAge>;
  using Nearest = with_parent_after<Ageing, Cause::senescence, reproduction::parent::NearestConspecific>;
  const auto successor = [](auto rules) {
    using Rules = typename decltype(rules)::type;
    auto params = scene<Rules>({{.x_m = 2.0}, {.x_m = 5.0}, {.x_m = 0.0}});
    params.rules.senescence.max_age_s = 20.0;
    params.rules.starvation.interval.base_ticks = 1000;
    params.rules.genome_source.random_share = 0.0;
    Ecology<Rules> ecology{params, still};
    ecology.run_until(20.0);
    const auto robots = ecology.view().robots;
    CHECK(robots[0].species == test::prey);
    CHECK(robots[1].species == test::prey);
    CHECK(robots[2].species == test::predator);
    return robots[0].parent();
  };
  CHECK_FALSE(successor(std::type_identity<Ageing>{}));
  CHECK(successor(std::type_identity<Nearest>{}) == 1);
}

TEST_CASE("ecology: parent of another species than the successor -> RuleError") {
  using Rules = with_parent_after<with_senescence<Scene, death::senescence::OldAge>, Cause::senescence,
                                  reproduction::parent::NearestVictim>;
  auto params = scene<Rules>({{.x_m = 2.0}, {.x_m = 0.0}});
  params.rules.senescence.max_age_s = 20.0;
  params.rules.starvation.interval.base_ticks = 1000;
  params.rules.genome_source.random_share = 0.0;
  CHECK(rule_error<Rules>(params, 20.0) ==
        "the policy in rules.parent returned individual 2, a prey, as the parent of a predator: must be of its "
        "offspring's species");
}

TEST_CASE("ecology: a predator starves -> offspring of the nearest active prey or, with none in range, a random prey") {
  for (const double distance_m : {4.0, 6.0, 11.0, 13.0}) {
    CAPTURE(distance_m);
    const bool is_parent = distance_m == 6.0 || distance_m == 11.0;
    auto params = scene<Scene>({{.x_m = distance_m - 5.0}, {.x_m = -5.0}});
    params.rules.genome_source.random_share = 0.0;
    params.rules.starvation.exemption.range_m = 0.0;
    params.rules.activation.distance_m = 5.0;
    params.rules.parent.starved.range_m = 12.0;
    Ecology<Scene> ecology{params, still};
    ecology.run_until(48.0);  // Delta = 24 ticks
    const Individual& born = ecology.view().robots[1];
    CHECK(born.id == 2);
    CHECK(born.species == test::prey);
    CHECK(born.parent() == (is_parent ? std::optional<IndividualId>{0} : std::nullopt));
    CHECK(born.origin == (is_parent ? Origin::inherited : Origin::random));
  }
}

TEST_CASE("ecology: all hunters exempt -> none starves, next procedure an interval later") {
  auto params = scene<Scene>({{.x_m = 3.0}, {.x_m = 0.0}});
  params.rules.tag_switch.cool_down_s = 1e6;
  CHECK(at_tick(24, events<Scene>(params, 100.0)).empty());  // a prey that it perceives is 3 m away
}

TEST_CASE("ecology: run_until -> whole ticks, continues, ignores times in the past") {
  auto params = scene<Scene>({{.x_m = 9.0}, {.x_m = -9.0}});
  Ecology<Scene> ecology{params, still};
  CHECK(ecology.tick() == 0);
  ecology.run_until(3.0);
  CHECK(ecology.tick() == 2);
  CHECK(ecology.time_s() == 4.0);
  CHECK(ecology.backend().time_s() == doctest::Approx(4.0));
  ecology.run_until(4.0);
  ecology.run_until(1.0);
  CHECK(ecology.tick() == 2);
  ecology.run_until(10.0);
  CHECK(ecology.tick() == 5);
  CHECK(ecology.view().tick == 5);
  CHECK(ecology.view().time_s == 10.0);
}

TEST_CASE("ecology: clock_scale -> physics faster than the clock by that factor") {
  auto params = scene<Scene>({{.x_m = 9.0}, {.x_m = -9.0}});
  params.ecology.clock_scale = 1.5;
  Ecology<Scene> ecology{params, still};
  ecology.run_until(10.0);
  CHECK(ecology.tick() == 5);
  CHECK(ecology.backend().time_s() == doctest::Approx(15.0));
}

TEST_CASE("ecology: bad numbers -> named error before the run") {
  const auto message = [](auto change) {
    auto params = scene<Scene>({{.x_m = 9.0}, {.x_m = -9.0}});
    change(params);
    return test::message_of<std::invalid_argument>([&] { Ecology<Scene>{params, still}; });
  };
  CHECK(message([](auto&) {}) == "");
  CHECK(message([](auto& p) { p.rules.community.predators = 3; }) ==
        "rules.community.predators = 3: must be <= 2, the number of robots");
  CHECK(message([](auto& p) { p.ecology.robots = 0; }) == "ecology.robots = 0: must be >= 1 and <= 1e+07");
  CHECK(message([](auto& p) { p.rules.tag_switch.cool_down_s = -1.0; }) == "rules.tag_switch.cool_down_s = -1: must be >= 0");
  CHECK(message([](auto& p) { p.rules.capture.reach_m = std::numeric_limits<double>::quiet_NaN(); }) ==
        "rules.capture.reach_m = nan: must be finite");
  CHECK(message([](auto& p) { p.ecology.tick_s = 0.001; }) ==
        "ecology.tick_s = 0.001: tick_s * clock_scale * control_hz = 0.06 control steps, must be a whole number >= 1");
  CHECK(test::message_of<std::invalid_argument>([] {
          Ecology<rules::Paper>{{}, backend::Kinematic::Params{.timestep_s = 0.0}};
        }).starts_with("backend.timestep_s = 0: must be > 0"));
}
