// SPDX-License-Identifier: MIT
// The ecology: who lives in which body, in what order the rules act, and when.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/refused.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/locomotion/locomotion.hpp>
#include <trophic/locomotion/steerable.hpp>
#include <trophic/observe/hooks.hpp>
#include <trophic/params/settings.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/population/population.hpp>
#include <trophic/population/view.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace trophic {

/// A population of robots that live, perceive, catch, starve and reproduce by the rules of one table in one physics backend.
///
/// A tick is `World::tick_s` of the ecology's clock. Within a tick, after the bodies have moved: activation of newborn, catches,
/// senescence, starvation, rescue, perception and brains, log. Tick 0 is the start. Same numbers and seed: same run, whatever the
/// number of threads and whoever observes. A policy that returns what does not exist or contradicts its contract is a RuleError.
template <class Rules, Backend B, bool is_table>
class Ecology {
 public:
  using Params = Experiment<Rules, B>;

  /// Loads the models that `params.world` names, by trophic/load/habitat.hpp. Throws std::invalid_argument naming field, value
  /// and bound, or a robot that the rules cannot steer; std::runtime_error for a missing or broken file.
  explicit Ecology(Params params = {}) : Ecology{load(std::move(params))} {}

  /// In a habitat made by the program; the names in `params.world` are then only labels.
  Ecology(Params params, Habitat habitat) : Ecology{check(std::move(params), std::move(habitat))} {}

  Ecology(const Ecology&) = delete;
  Ecology& operator=(const Ecology&) = delete;

  /// Runs until the clock reaches `until_s` (rounded up to whole ticks) or an observer says stop. May be called again to go on.
  /// If anything throws, the observers are told and the exception goes on.
  template <class... Observers>
  void run_until(double until_s, Observers&&... observers) {
    observe::Audience<std::remove_reference_t<Observers>...> audience{observers...};
    try {
      audience.start(describe(until_s), view());
      if (!started_) {
        started_ = true;
        for (BodyIndex body = 0; body < poses_.size(); ++body) emit(audience, observe::EventKind::birth, body);
        starvation_clock_.interval_ticks = rules_.starvation_schedule.interval_ticks(view());
        tick(audience);
      }
      while (time_s() < until_s && audience.keep_running()) {
        move();
        tick(audience);
      }
      audience.end(view());
    } catch (const std::exception& error) {
      audience.failure(error.what());
      throw;
    }
  }

  [[nodiscard]] double time_s() const { return static_cast<double>(tick_) * params_.world.tick_s; }
  [[nodiscard]] std::int64_t tick() const { return tick_; }
  [[nodiscard]] const Params& params() const { return params_; }
  [[nodiscard]] const Habitat& habitat() const { return habitat_; }
  [[nodiscard]] const B& backend() const { return backend_; }

  /// The world as rules see it now. Valid as long as the ecology lives and does not run.
  [[nodiscard]] View view() const {
    return {.time_s = time_s(),
            .tick = tick_,
            .tick_s = params_.world.tick_s,
            .web = web_,
            .arena = habitat_.arena,
            .robots = population_.individuals(),
            .poses = poses_,
            .perceives = perceives_,
            .grid = poses_.size() >= grid_from_robots ? &grid_ : nullptr};
  }

  /// What determines this run, for observers.
  [[nodiscard]] observe::Run describe(double until_s) const {
    observe::Run run{.rules = table_name<Rules>(),
                     .slots = {},
                     .settings = settings_of(params_),
                     .tags = population_.tags(),
                     .backend = std::string{B::name} + " " + B::version(),
                     .remarks = B::remarks(params_.physics),
                     .seed = params_.seed,
                     .tick_s = params_.world.tick_s,
                     .clock_scale = params_.world.clock_scale,
                     .until_s = until_s,
                     .fingerprint = {}};
    for_each_rule<Rules>([&](std::string_view slot, std::string_view policy) { run.slots.emplace_back(slot, policy); });
    run.fingerprint = observe::fingerprint(run, numbers_text(habitat_));
    return run;
  }

 private:
  struct Checked {
    Params params;
    Habitat habitat;
  };

  static Checked load(Params params) {
    validate(params, "");
    if constexpr (requires { load_habitat(params.world); }) {
      Habitat habitat = load_habitat(params.world);
      params.world.gait = habitat.gait.name;
      return check(std::move(params), std::move(habitat));
    } else {
      static_assert(std::same_as<Rules, void>,
                    "an Ecology made from numbers alone reads model files: #include <trophic/load/habitat.hpp>");
    }
  }
  static Checked check(Params params, Habitat habitat) {
    validate(params, "");
    check_fit(habitat.gait, habitat.robot);
    if constexpr (JointDriven<B>) {
      locomotion::check_steerable(habitat.robot, make_policy<typename Rules::Steering>(params.rules.steering, "steering"));
    }
    return {std::move(params), std::move(habitat)};
  }

  explicit Ecology(Checked from)
      : params_{std::move(from.params)},
        habitat_{std::move(from.habitat)},
        steps_per_tick_{control_steps_per_tick<B>(params_.world, params_.physics)},
        rules_{make_policies<Rules>(params_.rules)},
        web_{rules_.community.web()},
        perceives_{[this](const Individual& self, const Individual& other) { return rules_.visibility.perceives(self, other); }},
        population_{rules_, web_, params_.seed, rules_.community.founders(params_.world.robots)},
        poses_{place()},
        backend_{habitat_.robot, habitat_.arena, root_poses(), params_.physics, params_.backend},
        locomotion_{habitat_.robot,           habitat_.gait,
                    rules_.steering,          params_.world.robots,
                    params_.world.control_hz, params_.world.cpg_integration} {}

  [[nodiscard]] std::vector<GroundPose> place() const {
    Rng rng{params_.seed, Stream::placement};
    return rules_.placement.place(params_.world.robots, habitat_.arena, habitat_.robot.bounding_radius_m, rng);
  }

  /// Root frames for the placed robots: upright, feet on the floor.
  [[nodiscard]] std::vector<Pose> root_poses() const {
    std::vector<Pose> poses;
    for (const GroundPose& ground : poses_) {
      const double yaw_rad = ground.heading_rad - habitat_.robot.forward_rad;
      poses.push_back({.position_m = {ground.x_m, ground.y_m, habitat_.robot.rest_height_m},
                       .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}});
    }
    return poses;
  }

  template <class Audience>
  void emit(Audience& audience, observe::EventKind kind, BodyIndex body, std::optional<Cause> cause = {},
            std::optional<IndividualId> other = {}) {
    audience.event(observe::Event{.kind = kind, .body = body, .individual = population_[body], .cause = cause, .other = other},
                   view());
  }

  void move() {
    target_angles_rad_.clear();
    for (const Individual& individual : population_.individuals()) target_angles_rad_.push_back(individual.target_angle_rad);
    locomotion_.advance(backend_, steps_per_tick_, target_angles_rad_);
    for (BodyIndex body = 0; body < poses_.size(); ++body) {
      const Pose root = backend_.pose(body);
      poses_[body] = {.x_m = root.position_m.x(),
                      .y_m = root.position_m.y(),
                      .heading_rad = rules_.heading.heading_rad(root, habitat_.robot.forward_rad)};
    }
    grid_ = SpatialGrid{poses_};
    ++tick_;
  }

  template <class Audience>
  void tick(Audience& audience) {
    if (time_s() >= params_.world.first_tick_s) {
      activate(audience);
      capture(audience);
      age(audience);
      starve(audience);
      rescue(audience);
      decide(audience);
    }
    audience.tick(view());
  }

  template <class Audience>
  void activate(Audience& audience) {
    for (BodyIndex body = 0; body < poses_.size(); ++body) {
      if (population_[body].active || !rules_.activation.activates(body, view())) continue;
      population_[body].active = true;
      if (rules_.activation.restarts_age()) population_[body].age_from_s = time_s();
      emit(audience, observe::EventKind::activation, body);
    }
  }

  template <class Audience>
  void capture(Audience& audience) {
    Rng rng{params_.seed, Stream::captures, 0, static_cast<std::uint64_t>(tick_)};
    const IndividualId first_newborn = population_.next_id();
    for (const death::Capture& capture : rules_.capture.captures(view(), rng)) {
      check_index("capture", "hunter", capture.hunter, poses_.size());
      check_index("capture", "victim", capture.victim, poses_.size());
      Individual& hunter = population_[capture.hunter];
      const bool hunter_was_caught = hunter.id >= first_newborn;
      const bool victim_was_caught = population_[capture.victim].id >= first_newborn;
      if (hunter_was_caught || victim_was_caught) continue;
      check_prey(capture.hunter, capture.victim);
      if (!rules_.floor.may_die(population_[capture.victim].species, view())) continue;
      hunter.fed_tick = tick_;
      hunter.memory.last_seen_body.reset();
      hunter.memory.last_seen_victim.reset();
      population_[capture.victim].memory.last_killer = hunter.as_ancestor();
      emit(audience, observe::EventKind::capture, capture.hunter, {}, population_[capture.victim].id);
      hand_on(audience, {.body = capture.victim, .cause = Cause::caught, .killer = capture.hunter, .heir = hunter.species},
              rules_.capture_parent);
    }
  }

  void check_prey(BodyIndex hunter, BodyIndex victim) {
    const Species eater = population_[hunter].species;
    const Species eaten = population_[victim].species;
    if (web_.eats(eater, eaten)) return;
    throw RuleError{"capture", "hunter " + std::to_string(hunter) + " and victim " + std::to_string(victim) + ": species " +
                                   web_.name(eater) + " does not eat " + web_.name(eaten)};
  }

  template <class Audience>
  void age(Audience& audience) {
    for (BodyIndex body = 0; body < poses_.size(); ++body) {
      const Individual& individual = population_[body];
      Rng rng{params_.seed, Stream::senescence, individual.id, static_cast<std::uint64_t>(tick_)};
      if (!rules_.senescence.dies(individual, view(), rng)) continue;
      hand_on(audience, {.body = body, .cause = Cause::senescence, .killer = {}, .heir = individual.species},
              rules_.senescence_parent);
    }
  }

  template <class Audience>
  void starve(Audience& audience) {
    if (!rules_.starvation_schedule.due(starvation_clock_, view())) return;
    const auto spared = [this](BodyIndex hunter) { return rules_.reprieve.spared(hunter, view()); };
    if (const auto victim = rules_.starvation.victim(view(), spared)) {
      check_index("starvation", "victim", *victim, poses_.size());
      hand_on(audience, {.body = *victim, .cause = Cause::starved, .killer = {}, .heir = {}}, rules_.starvation_parent);
    }
    starvation_clock_ = {.last_tick = tick_, .interval_ticks = rules_.starvation_schedule.interval_ticks(view())};
  }

  template <class Audience>
  void rescue(Audience& audience) {
    Rng rng{params_.seed, Stream::sacrifice, 0, static_cast<std::uint64_t>(tick_)};
    for (const death::Sacrifice& sacrifice : rules_.rescue.sacrifices(view(), rng)) {
      check_index("rescue", "victim", sacrifice.victim, poses_.size());
      check_index("rescue", "heir", sacrifice.heir, web_.size());
      if (!rules_.floor.may_die(population_[sacrifice.victim].species, view())) continue;
      hand_on(audience, {.body = sacrifice.victim, .cause = Cause::sacrificed, .killer = {}, .heir = sacrifice.heir},
              rules_.rescue_parent);
    }
  }

  /// A body goes to the species that the rules fix; a parent of another one is refused.
  void check_parent(const reproduction::Vacancy& vacancy, const Ancestor& parent) const {
    check_index(parent_slot(vacancy.cause), "a parent of species", parent.species, web_.size());
    if (!vacancy.heir || parent.species == *vacancy.heir) return;
    throw RuleError{parent_slot(vacancy.cause), "individual " + std::to_string(parent.id) + ", a " + web_.name(parent.species) +
                                                    ", as the parent of a " + web_.name(*vacancy.heir) +
                                                    ": must be of its offspring's species"};
  }

  [[nodiscard]] static std::string_view parent_slot(Cause cause) {
    switch (cause) {
      case Cause::caught:
        return "capture_parent";
      case Cause::starved:
        return "starvation_parent";
      case Cause::sacrificed:
        return "rescue_parent";
      case Cause::senescence:
        break;
    }
    return "senescence_parent";
  }

  /// Death of the occupant and birth of its successor. Where the rules do not fix the heir's species, it is the parent's or, for
  /// want of a parent, the first that the dead one ate.
  template <class Audience, class ParentRule>
  void hand_on(Audience& audience, const reproduction::Vacancy& vacancy, const ParentRule& parent_rule) {
    const auto succession = population_.succession(vacancy, parent_rule, view());
    const Species dead = population_[vacancy.body].species;
    if (succession.parent) check_parent(vacancy, *succession.parent);
    auto heir = vacancy.heir;
    if (!heir) heir = succession.parent ? succession.parent->species : web_.first_victim(dead).value_or(dead);
    const auto killer = vacancy.killer ? std::optional{population_[*vacancy.killer].id} : std::nullopt;
    emit(audience, observe::EventKind::death, vacancy.body, vacancy.cause, killer);
    population_.succeed(vacancy.body, *heir, succession, view());
    emit(audience, observe::EventKind::birth, vacancy.body);
  }

  /// Perception, brains, and what they change. Unless the rules say that robots decide in turn, everybody perceives the same
  /// moment: all decisions are made before the first tag changes.
  template <class Audience>
  void decide(Audience& audience) {
    const double tag_ratio = rules_.tag_ratio_input.input(view());
    choices_.clear();
    for (BodyIndex body = 0; body < poses_.size(); ++body) {
      choices_.push_back(choice(body, tag_ratio));
      if (rules_.decision_order.in_turn()) act(audience, body, choices_[body]);
    }
    if (rules_.decision_order.in_turn()) return;
    for (BodyIndex body = 0; body < poses_.size(); ++body) act(audience, body, choices_[body]);
  }

  /// What a robot perceives and what its brain makes of it; no decision where the blind rule keeps the last one.
  struct Choice {
    std::optional<perception::Sighting> sighting;
    std::optional<control::Decision> decision;
  };

  [[nodiscard]] Choice choice(BodyIndex body, double tag_ratio) const {
    const auto sighting = perception::adversary(body, view());
    const auto inputs = sighting
                            ? std::optional{perception::BrainInputs{.angle = rules_.angle_input.input(*sighting, view()),
                                                                    .distance = rules_.distance_input.input(*sighting, view()),
                                                                    .tag_ratio = tag_ratio}}
                            : rules_.blind_rule.inputs(tag_ratio);
    if (!inputs) return {sighting, std::nullopt};
    const control::Decision decision = rules_.brain.decide(*inputs, population_[body].genome->weights);
    check_tag(population_.tags(), decision.tag, "brain");
    return {sighting, decision};
  }

  template <class Audience>
  void act(Audience& audience, BodyIndex body, const Choice& choice) {
    remember(body, choice.sighting);
    if (!choice.decision) return;
    Individual& self = population_[body];
    self.target_angle_rad = choice.decision->target_angle_rad;
    if (!rules_.tag_switch.may_switch(self, view())) return;
    const bool switched = choice.decision->tag != self.tag;
    self.tag = choice.decision->tag;
    if (rules_.tag_switch.restarts(switched)) self.tag_since_s = time_s();
    if (switched) emit(audience, observe::EventKind::tag_switch, body);
  }

  void remember(BodyIndex body, const std::optional<perception::Sighting>& sighting) {
    Individual& self = population_[body];
    self.adversary.reset();
    self.adversary_distance_m = std::numeric_limits<double>::quiet_NaN();
    if (!sighting) return;
    self.adversary = sighting->adversary;
    self.adversary_distance_m = sighting->distance_m;
    self.memory.adversary_distance_m = sighting->distance_m;
    const Individual& adversary = population_[sighting->adversary];
    if (!web_.eats(self.species, adversary.species) || self.memory.last_seen_body == sighting->adversary) return;
    self.memory.last_seen_body = sighting->adversary;
    self.memory.last_seen_victim = adversary.as_ancestor();
  }

  /// From so many on, a grid finds the closest robot sooner than a look at everybody; both give the same.
  static constexpr std::size_t grid_from_robots = 64;

  Params params_;
  Habitat habitat_;
  std::int64_t steps_per_tick_;
  Policies<Rules> rules_;
  FoodWeb web_;
  Perceives perceives_;
  Population<Rules> population_;
  std::vector<GroundPose> poses_;
  SpatialGrid grid_{poses_};
  B backend_;
  locomotion::Locomotion<typename Rules::Steering> locomotion_;
  death::StarvationClock starvation_clock_;
  std::int64_t tick_ = 0;
  bool started_ = false;
  std::vector<double> target_angles_rad_;
  std::vector<Choice> choices_;
};

}  // namespace trophic
