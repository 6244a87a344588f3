// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <map>
#include <support/hand_population.hpp>
#include <trophic/reproduction/recruitment/mate/alike_genomes.hpp>
#include <trophic/reproduction/recruitment/mate/alike_in.hpp>
#include <trophic/reproduction/recruitment/mate/other_sex.hpp>
#include <trophic/reproduction/recruitment/with_mate.hpp>

using namespace trophic;
using namespace trophic::test;
using namespace trophic::reproduction::recruitment;
using reproduction::traits::List;
using reproduction::traits::Sex;

namespace {

struct Hue {
  static constexpr std::string_view name = "hue";
  static constexpr double first = 0.0, least = -9.0, most = 9.0, sd = 0.1;
};
struct Mate {
  double x_m = 0.0;
  double sex = 0.0;
  double hue = 0.0;
  double energy_J = 80.0;
  bool active = true;
  Species species = prey;
};

/// Individuals 0, 1, ... in a row, with traits.
[[nodiscard]] HandPopulation row_of(const std::vector<Mate>& mates) {
  std::vector<Robot> robots;
  for (const Mate& mate : mates) robots.push_back({.species = mate.species, .x_m = mate.x_m, .active = mate.active});
  HandPopulation population{robots};
  population.traits = {"sex", "hue"};
  for (std::size_t i = 0; i < mates.size(); ++i) {
    population.individuals[i].energy_J = mates[i].energy_J;
    population.individuals[i].genome->traits = {mates[i].sex, mates[i].hue};
  }
  return population;
}

using Pairs = std::vector<std::vector<IndividualId>>;
[[nodiscard]] Pairs pairs_of(const auto& rule, const HandPopulation& population, std::uint64_t seed = 1) {
  Rng rng{seed, Stream::user};
  Pairs pairs;
  for (const auto& birth : rule.recruits(population.view(), rng)) {
    pairs.emplace_back();
    for (const Ancestor& parent : birth.parents) pairs.back().push_back(parent.id);
  }
  Rng same{seed, Stream::user};  // one draw per birth
  for (std::size_t birth = 0; birth < pairs.size(); ++birth) same.uniform();
  CHECK(rng.bits() == same.bits());
  return pairs;
}

/// How often individual 0 chooses each other one in 20,000 ticks, as a share.
[[nodiscard]] std::map<IndividualId, double> shares_of_first(const auto& rule, const HandPopulation& population) {
  std::map<IndividualId, double> shares;
  Rng rng{1, Stream::user};
  for (int tick = 0; tick < 20'000; ++tick)
    for (const auto& birth : rule.recruits(population.view(), rng))
      if (birth.parents[0].id == 0) shares[birth.parents[1].id] += 1.0 / 20'000;
  return shares;
}

}  // namespace

TEST_CASE("with mate: sex, distance, energy, activity and species -> the pairs that may be parents") {
  using BySex = WithMate<mate::OtherSex>;
  const struct {
    const char* what;
    std::vector<Mate> robots;
    Pairs of_any;  ///< without preferences
    Pairs of_sexes;
  } cases[]{
      {"alone", {{.sex = 1}}, {}, {}},
      {"two females", {{.sex = 1}, {.x_m = 1.0, .sex = 1}}, {{0, 1}}, {}},
      {"two males", {{.sex = 0}, {.x_m = 1.0, .sex = 0}}, {{0, 1}}, {}},
      {"the younger is the mother", {{.sex = 0}, {.x_m = 1.0, .sex = 1}}, {{0, 1}}, {{1, 0}}},
      {"too far", {{.sex = 1}, {.x_m = 3.1}}, {}, {}},
      {"poor", {{.sex = 1}, {.x_m = 1.0, .energy_J = 59.0}}, {}, {}},
      {"inactive", {{.sex = 1}, {.x_m = 1.0, .active = false}}, {}, {}},
      {"another species", {{.sex = 1}, {.x_m = 1.0, .species = predator}}, {}, {}},
      {"two pairs apart", {{.sex = 1}, {.x_m = 8.0, .sex = 1}, {.x_m = 7.0}, {.x_m = 1.0}}, {{0, 3}, {1, 2}}, {{0, 3}, {1, 2}}},
      {"two females, one male: the older one's", {{.sex = 1}, {.x_m = 1.0, .sex = 1}, {.x_m = 2.9}}, {}, {{0, 2}}}};
  for (const auto& one : cases) {
    CAPTURE(one.what);
    const HandPopulation population = row_of(one.robots);
    CHECK(pairs_of(BySex{}, population) == one.of_sexes);
    if (one.robots.size() != 3) CHECK(pairs_of(WithMate<>{}, population) == one.of_any);
  }
}

TEST_CASE("with mate: both pay or one -> the endowment, the energy that a mate needs, and who pays") {
  const HandPopulation population = row_of({{.sex = 1, .energy_J = 90.0}, {.x_m = 1.0, .energy_J = 70.0}});
  WithMate<mate::OtherSex> rule{{.spare_bodies = 3, .birth_J = 60.0, .share = 0.25}};
  Rng rng{1, Stream::user};
  const auto both = rule.recruits(population.view(), rng);
  REQUIRE(both.size() == 1);
  CHECK(both[0].endowment_J == 35.0);
  CHECK_FALSE(both[0].first_pays);
  rule.params.both_pay = false;
  rule.params.birth_J = 80.0;
  const auto one = rule.recruits(population.view(), rng);
  REQUIRE(one.size() == 1);
  CHECK(one[0].endowment_J == 22.5);
  CHECK(one[0].first_pays);
  rule.params.both_pay = true;
  CHECK(rule.recruits(population.view(), rng).empty());
  CHECK(rule.spare_bodies() == 3);
  CHECK(rule.leaves_spare({.body = 0, .cause = Cause::caught}, population.view()));
  static_assert(reproduction::names_several_parents<WithMate<>>);
  CHECK(WithMate<mate::OtherSex, mate::AlikeIn<Hue>>::name == "with_mate_other_sex_alike_in_hue");
}

TEST_CASE("alike in: strength 0 -> all near are as likely, else likeliness by the Gaussian function of the difference") {
  const HandPopulation population = row_of({{.sex = 1}, {.x_m = 0.1, .hue = 0.5}, {.x_m = -0.2, .hue = 2.0}, {.x_m = 0.3}});
  for (const double strength : {0.0, 1.0, 3.0}) {
    CAPTURE(strength);
    WithMate<mate::OtherSex, mate::AlikeIn<Hue>> rule;
    rule.params.mate.get<1>().strength = strength;
    auto shares = shares_of_first(rule, population);
    const auto weight = [&](double apart) { return std::exp(-0.5 * strength * strength * apart * apart); };
    const double sum = weight(0.5) + weight(2.0) + 1.0;
    CHECK(shares[1] == doctest::Approx(weight(0.5) / sum).epsilon(0.02));
    CHECK(shares[2] == doctest::Approx(weight(2.0) / sum).scale(0.5).epsilon(0.02));
    CHECK(shares[3] == doctest::Approx(1.0 / sum).epsilon(0.02));
  }
}

TEST_CASE("alike genomes: by the root mean square difference of the weights, other numbers of weights only with strength 0") {
  HandPopulation population = row_of({{}, {.x_m = 1.0}, {.x_m = 2.0}, {.x_m = -1.0}});
  const std::vector<std::vector<double>> weights{{0.0, 0.0}, {0.0, 0.0}, {0.6, 0.8}, {0.0, 0.0, 0.0}};
  for (std::size_t i = 0; i < weights.size(); ++i) population.individuals[i].genome->weights = weights[i];
  mate::AlikeGenomes rule{{.strength = 2.0}};
  const View view = population.view();
  CHECK(rule.weight(0, 1, view) == 1.0);
  CHECK(rule.weight(0, 2, view) == doctest::Approx(std::exp(-0.5 * 4.0 * 0.5)));
  CHECK(rule.weight(0, 3, view) == 0.0);
  rule.params.strength = 0.0;
  for (BodyIndex other = 1; other < 4; ++other) CHECK(rule.weight(0, other, view) == 1.0);
}

TEST_CASE("other sex: only a female chooses, and only a male") {
  const HandPopulation population = row_of({{.sex = 0}, {.sex = 0}, {.sex = 1}, {.sex = 1}});
  const View view = population.view();
  for (BodyIndex self = 0; self < 4; ++self)
    for (BodyIndex other = 0; other < 4; ++other) CHECK(mate::OtherSex{}.weight(self, other, view) == (self > 1 && other < 2));
}

TEST_CASE("sex: one draw, the share of females, whatever the parent's sex") {
  const List<Sex, Hue> rule{};
  List<Sex, Hue>::Params params;
  params.get<0>().female_share = 0.3;
  const List<Sex, Hue> few{params};
  Rng rng{1, Stream::user};
  Rng same{1, Stream::user};
  std::vector<double> traits = rule.draw(rng);
  for (int draws = 0; draws < 3; ++draws) same.uniform();
  CHECK(rng.bits() == same.bits());
  CHECK_FALSE(rule.beyond(traits));
  std::map<double, double> females;
  for (const double parent : {0.0, 1.0})
    for (int birth = 0; birth < 10'000; ++birth) {
      traits = {parent, 0.0};
      few.mutate(traits, rng);
      CHECK((traits[0] == 0.0 || traits[0] == 1.0));
      females[parent] += traits[0] / 10'000.0;
    }
  CHECK(females[0.0] == doctest::Approx(0.3).epsilon(0.05));
  CHECK(females[1.0] == doctest::Approx(0.3).epsilon(0.05));
}
