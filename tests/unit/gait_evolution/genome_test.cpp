// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/gait_evolution/genome_toml.hpp>
#include <tools/gait_evolution/variation.hpp>

namespace gait_evolution = trophic::gait_evolution;
using gait_evolution::Activation;
using gait_evolution::Genome;

namespace {

/// Input 1 -> hidden 8 -> output, and the bias -> output.
Genome small() {
  return {.nodes = {{7, Activation::sine}, {8, Activation::abs}},
          .links = {{0, 0, 7, 0.5, true}, {7, 1, 8, -2.0, true}, {8, 8, 7, 1.5, true}}};
}

/// The record of the innovations that led to `small`.
gait_evolution::Innovations record_of_small() {
  gait_evolution::Innovations innovations;
  innovations.node(1, {});
  innovations.link(1, 8);
  innovations.link(8, 7);
  return innovations;
}

}  // namespace

TEST_CASE("a founder links every input to a sine, with weights inside the limit") {
  gait_evolution::Innovations innovations;
  trophic::Rng rng{1, trophic::Stream::gait_founder};
  const Genome genome = gait_evolution::random_genome({.initial_weight_limit = 0.25}, innovations, rng);
  gait_evolution::validate(genome);
  REQUIRE(genome.links.size() == 7);
  for (std::uint32_t i = 0; i < 7; ++i) {
    CHECK(genome.links[i].innovation == i);
    CHECK(genome.links[i].from == i);
    CHECK(genome.links[i].to == 7);
    CHECK(std::abs(genome.links[i].weight) <= 0.25);
  }
  CHECK(genome.nodes == std::vector<gait_evolution::NodeGene>{{7, Activation::sine}});
}

TEST_CASE("equal innovations get equal numbers, new ones new numbers") {
  gait_evolution::Innovations innovations;
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

  gait_evolution::Innovations continued{innovations.links(), innovations.splits()};
  CHECK(continued.link(4, 9) == 8);
  CHECK(continued.link(5, 9) == 9);
  CHECK(continued.node(3, with) == 10);
  CHECK(continued.node(5, without) == 11);
}

TEST_CASE("genome: new node -> replaces a link") {
  gait_evolution::Innovations innovations;
  Genome genome{.nodes = {{7, Activation::sine}}, .links = {{2, 2, 7, 0.75, true}}};
  trophic::Rng rng{3, trophic::Stream::gait_variation};
  gait_evolution::add_node(genome, innovations, rng);
  gait_evolution::validate(genome);
  REQUIRE(genome.nodes.size() == 2);
  CHECK(genome.nodes[1].id == 8);
  REQUIRE(genome.links.size() == 3);
  CHECK(genome.links[0] == gait_evolution::LinkGene{2, 2, 7, 0.75, false});
  CHECK(genome.links[1] == gait_evolution::LinkGene{7, 2, 8, 1.0, true});
  CHECK(genome.links[2] == gait_evolution::LinkGene{8, 8, 7, 0.75, true});
}

TEST_CASE("new links fill every pair that closes no cycle, then nothing is left") {
  gait_evolution::Innovations innovations = record_of_small();
  Genome genome = small();
  trophic::Rng rng{4, trophic::Stream::gait_variation};
  for (int i = 0; i < 100; ++i) gait_evolution::add_link(genome, {}, innovations, rng);
  gait_evolution::validate(genome);
  CHECK(genome.links.size() == 7 + 7 + 1);  // inputs to output, inputs to the hidden node, hidden to output
}

TEST_CASE("a new link enables a disabled one again") {
  gait_evolution::Innovations innovations = record_of_small();
  Genome genome = small();
  trophic::Rng rng{5, trophic::Stream::gait_variation};
  for (int i = 0; i < 100; ++i) gait_evolution::add_link(genome, {}, innovations, rng);
  REQUIRE(genome.links.size() == 15);
  genome.links[4].enabled = false;
  gait_evolution::add_link(genome, {}, innovations, rng);
  CHECK(genome.links.size() == 15);
  CHECK(genome.links[4].enabled);
}

TEST_CASE("mutation with all probabilities 0 changes nothing and weights stay inside their limit") {
  gait_evolution::Innovations innovations;
  trophic::Rng rng{6, trophic::Stream::gait_variation};
  Genome genome = small();
  gait_evolution::mutate(genome,
                         {.weight_mutation_probability = 0,
                          .add_link_probability = 0,
                          .add_node_probability = 0,
                          .activation_mutation_probability = 0},
                         innovations, rng);
  CHECK(genome == small());
  for (int i = 0; i < 200; ++i) {
    gait_evolution::mutate_weights(genome, {.weight_standard_deviation = 3.0, .weight_limit = 1.5}, rng);
    for (const gait_evolution::LinkGene& link : genome.links) CHECK(std::abs(link.weight) <= 1.5);
  }
}

TEST_CASE("a child has the fitter parent's structure and genes of both") {
  Genome other{.nodes = {{7, Activation::tanh}, {9, Activation::step}}, .links = {{0, 0, 7, -9.0, true}, {11, 9, 7, 3.0, true}}};
  bool from_fitter = false;
  bool from_other = false;
  for (std::uint64_t event = 0; event < 50; ++event) {
    trophic::Rng rng{7, trophic::Stream::gait_variation, 0, event};
    const Genome child = gait_evolution::crossover(small(), other, rng);
    gait_evolution::validate(child);
    REQUIRE(child.nodes.size() == 2);
    REQUIRE(child.links.size() == 3);
    CHECK(child.links[1] == small().links[1]);
    CHECK(child.links[2] == small().links[2]);
    const double weight = child.links[0].weight;
    CHECK((weight == 0.5 || weight == -9.0));
    (weight == 0.5 ? from_fitter : from_other) = true;
  }
  CHECK(from_fitter);
  CHECK(from_other);
}

TEST_CASE("an invalid genome is refused with gene and rule") {
  const auto refusal = [](Genome genome) {
    return trophic::test::message_of<std::invalid_argument>([&] { gait_evolution::validate(genome); });
  };
  CHECK(refusal(small()) == "");
  CHECK(refusal({}) == "cppn: first node: must have id 7, the output");
  Genome genome = small();
  genome.links.push_back({9, 8, 3, 1.0, true});
  CHECK(refusal(genome) == "cppn: link 9: to = 3 is an input");
  genome = small();
  genome.links.push_back({9, 12, 7, 1.0, true});
  CHECK(refusal(genome) == "cppn: link 9: from = 12 is not a node of this genome");
  genome = small();
  genome.links.push_back({9, 0, 7, 1.0, true});
  CHECK(refusal(genome) == "cppn: link 9: joins the same nodes as an earlier link");
  genome = small();
  genome.links[1].innovation = 9;
  CHECK(refusal(genome) == "cppn: link 8: innovation numbers must ascend");
  genome = small();
  genome.links[1].weight = std::numeric_limits<double>::infinity();
  CHECK(refusal(genome) == "cppn: link 7: weight = inf must be finite");
  genome = small();
  genome.nodes.push_back({9, Activation::tanh});
  genome.links.push_back({9, 8, 9, 1.0, true});
  genome.links.push_back({10, 9, 8, 1.0, false});
  CHECK(refusal(genome) == "cppn: links: form a cycle");
}

TEST_CASE("a broken genome file is refused in one line that names the place") {
  const auto refusal = [](std::string_view text) {
    return trophic::test::message_of<std::invalid_argument>(
        [&] { static_cast<void>(gait_evolution::read_genome(trophic::detail::TomlTable::parse(text, "gait.toml"))); });
  };
  CHECK(refusal("links = []") == "gait.toml: nodes: missing");
  CHECK(refusal("nodes = [{id = 7}]") == "gait.toml: nodes[0].activation: missing");
  CHECK(refusal("nodes = [{id = -7, activation = 'sine'}]") == "gait.toml: nodes[0].id = -7: must be a whole number >= 0");
  CHECK(refusal("nodes = [{id = 7, activation = 'cosine'}]") ==
        "gait.toml: nodes[0].activation = \"cosine\": must be sine, gaussian, tanh, step, linear or abs");
  CHECK(refusal("nodes = [{id = 7, activation = 'sine', gain = 2}]\nlinks = []") ==
        "gait.toml: nodes[0].gain: unknown key; known here: activation, id");
  CHECK(refusal("nodes = [{id = 7, activation = 'sine'}]\nlinks = [{innovation = 0, from = 0, to = 7, weight = 'x'}]") ==
        "gait.toml: links[0].weight = 'x': must be a number");
  CHECK(refusal("nodes = [{id = 8, activation = 'sine'}]\nlinks = []") ==
        "gait.toml: links: cppn: first node: must have id 7, the output");
}
