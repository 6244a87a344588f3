// SPDX-License-Identifier: MIT
// Genomes of several parts: gaits of individuals, brains that grow, heredities that leave parts out.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <support/toy_bodies.hpp>
#include <tools/recording/read_recording.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/control/gait/learnt.hpp>
#include <trophic/control/gait/named_gait.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/initialization/placement/uniform_square.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/body_plan/named_body.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
using namespace trophic::test;
using control::gait::InheritedCpg;
using control::gait::InheritedCppn;

namespace {

/// A brain whose genes are a count and that many weights; an offspring has one more.
struct Growing {
  static constexpr std::string_view name = "growing";
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }
  [[nodiscard]] std::vector<double> first(std::size_t inputs, std::size_t, Rng&) const {
    std::vector<double> genes(inputs + 1);
    genes[0] = static_cast<double>(inputs);
    return genes;
  }
  [[nodiscard]] std::span<double> weights_of(std::span<double> genes) const { return genes.subspan(1); }
  void mutate_structure(std::vector<double>& genes, std::size_t, std::size_t, Rng& rng) const {
    ++genes[0];
    genes.push_back(rng.uniform());
  }
  [[nodiscard]] bool fits(std::span<const double> genes, std::size_t, std::size_t) const {
    return !genes.empty() && genes[0] == static_cast<double>(genes.size() - 1);
  }
  [[nodiscard]] control::Decision decide(std::span<const double> inputs, std::span<const double> genes) const {
    const bool right = inputs[0] * genes[1] > 0.0;
    return {.target_angle_rad = right ? 0.7 : -0.7, .tag = genes.back() > 0.5 ? 1 : -1};
  }
};
using Grows = with_brain<rules::Paper, Growing>;

/// Passes on the brain alone, or the gait alone.
struct BrainOnly {
  static constexpr std::string_view name = "brain_only";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const {
    return std::make_shared<Genome>(Genome{.id = 0, .weights = parent->weights});
  }
};
struct GaitOnly {
  static constexpr std::string_view name = "gait_only";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const {
    return std::make_shared<Genome>(Genome{.id = 0, .gait_genes = parent->gait_genes});
  }
};

/// Loses a weight of the parent.
struct Forgetful {
  static constexpr std::string_view name = "forgetful";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const {
    return std::make_shared<Genome>(Genome{.id = 0, .weights = {parent->weights.begin(), parent->weights.end() - 1}});
  }
};

using Gaits = with_gait<rules::Paper, InheritedCpg>;

/// Two prey and two predators in a row; the predator in body 2 catches the prey in body 0.
template <class Rules>
struct Birth {
  explicit Birth(RuleParams<Rules> numbers = {})
      : policies{[&] {
          numbers.genome_source.random_share = 0.0;
          return make_policies<Rules>(numbers);
        }()},
        population{policies, web, 99, std::vector<Species>{prey, prey, predator, predator}, {.habitat = &habitat}} {
    parent = *population[2].genome;
    const View view{.web = web, .arena = habitat.arena, .robots = population.individuals(), .poses = poses};
    const auto parentage = parentage_of(policies, population, {.body = 0, .cause = Cause::caught, .killer = 2}, view);
    population.replace(0, predator, parentage, view);
    child = *population[0].genome;
  }
  Habitat habitat = load_habitat(rules::Paper::ecology());
  FoodWeb web = predator_prey_web();
  std::vector<GroundPose> poses = std::vector<GroundPose>(4);
  Policies<Rules> policies;
  Population<Rules> population;
  Genome parent;
  Genome child;
};

double largest_step(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

using Hunt = with_embodiment<with_body_plan<rules::Paper, rules::by_species<reproduction::body_plan::NamedBody>>,
                             initialization::embodiment::StandsUp>;

Experiment<Hunt> spiders_hunt_geckos() {
  Experiment<Hunt> experiment;
  experiment.rules.body_plan.get<prey>().robot = "gecko";
  return experiment;
}

/// Random gaits, and those of them alone that survive a trial.
using RandomGaits = with_embodiment<with_body_plan<with_gait<rules::Paper, InheritedCpg>, reproduction::body_plan::NamedBody>,
                                    initialization::embodiment::StandsUp>;
using TriedGaits = with_viability<RandomGaits, reproduction::viability::SurvivesTrial<reproduction::viability::ModuleLimits>>;

/// Bodies that evolve; all die of age every few seconds.
using Turnover = with_parent_after<
    with_senescence<with_placement<rules::Paper, initialization::placement::UniformSquare>, death::senescence::OldAge>,
    Cause::senescence, reproduction::parent::NearestConspecific>;
using Crowded = with_viability<with_gait<with_embodiment<with_body_plan<Turnover, reproduction::body_plan::InheritedModules>,
                                                         initialization::embodiment::StandsUp>,
                                         InheritedCppn>,
                               reproduction::viability::ModuleLimits>;

/// Counts births, and newborns that touch another robot or a wall.
struct SetDown {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind != observe::EventKind::birth) return;
    ++births;
    const auto boxes_of = [&](BodyIndex body) {
      return placed_boxes(*view.phenotypes[body].robot, ecology->backend().pose(body), ecology->backend().joint_angles(body));
    };
    const auto own = boxes_of(event.body);
    bool is_free = !touch_wall(own, view.arena.half_side_m);
    for (BodyIndex other = 0; other < view.robots.size(); ++other) {
      if (other == event.body || distance_m(view.poses[event.body], view.poses[other]) > 2.0) continue;
      is_free = is_free && !touch(own, boxes_of(other));
    }
    overlaps += is_free ? 0 : 1;
  }
  const Ecology<Crowded>* ecology;
  std::size_t births = 0;
  std::size_t overlaps = 0;
};

/// Counts deaths of individuals whose bodies diverged, and who follows them.
struct Ended {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::death && event.cause == Cause::diverged) {
      ++deaths;
      died = event.body;
      species = event.individual.species;
    } else if (event.kind == observe::EventKind::birth && died == event.body) {
      CHECK(event.individual.species == species);
      CHECK_FALSE(event.individual.parent());
      CHECK(view.phenotypes[event.body].individual == event.individual.id);
      died.reset();
    }
  }
  std::size_t deaths = 0;
  Species species = 0;
  std::optional<BodyIndex> died = {};
};

template <class Rules>
void check_resumed(double duration_s, Experiment<Rules> experiment = {}, ToyBodies::Params toys = {}) {
  const TemporaryFolder folder;
  experiment.seed = 3;
  experiment.ecology.robots = 16;
  experiment.ecology.duration_s = duration_s;
  experiment.rules.community.predators = 8;
  experiment.rules.starvation.interval.base_ticks = 10;
  const auto nothing = [](std::size_t, ToyBodies::Params&) {};
  run_in_parts(experiment, toys, folder.path() / "whole", {}, 40.0, nothing);
  run_in_parts(experiment, toys, folder.path() / "parts", {33, 71}, 40.0, nothing);
  CHECK(results_in(folder.path() / "whole") == results_in(folder.path() / "parts"));
  const bool has_genes = GaitGenes<Rules>::are_inherited || BrainGenes<Rules>::grow;
  CHECK(std::filesystem::exists(folder.path() / "whole" / "genes.csv") == has_genes);
  if (!has_genes) return;
  const std::string genes = content(folder.path() / "whole" / "genes.csv");
  CHECK(genes == content(folder.path() / "parts" / "genes.csv"));
  CHECK(genes.starts_with("id,part,index,value\n0,"));
}

}  // namespace

TEST_CASE("genome parts: inherited gait -> founders near the robot's own, offspring near its parent's") {
  const Birth<Gaits> birth;
  const Gait& own = birth.habitat.gait;
  REQUIRE(birth.parent.gait_genes.size() == 10);  // four hinges and six pairs
  CHECK(birth.parent.body_genes.empty());
  for (Eigen::Index i = 0; i < 4; ++i)
    CHECK(std::abs(birth.parent.gait_genes[static_cast<std::size_t>(i)] - own.internal[i]) < 0.3);
  CHECK(largest_step(birth.child.gait_genes, birth.parent.gait_genes) > 0.0);
  CHECK(largest_step(birth.child.gait_genes, birth.parent.gait_genes) < 0.1);
  CHECK(birth.population.phenotypes()[0].gait->internal[2] == birth.child.gait_genes[2]);
  CHECK(birth.population.phenotypes()[2].gait->internal[2] == birth.parent.gait_genes[2]);
  CHECK(birth.population.phenotypes()[0].robot == nullptr);
}

TEST_CASE("genome parts: gait of its own -> brain's numbers are as without it") {
  const Birth<Gaits> own;
  const Birth<rules::Paper> without;
  CHECK(own.child.weights == without.child.weights);
  CHECK(own.population[0].mutation_distance == without.population[0].mutation_distance);
  CHECK(without.child.gait_genes.empty());
  CHECK(without.population.phenotypes().empty());
}

TEST_CASE("genome parts: heredity that leaves a part empty -> it is drawn anew, the other one inherited") {
  const Birth<with_heredity<Gaits, BrainOnly>> brain;
  CHECK(largest_step(brain.child.weights, brain.parent.weights) < 0.5);
  CHECK(largest_step(brain.child.gait_genes, brain.parent.gait_genes) > 0.02);
  CHECK(brain.child.gait_genes == brain.population[0].genome->gait_genes);
  const Birth<with_heredity<Gaits, GaitOnly>> gait;
  CHECK(largest_step(gait.child.weights, gait.parent.weights) > 0.5);
  CHECK(largest_step(gait.child.gait_genes, gait.parent.gait_genes) < 0.1);
}

TEST_CASE("genome parts: heredity that shortens a genome -> RuleError with both lengths") {
  CHECK(message_of<RuleError>([] {
          Birth<with_heredity<rules::Paper, Forgetful>>{};
        }).ends_with("a genome of 14 weights: must have a genome of 15 weights"));
}

TEST_CASE("genome parts: brain that grows -> sizes differ, misfits are refused, missing weights count as 0 in distances") {
  const Birth<Grows> birth;
  CHECK(birth.parent.weights.size() == 4);
  CHECK(birth.child.weights.size() == 5);
  CHECK(birth.population[0].mutation_distance >= birth.child.weights.back());
  CHECK_FALSE(birth.population.misfit(0, &birth.child));
  Genome broken = birth.child;
  broken.weights.pop_back();
  CHECK(birth.population.misfit(0, &broken) == "a genome that fits the brain growing");
}

TEST_CASE("genome parts: interrupted runs -> resumed to the same bytes, genes.csv too") {
  SUBCASE("weights of a CPG") {
    check_resumed<Gaits>(200.0);
  }
  SUBCASE("CPPN of predators and prey") {
    check_resumed<with_gait<rules::Paper, rules::by_species<InheritedCppn>>>(200.0);
  }
  SUBCASE("brain that grows") {
    check_resumed<Grows>(200.0);
  }
  SUBCASE("gaits that newborns learn") {
    Experiment<with_gait<rules::Paper, control::gait::Learnt<InheritedCpg>>> experiment;
    experiment.rules.gait.trials = 3;
    experiment.rules.gait.trial_s = 1.0;
    check_resumed(200.0, experiment);
  }
}

TEST_CASE("genome parts: gaits of individuals on a backend without joints -> one sentence, no run") {
  CHECK(message_of<std::invalid_argument>([] {
          const Ecology<Gaits> ecology{{}, backend::Kinematic::Params{}};
        }) ==
        "rules.gait = inherited_cpg on backend kinematic: must be a backend with joints, on which the bodies and gaits of "
        "individuals matter");
}

TEST_CASE("genome parts: gait of the species -> each walks by its own, and a file that is missing is named") {
  using Named = with_gait<rules::Paper, rules::by_species<control::gait::NamedGait>>;
  Experiment<Named> experiment;
  experiment.rules.gait.get<predator>().gait = "spider_published";
  experiment.rules.gait.get<prey>().gait = "spider_paper";
  const Ecology<Named> ecology{experiment, ToyBodies::Params{}};
  const View view = ecology.view();
  for (BodyIndex body = 0; body < view.robots.size(); ++body) {
    CHECK(view.phenotypes[body].gait->name == (view.robots[body].species == prey ? "spider_paper" : "spider_published"));
  }
  CHECK(ecology.describe(1.0).fingerprint != Ecology<Named>{{}, ToyBodies::Params{}}.describe(1.0).fingerprint);
  experiment.rules.gait.get<prey>().gait = "gecko_paper";
  CHECK_THROWS_AS((Ecology<Named>{experiment, ToyBodies::Params{}}), std::invalid_argument);
}

TEST_CASE("genome parts: a new gait -> its pattern generator starts anew at birth") {
  using Locomotion = locomotion::Locomotion<control::steering::TargetedSteering>;
  const Habitat habitat = load_habitat(rules::Paper::ecology());
  ToyBodies bodies{habitat.robot, habitat.arena, std::vector<Pose>(2), {}, {}};
  Locomotion locomotion{habitat.robot, habitat.gait, {}, 2, {.hz = 60.0}};
  locomotion.separate();
  const std::vector<double> ahead(2);
  locomotion.advance(bodies, 30, ahead);
  locomotion.walk_by(1, habitat.robot, habitat.gait);
  locomotion.advance(bodies, 1, ahead);
  Locomotion fresh{habitat.robot, habitat.gait, {}, 2, {.hz = 60.0}};
  ToyBodies others{habitat.robot, habitat.arena, std::vector<Pose>(2), {}, {}};
  fresh.advance(others, 1, ahead);
  CHECK(std::ranges::equal(bodies.joint_angles(1), others.joint_angles(1)));
  CHECK_FALSE(std::ranges::equal(bodies.joint_angles(0), others.joint_angles(0)));
  fresh.advance(others, 30, ahead);
  CHECK(std::ranges::equal(bodies.joint_angles(0), others.joint_angles(0)));
}

TEST_CASE("bodies of species: spiders that hunt geckos -> own bodies and gaits, none touches another, recorded as they were") {
  const TemporaryFolder folder;
  Experiment<Hunt> experiment = spiders_hunt_geckos();
  experiment.ecology.duration_s = 300.0;
  Ecology<Hunt> ecology{experiment, ToyBodies::Params{}};
  const auto* toys = ecology.backend().as<ToyBodies>();
  REQUIRE(toys != nullptr);
  io::RunFolder files{folder.path() / "run", {}, {.senses = true}};
  ecology.run_until(300.0, files);
  const View view = ecology.view();
  for (BodyIndex body = 0; body < view.robots.size(); ++body) {
    const bool is_prey = view.robots[body].species == prey;
    CHECK(view.phenotypes[body].robot->name == (is_prey ? "gecko" : "spider"));
    CHECK(toys->model(body).name == view.phenotypes[body].robot->name);
    CHECK(view.phenotypes[body].gait->robot == view.phenotypes[body].robot->name);
  }
  const std::string bodies = content(folder.path() / "run" / "bodies.csv");
  CHECK(bodies.starts_with(
      "id,time_s,species,plan,parent_plan,edit_distance,modules_text,modules,hinges,bricks,mass_kg,reach_m,size,"));
  CHECK(bodies.find("\n0,0,prey,0,,,core[") != std::string::npos);
  const bool has_offspring = bodies.find(",prey,0,0,0,core[") != std::string::npos ||  // with their parents' plan
                             bodies.find(",predator,1,1,0,core[") != std::string::npos;
  CHECK(has_offspring);
  const std::string phylogeny = content(folder.path() / "run" / "phylogeny.csv");
  CHECK(phylogeny.starts_with("id,ancestor_list,"));
  CHECK(phylogeny.find(",cause_of_death,killer_id,modules_text\n") != std::string::npos);
  CHECK(std::ranges::count(phylogeny, '\n') == std::ranges::count(bodies, '\n'));
  CHECK(phylogeny.find(",caught,") != std::string::npos);
  for (std::size_t end = phylogeny.find('\n') + 1; end < phylogeny.size();) {
    end = phylogeny.find('\n', end) + 1;
    CHECK(phylogeny.compare(end - 3, 3, "]]\n") == 0);
  }
  const io::RecordingReader recording{folder.path() / "run" / "replay.trp"};
  CHECK(recording.head().bodies_differ);
  CHECK(recording.bodies().size() == 2);
  const std::size_t last = recording.frames() - 1;
  std::size_t set_down = 0;
  for (BodyIndex body = 0; body < view.robots.size(); ++body) {
    CHECK(recording.robot(last, body).links.size() == toys->model(body).links.size());
    for (std::size_t frame = 0; frame <= last; ++frame) set_down += recording.is_set_down(frame, body) ? 1U : 0U;
  }
  CHECK(set_down > 5);
}

TEST_CASE("bodies that evolve: 1000 births in a crowd -> no newborn touches another robot or a wall") {
  Experiment<Crowded> experiment{.seed = 4};
  experiment.ecology.robots = 30;
  experiment.rules.placement.half_extent_m = 1.5;
  experiment.rules.senescence.max_age_s = 6.0;
  Ecology<Crowded> ecology{experiment, ToyBodies::Params{}};
  SetDown set_down{.ecology = &ecology};
  ecology.run_until(240.0, set_down);
  CHECK(set_down.births > 1000);
  CHECK(set_down.overlaps == 0);
}

TEST_CASE("bodies of species: founders -> upright, apart from each other, at places inside the arena") {
  const Ecology<Hunt> ecology{spiders_hunt_geckos(), ToyBodies::Params{}};
  const View view = ecology.view();
  std::vector<std::vector<PlacedBox>> boxes;
  for (BodyIndex body = 0; body < view.robots.size(); ++body) {
    boxes.push_back(placed_boxes(*view.phenotypes[body].robot, ecology.backend().pose(body), {}));
    CHECK_FALSE(touch_wall(boxes[body], view.arena.half_side_m));
    for (BodyIndex other = 0; other < body; ++other) CHECK_FALSE(touch(boxes[body], boxes[other]));
  }
}

TEST_CASE("bodies of species: a body that diverges -> ends its individual, or the run where the table says so") {
  Experiment<RandomGaits> experiment{.seed = 2};
  experiment.rules.gait.first = control::gait::FirstGait::random;
  Ecology<RandomGaits> ecology{experiment, ToyBodies::Params{.breaks_beyond_rad = 1.5}};
  Ended ended;
  ecology.run_until(100.0, ended);
  CHECK(ended.deaths > 3);
  CHECK(ecology.time_s() == 100.0);
  experiment.rules.embodiment.diverged = initialization::Divergence::ends_run;
  Ecology<RandomGaits> strict{experiment, ToyBodies::Params{.breaks_beyond_rad = 1.5}};
  CHECK_THROWS_AS(strict.run_until(100.0), Diverged);
}

TEST_CASE("bodies of species: a body that diverges although it was replaced -> bodies next to it end") {
  Experiment<RandomGaits> experiment{.seed = 2};
  Ecology<RandomGaits> ecology{experiment, ToyBodies::Params{.second_breaks_s = 3.0}};
  Ended ended;
  ecology.run_until(8.0, ended);
  CHECK(ended.deaths > 5);
  CHECK(ended.deaths <= 5 * experiment.ecology.robots);
  CHECK(ecology.time_s() == 8.0);
}

TEST_CASE("trials of newborns: gaits that diverge -> not born and all of them, or robots that do not differ -> one sentence") {
  Experiment<TriedGaits> experiment{.seed = 2};
  experiment.rules.gait.first = control::gait::FirstGait::random;
  experiment.rules.viability.trial_s = 22.0;
  Ecology<TriedGaits> ecology{experiment, ToyBodies::Params{.breaks_beyond_rad = 1.5}};
  Ended ended;
  ecology.run_until(20.0, ended);
  CHECK(ended.deaths == 0);
  CHECK(message_of<RuleError>([&] {
          const Ecology<TriedGaits> none{experiment, ToyBodies::Params{.breaks_beyond_rad = 1e-6}};
        }) ==
        "the policy in rules.body_plan returned 1000 random newborns in a row were refused, the last one because \"diverges "
        "within 22 s: must walk until the end of the trial\": some bodies must be viable");
  using OneGait = with_viability<rules::Paper, TriedGaits::Viability>;
  CHECK(message_of<std::invalid_argument>([] {
          const Ecology<OneGait> none{{}, ToyBodies::Params{}};
        }) ==
        "rules.viability = survives_trial_module_limits with rules.gait = robots_gait: must be in a table with a rule Gait or "
        "BodyPlan");
}

TEST_CASE("bodies of species: backends and rules that cannot show them -> one sentence each") {
  CHECK(message_of<std::invalid_argument>([] {
          const Ecology<Hunt> ecology{spiders_hunt_geckos(), backend::Kinematic::Params{}};
        }).starts_with("rules.body_plan = named_body_by_species on backend kinematic: must be a backend with joints"));
  using Keeps = with_body_plan<rules::Paper, reproduction::body_plan::NamedBody>;
  CHECK(message_of<std::invalid_argument>([] {
          const Ecology<Keeps> ecology{{}, ToyBodies::Params{}};
        }) == "rules.body_plan = named_body with rules.embodiment = keeps_body: must be a rule Embodiment that puts bodies down");
}
