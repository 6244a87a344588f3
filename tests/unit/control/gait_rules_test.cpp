// SPDX-License-Identifier: MIT
// Gaits that genes express.
#include <doctest/doctest.h>

#include <set>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/control/gait/learnt.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using control::Cppn;
using control::gait::FirstGait;
using control::gait::InheritedCpg;
using control::gait::InheritedCppn;
using control::gait::Learnt;

namespace {

Habitat spider() {
  return load_habitat(rules::Paper::ecology());
}

/// A core with two legs on each brick of its spine.
RobotModel six_legged() {
  body::Design design;
  design.name = "six_legged";
  std::size_t at = 0;
  for (int segment = 0; segment < 3; ++segment) {
    at = design.modules.attach(at, body::Face::front, body::ModuleType::brick);
    design.modules.attach(at, body::Face::left, body::ModuleType::hinge);
    design.modules.attach(at, body::Face::right, body::ModuleType::hinge);
  }
  return body::build(design);
}

/// A nursery in which a robot walks farther the larger the first weight of its gait is, and diverges with one above 1.
struct FirstWeight final : Nursery {
  [[nodiscard]] std::optional<double> walked_m(const RobotModel&, const Gait& gait, double duration_s) const override {
    ++walks;
    return gait.internal[0] > 1.0 ? std::nullopt : std::optional{duration_s * gait.internal[0]};
  }
  mutable std::size_t walks = 0;
};

}  // namespace

TEST_CASE("learnt gait: 30 trials -> farther than the inherited one without a divergence and one trial -> the inherited one") {
  const Habitat habitat = spider();
  const Learnt<InheritedCpg> rule{{.inherited = {.first = FirstGait::random, .sd = 0.2}, .trials = 30}};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    Rng rng{seed, Stream::user};
    std::vector<double> genes = rule.draw(habitat.robot, habitat, rng);
    const double inherited = rule.express(genes, habitat.robot, habitat).internal[0];
    const FirstWeight nursery;
    rule.learn(genes, habitat.robot, habitat, {}, nursery, rng);
    CHECK(nursery.walks == 30);
    const double learnt = rule.express(genes, habitat.robot, habitat).internal[0];
    CHECK((inherited > 1.0 || learnt > inherited));
    CHECK(learnt <= 1.0);

    std::vector<double> once = genes;
    Learnt<InheritedCpg>{{.trials = 1}}.learn(once, habitat.robot, habitat, {}, nursery, rng);
    CHECK(rule.express(once, habitat.robot, habitat).internal[0] == inherited);

    const auto of_offspring = [&](double lamarckian) {
      std::vector<double> own = genes;
      const Learnt<InheritedCpg> passes{{.inherited = {.sd = 0.0}, .lamarckian = lamarckian}};
      passes.mutate(own, {}, rng);
      return passes.express(own, habitat.robot, habitat).internal[0];
    };
    CHECK(of_offspring(0.0) == inherited);
    CHECK(of_offspring(1.0) == learnt);
  }
}

TEST_CASE("learnt gait: genes without a count of the inherited ones -> one sentence") {
  const Habitat habitat = spider();
  CHECK_THROWS_WITH_AS(static_cast<void>(Learnt<InheritedCpg>{}.express(std::vector{7.0, 0.5}, habitat.robot, habitat)),
                       "genes of a learnt gait: must begin with the number of inherited genes", std::invalid_argument);
}

TEST_CASE("inherited gaits: no noise -> the robot's own gait, to the bit") {
  const Habitat habitat = spider();
  Rng rng{1, Stream::user};
  const InheritedCpg cpg{{.first_sd = 0.0}};
  const Gait same = cpg.express(cpg.draw(habitat.robot, habitat, rng), habitat.robot, habitat);
  CHECK(same.internal == habitat.gait.internal);
  CHECK(same.coupling == habitat.gait.coupling);
  const InheritedCppn cppn{{.first_limit = 0.0}};
  const Gait too = cppn.express(cppn.draw(habitat.robot, habitat, rng), habitat.robot, habitat);
  CHECK(too.internal == habitat.gait.internal);
  CHECK(too.coupling == habitat.gait.coupling);
}

TEST_CASE("inherited cppn: a named gait, no noise -> that gait, to the bit, and one that is not loaded -> one sentence") {
  const RobotModel gecko = load_robot("gecko");
  Habitat habitat = spider();
  const InheritedCppn rule{{.first_limit = 0.0, .gait = "gecko_steered"}};
  Rng rng{1, Stream::user};
  const auto genes = rule.draw(gecko, habitat, rng);
  CHECK_THROWS_WITH_AS(static_cast<void>(rule.express(genes, gecko, habitat)),
                       "rules.gait.gait = \"gecko_steered\": must be a model of the habitat", std::invalid_argument);
  REQUIRE(rule.gaits().size() == 1);
  habitat.gaits.push_back({.name = rule.gaits()[0], .gait = load_gait("gecko_steered")});
  const Gait own = rule.express(genes, gecko, habitat);
  CHECK(own.internal == habitat.gaits[0].gait.internal);
  CHECK(own.coupling == habitat.gaits[0].gait.coupling);
}

TEST_CASE("inherited gaits: random first gait -> weights within their limit, of which none is the robot's") {
  const Habitat habitat = spider();
  Rng rng{1, Stream::user};
  const InheritedCpg cpg{{.first = FirstGait::random, .limit = 0.5}};
  const auto genes = cpg.draw(habitat.robot, habitat, rng);
  CHECK(std::set<double>(genes.begin(), genes.end()).size() == 10);
  for (const double gene : genes) CHECK(std::abs(gene) <= 0.5);
}

TEST_CASE("inherited cppn: one genome -> a gait for spider, gecko and a six-legged tree, equal for equal cells") {
  const InheritedCppn rule{{.first = FirstGait::random, .first_limit = 1.0, .link_probability = 1.0, .node_probability = 1.0}};
  const Habitat habitat = spider();
  const Individual offspring = test::HandPopulation{{{}}}.individuals[0];
  Rng rng{5, Stream::user};
  std::vector<double> genes = rule.draw(habitat.robot, habitat, rng);
  CHECK(genes.size() == 22);
  for (int generation = 0; generation < 30; ++generation) rule.mutate(genes, offspring, rng);
  CHECK(Cppn::of(genes).hidden.size() == 30);
  CHECK(Cppn::of(genes).genes() == genes);
  for (const RobotModel& robot : {habitat.robot, load_robot("gecko"), six_legged()}) {
    const Gait gait = rule.express(genes, robot, habitat);
    CHECK_NOTHROW(check_fit(gait, robot));
    for (const double weight : gait.internal) CHECK(std::abs(weight) <= 1.0);
    CHECK(gait.internal[0] == Cppn::of(genes)(robot.hinges[0].grid_position, robot.hinges[0].grid_position));
  }
}

TEST_CASE("cppn: split link of weight w with linear activation -> the same output") {
  Cppn network{.hidden = {}, .links = {{.from = 1, .to = 7, .weight = 0.25}}};
  const Eigen::Vector3i cell{2, 0, 0};
  CHECK(network(cell, cell) == std::sin(0.5));
  for (std::uint64_t seed = 1; network.hidden.empty() || network.hidden[0] != control::Activation::linear; ++seed) {
    network = {.hidden = {}, .links = {{.from = 1, .to = 7, .weight = 0.25}}};
    Rng rng{seed, Stream::user};
    network.split_link(rng);
  }
  CHECK(network.links.size() == 2);
  CHECK(network(cell, cell) == std::sin(0.5));
}

TEST_CASE("inherited gaits: genes of another rule or robot -> errors that say what they must be") {
  const Habitat habitat = spider();
  CHECK(test::message_of<std::invalid_argument>([&] {
          static_cast<void>(InheritedCpg{}.express(std::vector<double>(9), habitat.robot, habitat));
        }) == "9 genes of a gait of robot spider: must be 10, one for each hinge and each pair of neighbours");
  for (const std::vector<double>& genes :
       {std::vector<double>{}, {0.5}, {1.0, 9.0}, {0.0, 7.0, 7.0, 1.0}, {0.0, 0.0, 7.0}, {101.0}, {0.0, 0.0, 3.0, 1.0}}) {
    CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(Cppn::of(genes)); }) ==
          "genes of a gait: must be a feed-forward CPPN");
  }
}
