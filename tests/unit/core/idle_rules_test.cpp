// SPDX-License-Identifier: MIT
// Rules that can never act by their parameters -> a remark, and worlds that do what it states.
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/death/capture/catch_outside_refuges.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/installed_models.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/worlds/two_foods.hpp>

using namespace trophic;
using rules::Paper;

namespace {

template <class Rules>
std::vector<std::string> remarks(const Experiment<Rules>& experiment) {
  const BackendChoice engine = backend::Kinematic::Params{};
  const auto checked = load_checked(experiment, engine, TROPHIC_MODEL_DIR);
  auto found = describe(checked.params, engine, checked.habitat, 100.0).remarks;
  std::erase_if(found, [](const std::string& remark) { return remark.starts_with("physics"); });
  return found;
}

Experiment<Paper> dozen(std::size_t predators, std::size_t floor, std::size_t below) {
  Experiment<Paper> experiment{.seed = 1};
  experiment.ecology.robots = 12;
  experiment.rules.community.predators = predators;
  experiment.rules.floor.floor = floor;
  experiment.rules.minimum_predators.below = below;
  return experiment;
}

/// An observer that counts catches.
struct Catches {
  std::size_t count = 0;
  void on_event(const observe::Event& event, const View&) {
    if (event.cause == Cause::caught) ++count;
  }
};

std::size_t catches(const Experiment<Paper>& experiment) {
  Ecology<Paper> ecology{experiment, backend::Kinematic::Params{}};
  Catches caught;
  ecology.run_until(2000.0, caught);
  return caught.count;
}

}  // namespace

TEST_CASE("idle rules: floor and minimum that use up all robots -> a remark, and no catch in such a world") {
  const std::string together =
      "rules.floor.floor = 7 and rules.minimum_predators.below = 7: with 12 robots every prey above the floor is sacrificed, so "
      "no prey is left to be caught";
  CHECK(
      remarks(dozen(5, 7, 7)) ==
      std::vector<std::string>{"rules.floor: floor = 7: no catch or sacrifice of prey, because the run starts with 7", together});
  CHECK(catches(dozen(5, 7, 7)) == 0);
  CHECK(remarks(dozen(5, 2, 10)).size() == 1);
  CHECK(remarks(dozen(5, 2, 2)).empty());
  CHECK(catches(dozen(5, 2, 2)) > 0);
  CHECK(remarks(Experiment<Paper>{}).empty());
}

TEST_CASE("idle rules: distance or number that the world does not reach -> a remark that names rule, part and parameter") {
  Experiment<Paper> experiment;
  experiment.rules.activation.distance_m = 30.0;
  experiment.rules.starvation.interval.only_above = 30;
  CHECK(remarks(experiment) ==
        std::vector<std::string>{
            "rules.activation: distance_m = 30: no newborn of a hunted species ever becomes active, because arena walled_square "
            "has a diagonal of 28.3 m",
            "rules.starvation: interval.only_above = 30: no hunter ever starves, because there are 30 robots"});
  CHECK(remarks(Experiment<with_capture<Paper, death::capture::CatchOutsideRefuges>>{}) ==
        std::vector<std::string>{
            "rules.capture: catch_outside_refuges protects no prey: arena walled_square has no zone named refuge"});
}

TEST_CASE("idle rules: diets in a table of one food -> a remark, with two foods none") {
  using Eaters = with_metabolism<worlds::Pond, rules::by_species<energy::metabolism::GrazingByDiet<>>>;
  using OneFood = with_traits<Eaters, reproduction::traits::List<energy::metabolism::Diet>>;
  CHECK(remarks(Experiment<OneFood>{}) ==
        std::vector<std::string>{
            "rules.metabolism: diets have no effect: the table has one food or none (energy::resource::Foods)"});
  CHECK(remarks(Experiment<worlds::TwoFoods>{}).empty());
  Experiment<worlds::TwoFoods> experiment;
  experiment.rules.recruitment.birth_J = 5000.0;
  CHECK(remarks(experiment).size() == 2);
}

TEST_CASE("idle rules: births that cost more than a body holds -> a remark for each species") {
  Experiment<worlds::Pond> experiment;
  CHECK(remarks(experiment).empty());
  experiment.rules.recruitment.birth_J = 5000.0;
  const auto said = remarks(experiment);
  REQUIRE(said.size() == 2);
  CHECK(said[0].starts_with("rules.recruitment: no prey is ever born: birth_J = 5000 is above rules.metabolism's capacity_J = "));
}

namespace {

struct NeverOld {
  static constexpr std::string_view name = "never_old";
  bool dies(const Individual&, const View&, Rng&) const { return false; }
  std::string idle(const Outset& outset) const { return "none of " + std::to_string(outset.robots) + " ever dies"; }
};

}  // namespace

TEST_CASE("idle rules: rule of one's own that states it, alone or of each species -> a remark") {
  CHECK(remarks(Experiment<with_senescence<Paper, NeverOld>>{}) ==
        std::vector<std::string>{"rules.senescence: none of 30 ever dies"});
  CHECK(remarks(Experiment<with_senescence<Paper, rules::by_species<NeverOld>>>{}) ==
        std::vector<std::string>{"rules.senescence: for prey, none of 30 ever dies",
                                 "rules.senescence: for predator, none of 30 ever dies"});
}
