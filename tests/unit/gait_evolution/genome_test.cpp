// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>
#include <support/temporary_folder.hpp>
#include <tools/gait_evolution/genome.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/habitat/load/toml_table.hpp>

namespace gait_evolution = trophic::gait_evolution;
using doctest::Approx;
using gait_evolution::Activation;
using gait_evolution::Genome;
using gait_evolution::Innovations;
using gait_evolution::LinkGene;
using trophic::Rng;
using trophic::Stream;

namespace {

/// Input 1 -> hidden 8 -> output, and the bias -> output.
Genome small() {
  return {.nodes = {{7, Activation::sine}, {8, Activation::abs}},
          .links = {{0, 0, 7, 0.5, true}, {7, 1, 8, -2.0, true}, {8, 8, 7, 1.5, true}}};
}

/// Checks what Genome promises, and that the network is finite.
void check_valid(const Genome& genome) {
  const auto are_ascending = [](const auto& genes, auto number) {
    return std::ranges::adjacent_find(genes, std::greater_equal{}, number) == genes.end();
  };
  RC_ASSERT(genome.nodes.front().id == Genome::output);
  RC_ASSERT(are_ascending(genome.nodes, &gait_evolution::NodeGene::id));
  RC_ASSERT(are_ascending(genome.links, &LinkGene::innovation));
  std::set<Innovations::Ends> ends;
  for (const LinkGene& link : genome.links) {
    RC_ASSERT((link.to >= Genome::output && link.from != Genome::output));
    RC_ASSERT(ends.emplace(link.from, link.to).second);
  }
  const auto network = genome.network();
  for (int x = -2; x <= 2; ++x) RC_ASSERT(std::abs(network({x, 1, 0}, {1, -x, 2})) <= 1.0);
}

/// A few founders that mutate and mate at random, with frequent changes of structure.
std::vector<Genome> breed(std::uint64_t seed, std::size_t operations) {
  const gait_evolution::Variation variation{.add_link_probability = 0.5, .add_node_probability = 0.2};
  Innovations innovations;
  std::vector<Genome> genomes;
  for (std::uint64_t i = 0; i < 6; ++i) {
    Rng rng{seed, Stream::gait_founder, i};
    genomes.push_back(gait_evolution::random_genome(variation, innovations, rng));
  }
  for (std::size_t operation = 0; operation < operations; ++operation) {
    Rng rng{seed, Stream::gait_variation, operation};
    Genome& changed = genomes[rng.index(genomes.size())];
    const Genome& partner = genomes[rng.index(genomes.size())];
    if (rng.chance(0.3)) changed = gait_evolution::crossover(changed, partner, rng);
    gait_evolution::mutate(changed, variation, innovations, rng);
  }
  for (const Genome& genome : genomes) {
    for (const LinkGene& link : genome.links) RC_ASSERT(innovations.link(link.from, link.to) == link.innovation);
  }
  return genomes;
}

}  // namespace

TEST_CASE("genome: any sequence of mutations and crossovers -> valid, and the same for the same seed") {
  CHECK(rc::check("every genome is valid", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto genomes = breed(seed, *rc::gen::inRange<std::size_t>(0, 200));
    for (const Genome& genome : genomes) check_valid(genome);
  }));
  CHECK(rc::check("breed is a function of its seed", [](std::uint64_t seed) {
    RC_ASSERT(breed(seed, 60) == breed(seed, 60));
    RC_ASSERT(breed(seed, 60) != breed(seed + 1, 60));
  }));
  std::size_t hidden = 0;
  for (const Genome& genome : breed(2024, 3000)) hidden += genome.network().hidden.size();
  CHECK(hidden > 100);
}

TEST_CASE("genome: founder -> every input linked to a sine, weights inside the limit") {
  Innovations innovations;
  Rng rng{1, Stream::gait_founder};
  const Genome genome = gait_evolution::random_genome({.initial_weight_limit = 0.25}, innovations, rng);
  REQUIRE(genome.links.size() == 7);
  for (std::uint32_t i = 0; i < 7; ++i) {
    CHECK(genome.links[i] == LinkGene{i, i, 7, genome.links[i].weight, true});
    CHECK(std::abs(genome.links[i].weight) <= 0.25);
  }
  CHECK(genome.nodes == std::vector<gait_evolution::NodeGene>{{7, Activation::sine}});
}

TEST_CASE("innovations: equal ones -> equal numbers, others -> new numbers") {
  Innovations innovations;
  CHECK(innovations.link(3, 7) == 3);
  CHECK(innovations.link(3, 9) == 7);
  CHECK(innovations.link(4, 9) == 8);
  CHECK(innovations.link(3, 9) == 7);

  const Genome without;
  CHECK(innovations.node(3, without) == 8);
  CHECK(innovations.node(3, without) == 8);
  CHECK(innovations.node(4, without) == 9);
  const Genome with{.nodes = {{7, Activation::sine}, {8, Activation::step}}, .links = {}};
  CHECK(innovations.node(3, with) == 10);
  CHECK(innovations.node(3, without) == 8);
}

TEST_CASE("genome: new node -> replaces a link") {
  Innovations innovations;
  Genome genome{.nodes = {{7, Activation::sine}}, .links = {{2, 2, 7, 0.75, true}}};
  Rng rng{3, Stream::gait_variation};
  gait_evolution::add_node(genome, innovations, rng);
  REQUIRE(genome.nodes.size() == 2);
  CHECK(genome.nodes[1].id == 8);
  CHECK(genome.links == std::vector<LinkGene>{{2, 2, 7, 0.75, false}, {7, 2, 8, 1.0, true}, {8, 8, 7, 0.75, true}});
}

TEST_CASE("genome: new links -> every pair that closes no cycle, then disabled ones again, then nothing") {
  Innovations innovations;
  Genome genome = small();
  for (const LinkGene& link : genome.links) innovations.link(link.from, link.to);
  Rng rng{4, Stream::gait_variation};
  for (int i = 0; i < 100; ++i) gait_evolution::add_link(genome, {}, innovations, rng);
  REQUIRE(genome.links.size() == 7 + 7 + 1);  // inputs to output, inputs to the hidden node, hidden to output
  genome.links[4].enabled = false;
  gait_evolution::add_link(genome, {}, innovations, rng);
  CHECK(genome.links.size() == 15);
  CHECK(genome.links[4].enabled);
}

TEST_CASE("genome: mutation with all probabilities 0 -> nothing changes, any weight -> within its limit") {
  Innovations innovations;
  Rng rng{6, Stream::gait_variation};
  gait_evolution::Variation variation{.weight_mutation_probability = 0,
                                      .weight_standard_deviation = 3.0,
                                      .weight_limit = 1.5,
                                      .add_link_probability = 0,
                                      .add_node_probability = 0,
                                      .activation_mutation_probability = 0};
  Genome genome = small();
  gait_evolution::mutate(genome, variation, innovations, rng);
  CHECK(genome == small());
  variation.weight_mutation_probability = 1;
  for (int i = 0; i < 200; ++i) {
    gait_evolution::mutate(genome, variation, innovations, rng);
    for (const LinkGene& link : genome.links) CHECK(std::abs(link.weight) <= 1.5);
  }
}

TEST_CASE("genome: child -> the fitter parent's structure and genes of both") {
  const Genome other{.nodes = {{7, Activation::tanh}, {9, Activation::step}},
                     .links = {{0, 0, 7, -9.0, true}, {11, 9, 7, 3.0, true}}};
  std::set<double> weights;
  for (std::uint64_t event = 0; event < 50; ++event) {
    Rng rng{7, Stream::gait_variation, 0, event};
    const Genome child = gait_evolution::crossover(small(), other, rng);
    REQUIRE(child.nodes.size() == 2);
    REQUIRE(child.links.size() == 3);
    CHECK(child.links[1] == small().links[1]);
    CHECK(child.links[2] == small().links[2]);
    weights.insert(child.links[0].weight);
  }
  CHECK(weights == std::set<double>{-9.0, 0.5});
}

TEST_CASE("activations at points computed by hand") {
  using trophic::control::activate;
  CHECK(activate(Activation::sine, 0.5) == Approx(0.479425538604203));
  CHECK(activate(Activation::gaussian, 2.0) == Approx(0.0183156388887342));
  CHECK(activate(Activation::tanh, 1.0) == Approx(0.761594155955765));
  CHECK(activate(Activation::step, 0.0) == 1.0);
  CHECK(activate(Activation::step, -1e-9) == 0.0);
  CHECK(activate(Activation::linear, -3.5) == -3.5);
  CHECK(activate(Activation::abs, -3.5) == 3.5);
  CHECK(activate(Activation::linear, -1e300) == -1e6);
}

TEST_CASE("network: any ids -> nodes computed before those that they feed, disabled links without effect, a cycle refused") {
  // x1 -> 9 (abs) -> 8 (linear) -> 7
  Genome genome{.nodes = {{7, Activation::sine}, {8, Activation::linear}, {9, Activation::abs}},
                .links = {{0, 8, 7, 0.05, true}, {1, 9, 8, 3.0, true}, {2, 1, 9, 2.0, true}}};
  CHECK(genome.network()({-4, 0, 0}, {0, 0, 0}) == Approx(std::sin(8.0 * 3.0 * 0.05)));
  genome.links[0].enabled = false;
  CHECK(genome.network()({-4, 0, 0}, {0, 0, 0}) == 0.0);
  genome.links.push_back({9, 8, 9, 1.0, false});
  CHECK(trophic::test::message_of<std::invalid_argument>([&] { static_cast<void>(genome.network()); }) ==
        "genome of a CPPN: its links form a cycle");
}

TEST_CASE("network: the published CPPN -> the published gait of the spider") {
  const double gain = 3.025;
  const Genome genome{.nodes = {{7, Activation::sine}},
                      .links = {{0, 0, 7, gain * 0.5193029403554234, true},
                                {1, 1, 7, gain * 0.0575994456677941, true},
                                {2, 2, 7, gain * 1.037920298210572, true},
                                {4, 4, 7, gain * 0.98193370804869985, true},
                                {5, 5, 7, gain * 0.9648602838256312, true},
                                {6, 6, 7, gain * 0.0636313795506953, true}}};
  const trophic::Gait gait = genome.network().gait_of(trophic::load_robot("spider"));
  const trophic::Gait published = trophic::load_gait("spider_published");
  CHECK(gait.hinges == published.hinges);
  CHECK((gait.internal - published.internal).cwiseAbs().maxCoeff() < 1e-12);
  CHECK((gait.coupling - published.coupling).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("shipped gaits: each evolved gait -> its own CPPN at the robot's grid positions") {
  for (const std::string name : {"spider_paper", "spider_steered", "gecko_paper", "gecko_steered", "snake_paper"}) {
    CAPTURE(name);
    const trophic::Gait gait = trophic::load_gait(name);
    CHECK(gait.name == name);
    const trophic::RobotModel robot = trophic::load_robot(gait.robot);
    REQUIRE_NOTHROW(check_fit(gait, robot));
    Genome genome;
    const auto file = trophic::detail::TomlTable::read(trophic::find_model(trophic::ModelKind::gait, name));
    const auto number = [](const auto& gene, std::string_view key) {
      return static_cast<std::uint32_t>(gene.whole_number(key, 0));
    };
    for (const auto& gene : file.table("cppn").tables("nodes")) {
      const auto names = enum_names(Activation{});
      const auto found = std::ranges::find(names, gene.text("activation"));
      genome.nodes.push_back({number(gene, "id"), static_cast<Activation>(found - names.begin())});
    }
    for (const auto& gene : file.table("cppn").tables("links")) {
      genome.links.push_back({number(gene, "innovation"), number(gene, "from"), number(gene, "to"),
                              gene.number("weight", trophic::any_number()), gene.truth("enabled")});
    }
    const trophic::Gait queried = genome.network().gait_of(robot);
    CHECK((gait.internal - queried.internal).cwiseAbs().maxCoeff() < 1e-13);
    CHECK((gait.coupling - queried.coupling).cwiseAbs().maxCoeff() < 1e-13);
  }
}
