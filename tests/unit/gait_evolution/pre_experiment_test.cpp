// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <set>
#include <sstream>
#include <support/temporary_folder.hpp>
#include <support/toy_backend.hpp>
#include <tools/gait_evolution/files.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace gait_evolution = trophic::gait_evolution;
using gait_evolution::Individual;
using gait_evolution::Lineage;
using gait_evolution::Params;
using gait_evolution::PreExperiment;
using gait_evolution::Table;
using trophic::test::message_of;
using trophic::test::ToyBackend;

namespace {

Params quick(Table table = Table::paper) {
  Params params = gait_evolution::params_of(table);
  params.plan = {.population = 6, .parents = 6, .children = 8, .generations = 5};
  params.trial.duration_s = 1.0;
  return params;
}

PreExperiment experiment(const Params& params = quick(), const ToyBackend::Params& toy = {}) {
  return {params, toy, trophic::load_robot(params.robot)};
}

void finish(PreExperiment& running, std::size_t threads = 1) {
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
    const Lineage& lineage = running.lineage();
    const std::size_t generation = lineage.generations - 1;
    CHECK(lineage.individuals.size() == 6 + 8 * generation);
    CHECK(lineage.living().size() == 6);
    CHECK(lineage.fitness_after(generation).front() >= best);
    best = lineage.fitness_after(generation).front();
    for (const std::size_t id : lineage.living()) CHECK(lineage.individuals[id].fitness <= best);
  }
  const Lineage& lineage = running.lineage();
  CHECK(lineage.generations == 6);
  CHECK(best > lineage.fitness_after(0).front());
  std::set<std::size_t> sizes;
  for (std::size_t id = 0; id < lineage.individuals.size(); ++id) {
    const Individual& one = lineage.individuals[id];
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

TEST_CASE("pre-experiment: any number of threads -> the same lineage, another seed -> another one") {
  const auto lineage_of = [](std::uint64_t seed, std::size_t threads) {
    Params params = quick(Table::released);
    params.seed = seed;
    auto running = experiment(params);
    finish(running, threads);
    return running.lineage();
  };
  const Lineage one = lineage_of(1, 1);
  CHECK(one == lineage_of(1, 3));
  CHECK_FALSE(one == lineage_of(2, 1));
}

TEST_CASE("pre-experiment: generation stopped halfway -> nothing is changed") {
  auto running = experiment();
  REQUIRE(running.next_generation());
  const Lineage before = running.lineage();
  std::atomic<int> asked = 0;
  CHECK_FALSE(running.next_generation(2, [&] { return ++asked < 4; }));
  CHECK(running.lineage() == before);
}

TEST_CASE("candidates whose trial diverges score -infinity and do not survive better ones") {
  auto running = experiment(quick(), {.breaks_beyond_rad = 1.2});
  finish(running);
  const Lineage& lineage = running.lineage();
  const auto broken = std::ranges::count_if(lineage.individuals, [](const auto& one) { return std::isinf(one.fitness); });
  CHECK(broken > 0);
  CHECK(broken < static_cast<long>(lineage.individuals.size()));
  CHECK(std::isfinite(lineage.individuals[lineage.champion()].fitness));
}

TEST_CASE("pre-experiment: impossible settings -> refused before any trial runs") {
  const auto refusal = [](auto change) {
    Params params = quick();
    change(params);
    return message_of<std::invalid_argument>([&] { experiment(params); });
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
  const std::string text = content(folder.path() / "checkpoint.toml");
  const auto refusal = [&](const std::string& from, const std::string& to, std::uint64_t seed = 1) {
    std::string changed = text;
    if (!from.empty()) changed.replace(changed.find(from), from.size(), to);
    static_cast<void>(folder.file("checkpoint.toml", changed));
    Params params = quick();
    params.seed = seed;
    auto again = experiment(params);
    const std::string message = message_of<std::invalid_argument>([&] { gait_evolution::resume(again, folder.path()); });
    CHECK(message.empty() == (again.lineage() == saved.lineage()));
    return message.substr(std::min(message.find("checkpoint.toml"), message.size()));
  };
  CHECK(refusal("", "") == "");
  CHECK(refusal("", "", 2).starts_with("checkpoint.toml: fingerprint = "));
  CHECK(refusal("", "", 2).ends_with("robot, parameters or engine differ from those of the checkpoint"));
  CHECK(refusal("]", "").starts_with("checkpoint.toml:"));
  CHECK(refusal("[", "[nan, ") == "checkpoint.toml: fitness: each must be finite or -inf");
  CHECK(refusal("[", "['x', ") == "checkpoint.toml: fitness = 'x': must be a number");
  CHECK(refusal("[", "[0.5, ") ==
        "checkpoint.toml: fitness: 7 candidates: must be those of whole generations, 6 founders and 8 "
        "in each of up to 5");
}

TEST_CASE("history: a pre-experiment -> its tables") {
  Lineage lineage;
  lineage.generations = 2;
  lineage.individuals = {{.died = 1, .fitness = 0.5}, {.fitness = 2.0}, {.parents = {0, 1}, .born = 1, .fitness = 1.25}};
  lineage.individuals.push_back({.parents = {1}, .born = 1, .died = 1});
  for (Individual& one : lineage.individuals) one.genome.nodes = {{7, gait_evolution::Activation::sine}};
  CHECK(lineage.fitness_after(0) == std::vector{2.0, 0.5});
  CHECK(gait_evolution::phylogeny_csv(lineage) ==
        "id,ancestor_list,origin_time,destruction_time,fitness,hidden_nodes,enabled_links\n"
        "0,[none],0,1,0.5,0,0\n1,[none],0,inf,2,0,0\n2,\"[0,1]\",1,inf,1.25,0,0\n3,[1],1,1,-inf,0,0\n");
}

TEST_CASE("gait file: written -> reads back as the champion's gait to the bit, with its provenance") {
  const trophic::test::TemporaryFolder folder;
  auto running = experiment();
  finish(running);
  gait_evolution::save(running, folder.path());
  const std::string file = (folder.path() / "gait.toml").string();
  const Individual& champion = running.lineage().individuals[running.lineage().champion()];
  const trophic::Gait gait = trophic::load_gait(file);
  const trophic::Gait queried = champion.genome.network().gait_of(running.robot());
  trophic::check_fit(gait, running.robot());
  CHECK(gait.internal == queried.internal);
  CHECK(gait.coupling == queried.coupling);
  const toml::table table = toml::parse_file(file);
  CHECK(table["cppn"]["links"].as_array()->size() == champion.genome.links.size());
  CHECK(table["evolution"]["engine"].value<std::string>() == "toy 1");
  CHECK(table["evolution"]["engine_remark_1"].value<std::string>() == "physics has no effect: a toy");
  CHECK(table["evolution"]["params"]["plan"]["children"].value<int>() == 8);
  CHECK(table["evolution"]["fitness"].value<double>() == champion.fitness);
}
