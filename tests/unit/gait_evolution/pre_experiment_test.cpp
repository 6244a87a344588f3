// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <set>
#include <sstream>
#include <support/temporary_folder.hpp>
#include <support/toy_backend.hpp>
#include <tools/gait_evolution/archive.hpp>
#include <tools/gait_evolution/pre_experiment.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace gait_evolution = trophic::gait_evolution;
using trophic::test::message_of;
using trophic::test::ToyBackend;

namespace {

template <class Table>
using Numbers = gait_evolution::Params<Table>;
template <class Table>
using PreExperiment = gait_evolution::PreExperiment<Table>;

template <class Table>
Numbers<Table> quick() {
  Numbers<Table> numbers;
  numbers.plan.population = 6;
  numbers.plan.parents = 6;
  numbers.plan.children = 8;
  numbers.plan.generations = 5;
  numbers.trial.duration_s = 1.0;
  return numbers;
}

template <class Table = gait_evolution::Paper>
PreExperiment<Table> experiment(const Numbers<Table>& numbers = quick<Table>(), const ToyBackend::Params& toy = {}) {
  return {numbers, toy, trophic::load_robot(numbers.robot)};
}

template <class Table>
void finish(PreExperiment<Table>& running, std::size_t threads = 1) {
  while (!running.done()) REQUIRE(running.next_generation(threads));
}

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("generations have the planned sizes, parents lived, and the best never gets worse under round robin") {
  auto running = experiment();
  double best = -1e9;
  while (!running.done()) {
    REQUIRE(running.next_generation());
    const gait_evolution::Lineage& lineage = running.lineage();
    const std::size_t generation = lineage.generations - 1;
    CHECK(lineage.individuals.size() == 6 + 8 * generation);
    CHECK(lineage.living().size() == 6);
    CHECK(gait_evolution::fitness_after(lineage, generation).front() >= best);
    best = gait_evolution::fitness_after(lineage, generation).front();
    for (const std::size_t id : lineage.living()) CHECK(lineage.individuals[id].fitness <= best);
  }
  const gait_evolution::Lineage& lineage = running.lineage();
  CHECK(lineage.generations == 6);
  CHECK(best > gait_evolution::fitness_after(lineage, 0).front());
  std::set<std::size_t> sizes;
  for (std::size_t id = 0; id < lineage.individuals.size(); ++id) {
    const gait_evolution::Individual& one = lineage.individuals[id];
    CHECK(one.born == (id < 6 ? 0 : (id - 6) / 8 + 1));
    sizes.insert(one.parents.size());
    for (const std::size_t parent : one.parents) {
      CHECK(lineage.individuals[parent].born < one.born);
      CHECK(lineage.individuals[parent].died.value_or(99) >= one.born);
    }
    CHECK(one.fitness == running.evaluate(one.genome));
  }
  CHECK(sizes == std::set<std::size_t>{0, 1, 2});
}

TEST_CASE("in the released code's pre-experiment the two parents of a child are distinct") {
  auto numbers = quick<gait_evolution::Released>();
  numbers.variation.crossover_probability = 1.0;
  auto running = experiment(numbers);
  finish(running);
  for (const gait_evolution::Individual& one : running.lineage().individuals) {
    CHECK(one.parents.size() == (one.born == 0 ? 0 : 2));
    if (one.born > 0) CHECK(one.parents.front() != one.parents.back());
  }
}

TEST_CASE("pre-experiment: any number of threads -> the same lineage, another seed -> another one") {
  auto one = experiment();
  auto three = experiment();
  finish(one, 1);
  finish(three, 3);
  CHECK(one.lineage() == three.lineage());
  auto numbers = quick<gait_evolution::Paper>();
  numbers.seed = 2;
  auto other = experiment(numbers);
  finish(other);
  CHECK_FALSE(one.lineage() == other.lineage());
}

TEST_CASE("pre-experiment: killed at any generation and resumed -> the same bytes") {
  const trophic::test::TemporaryFolder whole;
  auto uninterrupted = experiment<gait_evolution::Released>();
  while (!uninterrupted.done()) {
    REQUIRE(uninterrupted.next_generation());
    gait_evolution::save(uninterrupted, whole.path());
  }
  for (std::size_t killed_after = 0; killed_after <= 6; ++killed_after) {
    const trophic::test::TemporaryFolder folder;
    auto first = experiment<gait_evolution::Released>();
    gait_evolution::save(first, folder.path());
    for (std::size_t i = 0; i < killed_after; ++i) {
      first.next_generation();
      gait_evolution::save(first, folder.path());
    }
    auto second = experiment<gait_evolution::Released>();
    gait_evolution::resume(second, folder.path());
    CHECK(second.lineage() == first.lineage());
    finish(second, 2);
    gait_evolution::save(second, folder.path());
    for (const char* file : {"checkpoint.toml", "generations.csv", "phylogeny.csv", "gait.toml"}) {
      CHECK(content(folder.path() / file) == content(whole.path() / file));
    }
  }
}

TEST_CASE("pre-experiment: generation stopped halfway -> nothing is changed") {
  auto running = experiment();
  REQUIRE(running.next_generation());
  const gait_evolution::Lineage before = running.lineage();
  std::atomic<int> asked = 0;
  CHECK_FALSE(running.next_generation(2, [&] { return ++asked < 4; }));
  CHECK(running.lineage() == before);
}

TEST_CASE("candidates whose trial diverges score -infinity and do not survive better ones") {
  auto running = experiment(quick<gait_evolution::Paper>(), {.breaks_beyond_rad = 1.2});
  finish(running);
  const gait_evolution::Lineage& lineage = running.lineage();
  const auto broken = std::ranges::count_if(lineage.individuals, [](const auto& one) { return std::isinf(one.fitness); });
  CHECK(broken > 0);
  CHECK(broken < static_cast<long>(lineage.individuals.size()));
  CHECK(std::isfinite(lineage.individuals[lineage.champion()].fitness));
}

TEST_CASE("pre-experiment: impossible settings -> refused before any trial runs") {
  const auto refusal = [](auto change) {
    auto numbers = quick<gait_evolution::Paper>();
    change(numbers);
    return message_of<std::invalid_argument>([&] { experiment(numbers); });
  };
  CHECK(refusal([](auto& n) { n.plan.parents = 7; }) == "round_robin: 7 distinct individuals wanted: must be <= 6");
  CHECK(refusal([](auto& n) { n.plan.children = 0; }) == "plan.children = 0: must be >= 1 and <= 1e+06");
  CHECK(refusal([](auto& n) { n.trial.control_hz = 1000.0; }) ==
        "physics.timestep_s = 0.0012: must be <= 0.001, the control period");
}

TEST_CASE("pre-experiment: broken or foreign checkpoint -> refused") {
  const trophic::test::TemporaryFolder folder;
  auto saved = experiment();
  saved.next_generation();
  gait_evolution::save(saved, folder.path());
  auto numbers = quick<gait_evolution::Paper>();
  numbers.seed = 2;
  auto other = experiment(numbers);
  const std::string refusal = message_of<std::invalid_argument>([&] { gait_evolution::resume(other, folder.path()); });
  CHECK(refusal.find("checkpoint.toml: fingerprint = ") != std::string::npos);
  CHECK(refusal.find("robot, parameters or engine are not those") != std::string::npos);

  std::string text = content(folder.path() / "checkpoint.toml");
  const auto resume_from = [&](const std::string& changed) {
    std::ofstream{folder.path() / "checkpoint.toml"} << changed;
    auto again = experiment();
    return message_of<std::exception>([&] { gait_evolution::resume(again, folder.path()); });
  };
  CHECK(resume_from(text) == "");
  CHECK(resume_from(text.substr(0, text.size() / 2)).find("checkpoint.toml:") != std::string::npos);
  std::string changed = text;
  changed.replace(changed.find("born = 0"), 8, "born = -1");
  CHECK(resume_from(changed).find("individual[0].born = -1: must be a whole number >= 0") != std::string::npos);
  for (const char* generations : {"generations = 2", "generations = 1000000000"}) {
    changed = text;
    changed.replace(changed.find("generations = 1"), 15, generations);
    if (changed.find("generations = 2") != std::string::npos) {  // no individual survived the second
      for (std::size_t at = 0; (at = changed.find("born = 0", at)) != std::string::npos; at += 20)
        changed.insert(at, "died = 1\n");
    }
    CHECK(resume_from(changed).find(std::string{generations} + ": must be as many as have survivors") != std::string::npos);
  }
}

TEST_CASE("history: a pre-experiment -> its tables") {
  using trophic::gait_evolution::Individual;
  gait_evolution::Lineage lineage;
  lineage.generations = 2;
  lineage.individuals = {{.died = 1, .fitness = 0.5}, {.fitness = 2.0}, {.parents = {0, 1}, .born = 1, .fitness = 1.25}};
  lineage.individuals.push_back({.parents = {1}, .born = 1, .died = 1});
  for (Individual& one : lineage.individuals) one.genome.nodes = {{7, gait_evolution::Activation::sine}};
  CHECK(gait_evolution::generations_csv(lineage) ==
        "generation,evaluations,best,median,worst,diverged\n0,2,2,1.25,0.5,0\n1,4,2,1.625,1.25,1\n");
  CHECK(gait_evolution::phylogeny_csv(lineage) ==
        "id,ancestor_list,origin_time,destruction_time,fitness,hidden_nodes,enabled_links\n"
        "0,[none],0,1,0.5,0,0\n1,[none],0,inf,2,0,0\n2,\"[0,1]\",1,inf,1.25,0,0\n3,[1],1,1,-inf,0,0\n");
}

TEST_CASE("gait file: written -> reads back as the champion's gait and CPPN, with its provenance") {
  const trophic::test::TemporaryFolder folder;
  auto running = experiment(quick<gait_evolution::Paper>());
  finish(running);
  gait_evolution::save(running, folder.path());
  const std::string file = (folder.path() / "gait.toml").string();
  const gait_evolution::Genome& champion = running.lineage().individuals[running.lineage().champion()].genome;
  CHECK(gait_evolution::load_cppn(file) == champion);
  trophic::Gait gait = trophic::load_gait(file);
  const trophic::Gait queried = gait_evolution::cppn_gait(champion, running.robot());
  trophic::check_fit(gait, running.robot());
  CHECK(gait.internal == queried.internal);
  CHECK(gait.coupling == queried.coupling);
  const toml::table table = toml::parse_file(file);
  CHECK(table["evolution"]["engine"].value<std::string>() == "toy 1");
  CHECK(table["evolution"]["engine_remark_1"].value<std::string>() == "physics has no effect: a toy");
  CHECK(table["evolution"]["params"]["plan"]["children"].value<int>() == 8);
  CHECK(table["evolution"]["fitness"].value<double>() == running.lineage().individuals[running.lineage().champion()].fitness);
}

TEST_CASE("a gait couples neighbours only") {
  const trophic::RobotModel gecko = trophic::load_robot("gecko");
  const gait_evolution::Genome one{.nodes = {{7, gait_evolution::Activation::sine}}, .links = {{0, 0, 7, 1.0, true}}};
  const trophic::Gait gait = gait_evolution::cppn_gait(one, gecko);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(gait.internal[static_cast<Eigen::Index>(i)] == doctest::Approx(std::sin(1.0)));
    for (std::size_t j = i + 1; j < 6; ++j) {
      const bool neighbours = std::ranges::count(gecko.hinge_neighbours[i], j) == 1;
      const double weight = gait.coupling(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      CHECK(weight == (neighbours ? doctest::Approx(std::sin(1.0)) : doctest::Approx(0.0)));
    }
  }
}
