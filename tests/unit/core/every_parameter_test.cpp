// SPDX-License-Identifier: MIT
// Nothing is without effect and silent: every parameter of every shipped table. tests/program/effects_test.py has those of
// engines.
#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <support/temporary_folder.hpp>
#include <tools/changes/may_follow.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/torus.hpp>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/whole_file.hpp>
#include <trophic/worlds/food_chain.hpp>
#include <trophic/worlds/lotka_volterra.hpp>
#include <trophic/worlds/mating_zones.hpp>
#include <trophic/worlds/pond_race.hpp>
#include <trophic/worlds/ponds.hpp>
#include <trophic/worlds/two_foods.hpp>
#include <trophic/worlds/wolf_sheep.hpp>

namespace {

using namespace trophic;

using Values = std::map<std::string, std::variant<double, std::string>>;

/// Short runs of a table in which every rule acts soon.
struct ShortRuns {
  BackendChoice backend;
  Values crowd;
  /// Values that differ as half of the crowd's would not in so short a run.
  Values others = {};
  std::int64_t change_tick = 60;
  std::int64_t last_tick = 200;
  /// Parameters that no individual of these short lives reads after the change.
  std::vector<std::string> idle = {};
};

/// Names of models, for which only some tables have another value here.
const std::vector<std::string> texts{"ecology.robot", "ecology.arena", "ecology.gait"};
/// Parameters that say when a run ends.
const std::vector<std::string> left_out{"ecology.duration_s", "ecology.ends_when"};

/// What tables have of a run: births with genomes, deaths, and each robot and the food at each tick.
struct Rows {
  std::string text;
  void add(auto... values) { (text.append(reinterpret_cast<const char*>(&values), sizeof values), ...); }
  void on_event(const observe::Event& event, const View& view) {
    const Individual& one = event.individual;
    add(view.tick, static_cast<int>(event.kind), one.id, one.energy_J);
    for (const auto* part : {&one.genome->weights, &one.genome->traits})
      for (const double number : *part) add(number);
  }
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& one = view.robots[body];
      if (!one.lives()) continue;
      const GroundPose& at = view.poses[body];
      add(one.id, one.tag, one.active ? 1 : 0, at.x_m, at.y_m, one.target_angle_rad, one.energy_J, one.adversary_distance_m);
    }
    for (const ResourceField& food : view.foods) add(food.total_J());
    text = hash_text(text);
  }
};

[[nodiscard]] std::string state_of(Simulation& ecology) {
  Archive archive;
  ecology.persist(archive);
  return std::move(archive).bytes();
}

[[nodiscard]] ParamRef& find(ParamRefs& params, const std::string& path) {
  const auto found = std::ranges::find(params, path, &ParamRef::path);
  REQUIRE_MESSAGE(found != params.end(), path);
  return *found;
}

void set(ParamRef& param, const std::variant<double, std::string>& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    *std::get<std::string*>(param.target) = *text;
  } else if (auto* number = std::get_if<double*>(&param.target)) {
    **number = std::get<double>(value);
  } else {
    const auto& whole = std::get<WholeRef>(param.target);
    whole.set(whole.value, static_cast<std::int64_t>(std::get<double>(value)));
  }
}

/// Halves a number; another value of a switch or an enumeration. For a number that is 0 or whose half is out of its bounds, more.
void halve(ParamRef& param) {
  const auto within = [&](double value) { return detail::within(value, param.bound); };
  if (auto* flag = std::get_if<bool*>(&param.target)) **flag = !**flag;
  if (auto* number = std::get_if<double*>(&param.target)) {
    const double half = **number == 0.0 ? 0.5 * std::min(param.bound.upper, 1.0) : 0.5 * **number;
    **number = within(half) ? half : 1.5 * **number;
  }
  if (const auto* whole = std::get_if<WholeRef>(&param.target)) {
    const std::int64_t value = whole->get(whole->value);
    const auto names = static_cast<std::int64_t>(whole->names.size());
    const bool shrinks = value > 0 && within(static_cast<double>(value / 2));
    whole->set(whole->value, names > 0 ? (value + 1) % names : shrinks ? value / 2 : value + 1);
  }
}

/// Checks each parameter of a table: halved, it gives other bytes or a remark that names it, and not both. Changed after
/// `change_tick`, it gives other bytes, or such a change is refused.
template <class Rules>
void check_every_parameter(const ShortRuns& runs) {
  const auto make = [&](const std::string& changed) {
    TableExperiment<Rules> experiment{runs.backend};
    ParamRefs params = experiment.params();
    for (const auto& [path, value] : runs.crowd) set(find(params, path), value);
    if (const auto other = runs.others.find(changed); other != runs.others.end()) {
      set(find(params, changed), other->second);
    } else if (!changed.empty()) {
      halve(find(params, changed));
    }
    validate(params);
    return experiment.simulations(Null::none, {})(experiment.seed());
  };
  const auto run = [](Simulation& ecology, std::int64_t until) {
    Rows rows;
    ecology.run_until(static_cast<double>(until) * ecology.view().tick_s, rows);
    return rows.text;
  };
  const auto first = make("");
  static_cast<void>(run(*first, runs.change_tick));
  const std::string state = state_of(*first);
  const auto run_on = [&](Simulation& ecology) {
    Archive archive{state};
    ecology.persist(archive);
    archive.finish();
    return run(ecology, runs.last_tick);
  };
  const std::string whole = run(*make(""), runs.last_tick);
  const std::string late = run_on(*make(""));
  const NamedParams all = first->describe(0.0).named_params;
  CHECK(all.size() > 25);
  for (const NamedParam& param : all) {
    if (std::ranges::count(left_out, param.path) > 0) continue;
    if (std::ranges::count(texts, param.path) > 0 && !runs.others.contains(param.path)) continue;
    CAPTURE(param.path);
    std::unique_ptr<Simulation> other;
    try {
      other = make(param.path);
    } catch (const std::exception& error) {  // no other value is possible
      CHECK(std::string{error.what()}.find(param.path.substr(0, param.path.rfind('.'))) != std::string::npos);
      continue;
    }
    const auto names_it = [&](const std::string& remark) {
      const std::size_t end = remark.find(" no effect");
      return end != std::string::npos && remark.substr(0, end).find(param.path) != std::string::npos;
    };
    const bool has_remark = std::ranges::any_of(other->describe(0.0).remarks, names_it);
    CHECK((run(*other, runs.last_tick) == whole) == has_remark);
    if (!param.path.starts_with("rules.") || std::ranges::count(runs.idle, param.path) > 0) continue;
    std::string refusal;
    try {
      changes::check_acts_later(param, "another value");
    } catch (const std::invalid_argument& error) {
      refusal = error.what();
    }
    CHECK((refusal.empty() || refusal.starts_with(param.path + " = ")));
    try {
      CHECK((run_on(*make(param.path)) == late) == !refusal.empty());
    } catch (const std::invalid_argument&) {  // the state has another size
      CHECK(!refusal.empty());
    }
  }
}

/// A name or path of a square without obstacles, of a side in metres.
[[nodiscard]] std::string square(const test::TemporaryFolder& folder, const std::string& name, double side_m) {
  const auto path = folder.path() / (name + ".toml");
  std::ofstream{path} << "name = \"" << name << "\"\nside_m = " << side_m << "\nfriction = 1.0\n";
  return path.string();
}

const BackendChoice points = backend::Kinematic::Params{};
const BackendChoice torus = backend::Torus::Params{};

/// Of the paper's tables: robots that meet soon.
[[nodiscard]] ShortRuns predators_and_prey(const test::TemporaryFolder& folder) {
  return {.backend = points,
          .crowd = {{"ecology.arena", square(folder, "small", 6.0)},
                    {"ecology.robots", 14.0},
                    {"ecology.control_hz", 4.0},
                    {"ecology.clock_scale", 0.5},
                    {"rules.community.predators", 5.0},
                    {"rules.activation.distance_m", 0.7},
                    {"rules.capture.min_age_s", 400.0},
                    {"rules.floor.floor", 4.0},
                    {"rules.minimum_predators.below", 4.0},
                    {"rules.starvation.interval.base_ticks", 9.0},
                    {"rules.starvation.interval.only_above", 2.0}},
          .others = {{"ecology.arena", square(folder, "wide", 6.5)},
                     {"ecology.robot", "gecko"},
                     {"ecology.gait", "spider_paper"},
                     {"rules.newborn_tag.founder_tag", -1.0},
                     {"rules.floor.floor", 9.0},
                     {"rules.minimum_predators.below", 8.0},
                     {"rules.starvation.interval.min_interval_ticks", 40.0},
                     {"rules.starvation.interval.only_above", 12.0}},
          .change_tick = 150,
          .last_tick = 500};
}

/// Of the ponds: many births and meals.
[[nodiscard]] ShortRuns pond(const test::TemporaryFolder& folder) {
  return {.backend = points,
          .crowd = {{"ecology.arena", square(folder, "small", 8.0)},
                    {"ecology.robots", 60.0},
                    {"ecology.control_hz", 4.0},
                    {"rules.community.predators", 2.0},
                    {"rules.tag_switch.cool_down_s", 4.0},
                    {"rules.recruitment.spare_bodies", 20.0},
                    {"rules.recruitment.birth_J", 40.0},
                    {"rules.capture.min_age_s", 200.0},
                    {"rules.metabolism.prey.capacity_J", 60.0},
                    {"rules.metabolism.predator.first_J", 40.0},
                    {"rules.metabolism.predator.capacity_J", 50.0}},
          .others = {{"ecology.arena", square(folder, "wide", 8.5)},
                     {"ecology.robot", "gecko"},
                     {"ecology.gait", "spider_paper"},
                     {"rules.newborn_tag.founder_tag", -1.0}}};
}

}  // namespace

TEST_CASE("effects: each parameter of paper, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = predators_and_prey(folder);
  runs.others["rules.parent.starved.range_m"] = 0.3;
  check_every_parameter<rules::Paper>(runs);
}

TEST_CASE("effects: each parameter of released, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = predators_and_prey(folder);
  runs.crowd.insert_or_assign("rules.placement.half_extent_m", 1.5);
  runs.crowd.insert_or_assign("rules.capture.min_age_s", 20.0);
  runs.others.insert({{"rules.capture.min_age_s", 300.0}, {"ecology.first_tick_s", 20.0}});
  check_every_parameter<rules::Released>(runs);
}

TEST_CASE("effects: each parameter of pond, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  check_every_parameter<worlds::Pond>(pond(folder));
}

TEST_CASE("effects: each parameter of pond_with_refuges, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = pond(folder);
  runs.crowd.erase("ecology.arena");
  runs.idle = {"rules.recruitment.only_active"};  // the inactive have too little energy here; pond has it
  check_every_parameter<worlds::PondWithRefuges>(runs);
}

TEST_CASE("effects: each parameter of pond_with_conditions, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = pond(folder);
  for (const char* number : {"spare_bodies", "birth_J"}) {
    const std::string slot = "rules.recruitment.";
    auto moved = runs.crowd.extract(slot + number);
    moved.key() = slot + "energy." + number;
    runs.crowd.insert(std::move(moved));
  }
  runs.crowd.insert({{"rules.floor.floor", 20.0}, {"rules.minimum_predators.below", 10.0}, {"rules.activation.min_age_s", 50.0}});
  runs.others["rules.floor.floor"] = 60.0;
  runs.idle = {"rules.metabolism.prey.first_J", "rules.metabolism.prey.spread"};  // all newcomers are predators
  check_every_parameter<worlds::PondWithConditions>(runs);
}

TEST_CASE("effects: each parameter of pond_race, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = pond(folder);
  runs.crowd.insert({{"rules.resource.cells_in_a_row", 20.0},
                     {"rules.metabolism.predator.efficiency", 0.3},
                     {"rules.traits.walking_pace.least", 0.9},
                     {"rules.traits.walking_pace.most", 1.1}});
  runs.others.insert({{"rules.traits.walking_pace.least", 0.8}, {"rules.traits.walking_pace.most", 1.2}});
  check_every_parameter<worlds::PondRace>(runs);
}

TEST_CASE("effects: each parameter of two_foods, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = pond(folder);
  for (const std::string number : {"prey.capacity_J", "predator.first_J", "predator.capacity_J"}) {
    auto moved = runs.crowd.extract("rules.metabolism." + number);
    moved.key().insert(moved.key().rfind('.') + 1, "energy.");
    runs.crowd.insert(std::move(moved));
  }
  runs.crowd.insert(
      {{"rules.metabolism.prey.energy.bite_W", 2.0}, {"rules.traits.diet.least", 0.45}, {"rules.traits.diet.most", 0.55}});
  runs.others.insert({{"rules.traits.diet.least", 0.3}, {"rules.traits.diet.most", 0.7}});
  runs.change_tick = 20;  // most births are soon after the start
  check_every_parameter<worlds::TwoFoods>(runs);
}

TEST_CASE("effects: each parameter of food_chain, halved or changed later -> other bytes, or a remark or refusal") {
  const test::TemporaryFolder folder;
  ShortRuns runs = pond(folder);
  for (const char* of_two : {"rules.tag_switch.cool_down_s", "rules.community.predators", "rules.recruitment.spare_bodies",
                             "rules.recruitment.birth_J", "rules.metabolism.prey.capacity_J", "rules.metabolism.predator.first_J",
                             "rules.metabolism.predator.capacity_J"})
    runs.crowd.erase(of_two);
  runs.crowd.insert({{"rules.community.hunters", 20.0},
                     {"rules.community.apex", 4.0},
                     {"rules.recruitment.grazer.spare_bodies", 20.0},
                     {"rules.recruitment.grazer.birth_J", 35.0},
                     {"rules.recruitment.hunter.birth_J", 35.0},
                     {"rules.recruitment.apex.birth_J", 35.0},
                     {"rules.metabolism.grazer.capacity_J", 60.0},
                     {"rules.metabolism.hunter.capacity_J", 50.0},
                     {"rules.metabolism.apex.capacity_J", 50.0},
                     {"rules.metabolism.apex.first_J", 40.0}});
  runs.crowd["ecology.robots"] = 80.0;
  runs.others["ecology.robots"] = 100.0;
  check_every_parameter<worlds::FoodChain>(runs);
}

TEST_CASE("effects: each parameter of wolf_sheep, halved or changed later -> other bytes, or a remark or refusal") {
  check_every_parameter<worlds::WolfSheep>(
      {.backend = torus,
       .crowd = {{"ecology.robots", 400.0}, {"ecology.control_hz", 4.0}, {"rules.recruitment.sheep.spare_bodies", 150.0}},
       .change_tick = 20,
       .last_tick = 60});
}

TEST_CASE("effects: each parameter of rosenzweig_macarthur, halved or changed later -> other bytes, or a remark or refusal") {
  check_every_parameter<worlds::RosenzweigMacArthur>({.backend = torus,
                                                      .crowd = {{"ecology.robots", 400.0},
                                                                {"ecology.control_hz", 4.0},
                                                                {"rules.community.predators", 60.0},
                                                                {"rules.recruitment.spare_bodies", 100.0},
                                                                {"rules.recruitment.K", 300.0},
                                                                {"rules.capture.reach_m", 0.003}},
                                                      .change_tick = 20,
                                                      .last_tick = 60});
}

TEST_CASE("effects: each parameter of lotka_volterra, halved or changed later -> other bytes, or a remark or refusal") {
  check_every_parameter<worlds::LotkaVolterra>({.backend = torus,
                                                .crowd = {{"ecology.robots", 400.0},
                                                          {"ecology.control_hz", 4.0},
                                                          {"rules.community.predators", 60.0},
                                                          {"rules.recruitment.spare_bodies", 100.0},
                                                          {"rules.recruitment.K", 1000.0},
                                                          {"rules.capture.reach_m", 0.0006}},
                                                .change_tick = 5,
                                                .last_tick = 40});
}

TEST_CASE("effects: each parameter of mating_zones, halved or changed later -> other bytes, or a remark or refusal") {
  check_every_parameter<worlds::MatingZones>({.backend = backend::Torus::Params{.speed_m_s = 0.05},
                                              .crowd = {{"ecology.robots", 90.0},
                                                        {"ecology.control_hz", 4.0},
                                                        {"rules.recruitment.spare_bodies", 40.0},
                                                        {"rules.recruitment.interval_ticks", 8.0},
                                                        {"rules.resource.food_W", 5.0}},
                                              .others = {{"rules.newborn_tag.founder_tag", -1.0}},
                                              .change_tick = 20,
                                              .last_tick = 60});
}

TEST_CASE("effects: tables of the shipped programs -> each has its case here") {
  const std::filesystem::path root = std::filesystem::path{TROPHIC_MODEL_DIR}.parent_path();
  const std::string cases = read_whole_file(root / "tests/unit/core/every_parameter_test.cpp");
  std::size_t tables = 0;
  const std::string text = read_whole_file(root / "tools/tables/shipped_tables.cpp");
  const std::regex offer{R"(rule_tables<([\w:,\s]+)>)"};
  for (std::sregex_iterator some{text.begin(), text.end(), offer}; some != std::sregex_iterator{}; ++some) {
    const std::string names = (*some)[1];
    const std::regex name{R"(\w+(?=\s*(?:,|$)))"};
    for (std::sregex_iterator one{names.begin(), names.end(), name}; one != std::sregex_iterator{}; ++one, ++tables)
      CHECK_MESSAGE(std::regex_search(cases, std::regex{"check_every_parameter<\\w+::" + one->str() + ">"}), one->str());
  }
  CHECK(tables == 12);
}
