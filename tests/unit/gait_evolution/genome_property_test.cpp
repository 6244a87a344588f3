// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <tools/gait_evolution/genome_toml.hpp>
#include <tools/gait_evolution/network.hpp>
#include <tools/gait_evolution/variation.hpp>

namespace gait_evolution = trophic::gait_evolution;
using gait_evolution::Genome;
using trophic::Rng;
using trophic::Stream;

namespace {

struct Family {
  gait_evolution::Innovations innovations;
  std::vector<Genome> genomes;
};

/// A few founders that mutate and mate at random, with frequent changes of structure.
Family breed(std::uint64_t seed, std::size_t operations) {
  const gait_evolution::Variation variation{.add_link_probability = 0.5, .add_node_probability = 0.2};
  Family family;
  for (std::uint64_t i = 0; i < 6; ++i) {
    Rng rng{seed, Stream::gait_founder, i};
    family.genomes.push_back(gait_evolution::random_genome(variation, family.innovations, rng));
  }
  for (std::size_t operation = 0; operation < operations; ++operation) {
    Rng rng{seed, Stream::gait_variation, operation};
    Genome& changed = family.genomes[rng.index(family.genomes.size())];
    const Genome& partner = family.genomes[rng.index(family.genomes.size())];
    if (rng.chance(0.3)) changed = gait_evolution::crossover(changed, partner, rng);
    gait_evolution::mutate(changed, variation, family.innovations, rng);
  }
  return family;
}

}  // namespace

TEST_CASE("genomes stay valid under any sequence of mutations and crossovers") {
  CHECK(rc::check("every genome is valid and every query finite", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto operations = *rc::gen::inRange<std::size_t>(0, 200);
    const Family family = breed(seed, operations);
    for (const Genome& genome : family.genomes) {
      gait_evolution::validate(genome);
      const gait_evolution::Network network{genome};
      for (int x = -2; x <= 2; ++x) RC_ASSERT(std::isfinite(network({x, 1, 0}, {1, -x, 2})));
      for (const gait_evolution::LinkGene& link : genome.links) {
        RC_ASSERT((family.innovations.links().at(link.innovation) == gait_evolution::Innovations::Ends{link.from, link.to}));
      }
    }
  }));
}

TEST_CASE("genome: three thousand operations on one family -> valid genomes") {
  const Family family = breed(2024, 3000);
  std::size_t hidden = 0;
  for (const Genome& genome : family.genomes) {
    gait_evolution::validate(genome);
    hidden += genome.nodes.size() - 1;
  }
  CHECK(hidden > 100);
}

TEST_CASE("the same seed makes the same genomes, another seed others") {
  CHECK(rc::check("breed is a function of its seed", [](std::uint64_t seed) {
    const auto first = breed(seed, 60);
    const auto second = breed(seed, 60);
    RC_ASSERT(first.genomes == second.genomes);
    RC_ASSERT(first.innovations.links() == second.innovations.links());
    RC_ASSERT(first.innovations.splits() == second.innovations.splits());
    RC_ASSERT(first.genomes != breed(seed + 1, 60).genomes);
  }));
}

TEST_CASE("a genome written as TOML reads back as the same genome") {
  CHECK(rc::check("round trip through text", [](std::uint64_t seed) {
    for (const Genome& genome : breed(seed, 40).genomes) {
      trophic::TomlWriter writer;
      gait_evolution::put_genome(writer, genome);
      const auto table = trophic::detail::TomlTable::parse(writer.text(), "memory");
      RC_ASSERT(gait_evolution::read_genome(table) == genome);
    }
  }));
}
