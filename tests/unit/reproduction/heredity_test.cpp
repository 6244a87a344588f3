// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <numeric>
#include <set>
#include <trophic/control/brain/cognitive_brain_with_biases.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/control/brain/recurrent_brain.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/control/gait/learnt.hpp>
#include <trophic/reproduction/heredity/all_but.hpp>
#include <trophic/reproduction/heredity/crossover_by_neuron.hpp>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/reproduction/heredity/own_copy.hpp>
#include <trophic/reproduction/heredity/shared_copy.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/rules/by_species.hpp>
#include <unit/reproduction/births.hpp>
#include <vector>

using namespace trophic;
using namespace reproduction::heredity;

TEST_CASE("all but: one part of the genome -> drawn anew, the others inherited") {
  const auto parent =
      std::make_shared<Genome>(Genome{.id = 3, .weights = {1}, .gait_genes = {2}, .body_genes = {3}, .traits = {4}});
  CHECK(AllButTraits{}.inherit(parent)->traits.empty());
  CHECK(AllButBrain{}.inherit(parent)->weights.empty());
  CHECK(AllButBrain{}.inherit(parent)->gait_genes == std::vector<double>{2});
  CHECK(AllButGait{}.inherit(parent)->gait_genes.empty());
  CHECK(AllButGait{}.inherit(parent)->body_genes == std::vector<double>{3});
  CHECK(AllButBody{}.inherit(parent)->body_genes.empty());
  CHECK(AllButBody{}.inherit(parent)->weights == std::vector<double>{1});
  CHECK(parent->body_genes == std::vector<double>{3});
  test::Births<with_heredity<test::Evolving, AllButBody>> births;
  const std::vector<double> first = body::genes_of(births.habitat.design->modules);
  for (int birth = 0; birth < 40; ++birth)
    CHECK(births.birth(birth % 2 == 0 ? 0 : 2, birth % 2 == 0 ? 2 : 0).genome->body_genes == first);
}

TEST_CASE("nothing inherited: any parent -> no genome passed on") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.5}});
  CHECK(reproduction::heredity::NothingInherited{}.inherit(parent) == nullptr);
}

TEST_CASE("switched: off for one species -> its offspring inherit nothing, the other's as ever") {
  using Rules = with_heredity<rules::Paper, rules::by_species<Switched<OwnCopy>>>;
  for (const bool inherited : {true, false}) {
    test::Births<Rules> births{[&](auto& params) { params.heredity.template get<test::predator>().inherited = inherited; }};
    const auto before = (*births.population)[2].genome->weights;
    const auto after = births.birth(0, 2).genome->weights;
    CHECK((std::abs(after[0] - before[0]) < 0.3) == inherited);
  }
  CHECK(Switched<OwnCopy>::name == "switched_own_copy");
}

TEST_CASE("own copy: parent -> equal weights in another object, parent unchanged by mutation") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.25, -0.5}});
  const auto offspring = reproduction::heredity::OwnCopy{}.inherit(parent);
  REQUIRE(offspring != parent);
  CHECK(offspring->weights == parent->weights);
  offspring->weights[0] = 9.0;
  CHECK(parent->weights == std::vector<double>{0.25, -0.5});
}

TEST_CASE("shared copy: parent, offspring and grandchild -> one object, each mutation reaches all") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.25, -0.5}});
  const reproduction::heredity::SharedCopy rule;
  const auto offspring = rule.inherit(parent);
  const auto grandchild = rule.inherit(offspring);
  grandchild->weights[1] = 1.0;
  CHECK(parent->weights[1] == 1.0);
  CHECK(offspring->weights[1] == 1.0);
  CHECK(grandchild->id == 3);
}

TEST_CASE("crossover: two parents -> each number is one parent's, about half of them") {
  const auto genome = [](double value) {
    return std::make_shared<Genome>(
        Genome{.weights = std::vector<double>(300, value), .gait_genes = std::vector<double>(30, value), .traits = {value}});
  };
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = genome(0.5)},
                                      {.id = 2, .species = 0, .genome = genome(1.5)}};
  const auto sum = [](const std::vector<double>& genes) { return std::accumulate(genes.begin(), genes.end(), 0.0); };
  Rng rng{1, Stream::user};
  const auto child = Crossover{}.inherit(parents, rng);
  for (const double weight : child->weights) CHECK((weight == 0.5 || weight == 1.5));
  CHECK(sum(child->weights) == doctest::Approx(300.0).epsilon(0.1));
  CHECK(sum(child->gait_genes) > 15.0);
  CHECK(sum(child->gait_genes) < 45.0);
  CHECK(sum(parents[0].genome->weights) == 150.0);
  double traits = 0.0;
  for (int birth = 0; birth < 400; ++birth) traits += Crossover{}.inherit(parents, rng)->traits.at(0);
  CHECK(traits == doctest::Approx(400.0).epsilon(0.1));
}

TEST_CASE("crossover by neuron: two parents -> all that enters a neuron is one parent's, each neuron's half of the time") {
  using namespace control::brain;
  const auto neurons_of = [](const auto& brain) {  // with two inputs and one output
    const std::vector<std::size_t> neurons = brain.neurons(2, 1);
    CHECK(neurons.size() == brain.genome_size(2, 1));
    return neurons;
  };
  using Numbers = std::vector<std::size_t>;
  CHECK(neurons_of(CognitiveBrain{}) == Numbers{0, 0, 1, 1, 2, 2, 3, 3, 3});
  CHECK(neurons_of(FeedForwardBrain{{.hidden = 2}}) == Numbers{0, 0, 1, 1, 2, 2});
  CHECK(neurons_of(RecurrentBrain{{.hidden = 2}}) == Numbers{0, 0, 1, 1, 0, 0, 1, 1, 2, 2});
  CHECK(neurons_of(Hebbian<FeedForwardBrain>{}) == neurons_of(CognitiveBrain{}));
  const Numbers neurons = neurons_of(CognitiveBrainWithBiases{});
  CHECK(neurons == Numbers{0, 0, 1, 1, 2, 2, 0, 1, 2, 3, 3, 3, 3});

  const auto genome = [](double value, std::size_t weights) {
    return std::make_shared<Genome>(Genome{.weights = std::vector<double>(weights, value), .traits = {value}});
  };
  std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = genome(0.0, 13)},
                                {.id = 2, .species = 0, .genome = genome(1.0, 13)}};
  Rng rng{1, Stream::user};
  std::array<double, 4> seconds{};
  std::set<std::vector<double>> brains;
  for (int birth = 0; birth < 400; ++birth) {
    const std::vector<double> weights = CrossoverByNeuron{}.inherit(parents, rng, {.neurons = neurons})->weights;
    const std::array first{weights[0], weights[2], weights[4], weights[9]};  // of each neuron
    for (std::size_t weight = 0; weight < 13; ++weight) CHECK(weights[weight] == first.at(neurons[weight]));
    for (std::size_t neuron = 0; neuron < 4; ++neuron) seconds.at(neuron) += first.at(neuron);
    brains.insert(weights);
  }
  for (const double second : seconds) CHECK(second == doctest::Approx(200.0).epsilon(0.2));
  CHECK(brains.size() == 16);  // every combination of four neurons

  const auto copy = CrossoverByNeuron{}.inherit(std::span{parents}.first(1), rng, {.neurons = neurons});
  CHECK(copy->weights == parents[0].genome->weights);
  CHECK(copy != parents[0].genome);
  parents[1].genome = genome(1.0, 4);
  for (int birth = 0; birth < 20; ++birth)
    CHECK(std::set<std::size_t>{4, 13}.contains(CrossoverByNeuron{}.inherit(parents, rng, {.neurons = neurons})->weights.size()));
}

TEST_CASE("crossover: one parent, or parts of other lengths or structure -> one parent's whole part") {
  const auto first = std::make_shared<Genome>(Genome{.weights = {0.1, 0.2}, .gait_genes = {1.0, 0.5}});
  const auto second = std::make_shared<Genome>(Genome{.weights = {0.3}, .gait_genes = {2.0, 0.7}});
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = first}, {.id = 2, .species = 0, .genome = second}};
  Rng rng{1, Stream::user};
  std::size_t firsts = 0;
  for (int birth = 0; birth < 100; ++birth) {
    const auto child = Crossover{}.inherit(parents, rng, {.gait_genes = {0}});
    const bool is_first = child->weights == first->weights;
    const auto& pattern = is_first ? first : second;
    CHECK(child->weights == pattern->weights);
    CHECK(child->gait_genes == pattern->gait_genes);
    firsts += is_first ? 1U : 0U;
  }
  CHECK(firsts > 30);
  CHECK(firsts < 70);
  const auto copy = Crossover{}.inherit(std::span{parents}.first(1), rng);
  CHECK(copy->weights == first->weights);
  CHECK(copy != first);
}

TEST_CASE("crossover: two bodies -> one with a subtree of the other at a face that both have, or unchanged if parts overlap") {
  const auto genome = [](std::string_view plan) {
    return std::make_shared<Genome>(Genome{.body_genes = body::genes_of(body::read_plan(plan))});
  };
  const auto plans_of = [&](std::string_view one, std::string_view other) {
    const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = genome(one)},
                                        {.id = 2, .species = 0, .genome = genome(other)}};
    std::set<std::string> plans;
    Rng rng{1, Stream::user};
    for (int birth = 0; birth < 200; ++birth)
      plans.insert(body::text_of(body::tree_of(Crossover{}.inherit(parents, rng, {.has_modules = true})->body_genes)));
    return plans;
  };
  CHECK(plans_of("core[front:hinge0 left:hinge0[front:brick0]]", "core[front:brick1 right:hinge0]") ==
        std::set<std::string>{"core[front:hinge0 left:hinge0[front:brick0]]", "core[front:brick1 right:hinge0]",
                              "core[front:brick1 left:hinge0[front:brick0]]", "core[front:hinge0 right:hinge0]"});
  CHECK(plans_of("core[front:hinge0]", "core[back:hinge0]") == std::set<std::string>{"core[front:hinge0]", "core[back:hinge0]"});
  CHECK(body::text_of(body::tree_of(genome("core[front:brick0]")->body_genes)) == "core[front:brick0]");
  // genes of another encoding, even if they read as a plan
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = genome("core[front:hinge0 left:hinge0]")},
                                      {.id = 2, .species = 0, .genome = genome("core[front:brick1 right:hinge0]")}};
  Rng rng{1, Stream::user};
  for (int birth = 0; birth < 20; ++birth) {
    const auto genes = Crossover{}.inherit(parents, rng)->body_genes;
    CHECK((genes == parents[0].genome->body_genes || genes == parents[1].genome->body_genes));
  }
}

namespace {

struct Reach {
  static constexpr std::string_view name = "reach_m";
  static constexpr double first = 8.0, least = 1.0, most = 20.0, sd = 0.5;
};
struct Taste {
  static constexpr std::string_view name = "taste";
  static constexpr double first = 0.5, least = 0.0, most = 1.0, sd = 0.1;
};

/// The share of children of two parents, as a table makes them, whose `part` is neither parent's. The parents differ in the first
/// `differing` of the part's values: one has `bound` there, the other `inside`.
template <class Rules>
double mixed_share(std::vector<double> Genome::*part, std::span<const std::size_t> values, std::size_t differing, double bound) {
  test::Births<Rules> births{[](auto& params) { params.mutation.sd = 0.0; }};
  auto& population = *births.population;
  std::vector<Ancestor> parents{population[2].as_ancestor(), population[3].as_ancestor()};
  (*parents[1].genome).*part = (*parents[0].genome).*part;
  for (std::size_t i = 0; i < differing; ++i) {
    ((*parents[0].genome).*part).at(values[i]) = bound;
    ((*parents[1].genome).*part).at(values[i]) = 0.5 * bound - 0.1;
  }
  const auto before = [&](std::size_t parent) { return (*parents[parent].genome).*part; };
  const std::array both{before(0), before(1)};
  const View view{.web = births.web, .arena = births.habitat.arena, .robots = population.individuals(), .poses = births.poses};
  constexpr int children = 1000;
  int mixed = 0;
  for (int child = 0; child < children; ++child) {
    population.replace(0, test::predator, {.descent = reproduction::Descent::of_parent, .parents = parents}, view);
    const std::vector<double> own = (*population[0].genome).*part;
    for (std::size_t gene = 0; gene < own.size(); ++gene) CHECK((own[gene] == both[0][gene] || own[gene] == both[1][gene]));
    mixed += own != both[0] && own != both[1] ? 1 : 0;
    CHECK(population[0].mutation_distance == 0.0);
  }
  CHECK(before(0) == both[0]);
  return static_cast<double>(mixed) / children;
}

/// Says that a gene which it does not have is structure.
struct BeyondItsGenes : control::gait::InheritedCpg {
  static constexpr std::string_view name = "beyond_its_genes";
  [[nodiscard]] std::vector<std::size_t> structure(std::span<const double> genes) const { return {genes.size()}; }
};

template <class Rules>
using Crossing = with_heredity<Rules, Crossover>;
template <class Rule>
using Still = with_params<Crossing<with_gait<rules::Paper, Rule>>, [](auto& params) {
  if constexpr (requires { params.gait.sd; }) params.gait.sd = 0.0;
  if constexpr (requires { params.gait.weight_probability; })
    params.gait.weight_probability = params.gait.link_probability = params.gait.node_probability = 0.0;
}>;
using Growing = with_params<Crossing<with_brain<rules::Paper, control::brain::GrowingBrain>>, [](auto& params) {
  params.brain.add_link = params.brain.remove_link = params.brain.split_link = params.brain.remove_neuron = 0.0;
}>;
using Traited = with_params<Crossing<with_traits<rules::Paper, reproduction::traits::List<Reach, Taste>>>,
                            [](auto& params) { params.traits.template get<0>().sd = params.traits.template get<1>().sd = 0.0; }>;

}  // namespace

TEST_CASE("crossover: parents of equal structure, one at its bounds -> 1 - 2^(1 - n) of children are mixed, n numbers differ") {
  const auto from = [](std::size_t first, std::size_t step = 1) {
    std::vector<std::size_t> values;
    for (std::size_t i = 0; i < 5; ++i) values.push_back(first + step * i);
    return values;
  };
  using namespace control::gait;
  const std::size_t links = 15;  // of the paper's network, as a brain that grows
  for (const std::size_t n : {1U, 2U, 5U}) {
    const auto share = doctest::Approx(1.0 - std::pow(2.0, 1.0 - static_cast<double>(n))).epsilon(0.12);
    CAPTURE(n);
    CHECK(mixed_share<Crossing<rules::Paper>>(&Genome::weights, from(0), n, 1.0) == share);
    CHECK(mixed_share<Growing>(&Genome::weights, from(1 + 2 * links), n, -1.0) == share);
    CHECK(mixed_share<Still<InheritedCpg>>(&Genome::gait_genes, from(0), n, 2.0) == share);
    CHECK(mixed_share<Still<InheritedCppn>>(&Genome::gait_genes, from(3, 3), n, 2.0) == share);
    if (n <= 2) CHECK(mixed_share<Traited>(&Genome::traits, from(0), n, 1.0) == share);
  }
}

TEST_CASE("crossover: structure that a gait does not have -> RuleError") {
  using Rules = Crossing<with_gait<rules::Paper, BeyondItsGenes>>;
  CHECK(message_of<RuleError>([] {
          static_cast<void>(mixed_share<Rules>(&Genome::gait_genes, std::vector<std::size_t>{0}, 1, 2.0));
        }).find("a gene of the structure") != std::string::npos);
}

TEST_CASE("crossover: parents of other structure -> children have one parent's part") {
  using namespace control::gait;
  const auto one = std::make_shared<Genome>(Genome{.weights = {1, 0, 2, 2, 3, 0.5, 0.25}});
  const auto two = std::make_shared<Genome>(Genome{.weights = {1, 1, 2, 2, 3, 0.75, 1.0}});
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = one}, {.id = 2, .species = 0, .genome = two}};
  Rng rng{1, Stream::user};
  for (int birth = 0; birth < 40; ++birth) {
    const auto own = Crossover{}.inherit(parents, rng, {.weights = {0, 1, 2, 3, 4}})->weights;
    CHECK((own == one->weights || own == two->weights));
  }
  const auto genes = control::ask::weight_structure(control::brain::GrowingBrain{}, {1, 0, 2, 1, 2, 2, 3, 0.5, 1.0, -1.0});
  CHECK(genes == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6});
  CHECK(control::ask::weight_structure(control::brain::CognitiveBrain{}, {1.0, 0.5}).empty());
  CHECK(control::ask::gait_structure(InheritedCpg{}, std::vector{1.0, 0.5}).empty());
  const std::vector<double> network{1, 2, 0, 7, 1.0, 7, 8, 0.5};  // one hidden node, two links
  CHECK(control::ask::gait_structure(InheritedCppn{}, network) == std::vector<std::size_t>{0, 1, 2, 3, 5, 6});
  std::vector<double> learnt{8};
  for (int twice = 0; twice < 2; ++twice) learnt.insert(learnt.end(), network.begin(), network.end());
  CHECK(control::ask::gait_structure(Learnt<InheritedCppn>{}, learnt) ==
        std::vector<std::size_t>{0, 1, 2, 3, 4, 6, 7, 9, 10, 11, 12, 14, 15});
}
