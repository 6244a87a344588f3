// SPDX-License-Identifier: MIT
// The ecology: the individual in each body, and the order and times of the rules.
#pragma once

#include <exception>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/bodies.hpp>
#include <trophic/ecology/checked_experiment.hpp>
#include <trophic/ecology/checks.hpp>
#include <trophic/ecology/decisions.hpp>
#include <trophic/ecology/describe.hpp>
#include <trophic/ecology/engine_nursery.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/phenotypes.hpp>
#include <trophic/ecology/population.hpp>
#include <trophic/ecology/refused.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/ecology/start.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/installed_models.hpp>
#include <trophic/io/state_columns.hpp>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/rules/rule_states.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// A population of robots that live, perceive, catch, starve and reproduce by the rules of one table, in a physics backend
/// of any type: `Ecology<Paper> ecology({.seed = 1}, backend::Mujoco::Params{.threads = 2})`.
///
/// A tick is `EcologyParams::tick_s` of the ecology's clock. Within a tick, after the bodies have moved: activation of newborn,
/// catches, senescence, hunger by the rule Metabolism, starvation, the minimum-predators rule, births without a death, perception
/// and brains, log. Energy is spent and taken from the resource before them all. Tick 0 is the start. Equal parameters and seeds
/// give equal runs, for any number of threads and any observers. A policy that returns a value that does not exist or violates
/// its contract causes a RuleError.
template <class Rules, bool is_table>
class Ecology final : public Simulation {
 public:
  using Params = Experiment<Rules>;

  /// Loads the models that `params.ecology` names, using trophic/habitat/load/habitat.hpp. Throws std::invalid_argument naming
  /// field, value and bound, or a robot that the rules cannot steer; std::runtime_error for a missing or invalid file.
  explicit Ecology(Params params, BackendChoice backend, std::string_view installed = TROPHIC_MODEL_DIR)
      : Ecology{load_checked(std::move(params), std::move(backend), installed)} {}

  /// Uses a habitat made by the program; the names in `params.ecology` are then only labels.
  Ecology(Params params, BackendChoice backend, Habitat habitat)
      : Ecology{checked(std::move(params), std::move(backend), std::move(habitat))} {}

  void persist(Archive& archive) override {
    archive(tick_, started_, starvation_clock_, population_, bodies_);
    archive(history_);
    if (grows) archive(refused_births_);
  }

  [[nodiscard]] double time_s() const override { return clock_s(tick_, params_.ecology.tick_s); }
  [[nodiscard]] std::int64_t tick() const override { return tick_; }
  [[nodiscard]] const Params& params() const { return params_; }
  [[nodiscard]] const Habitat& habitat() const { return habitat_; }
  [[nodiscard]] const AnyBackend& backend() const override { return bodies_.backend(); }
  [[nodiscard]] const RuleStates<Rules>& states() const { return population_.states(); }  ///< the states of rules with a State

  [[nodiscard]] View view() const override {
    return {.time_s = time_s(),
            .tick = tick_,
            .tick_s = params_.ecology.tick_s,
            .robot_radius_m = habitat_.robot.bounding_radius_m,
            .web = web_,
            .arena = habitat_.arena,
            .robots = population_.individuals(),
            .poses = bodies_.poses(),
            .tree = population_.individuals().size() >= tree_from_robots ? population_.tree() : nullptr,
            .members = population_.members(),
            .refused_bodies = population_.refused_bodies(),
            .phenotypes = population_.phenotypes(),
            .field = population_.economy().field(),
            .energy = population_.economy().flows(),
            .resource = population_.economy().resource_flow(),
            .refused_births = refused_births_,
            .bodies = bodies_.backend().has_joints() ? &bodies_ : nullptr,
            .acts = population_.acts().values(),
            .traits = TraitGenes<Rules>::names,
            .is_over = ends_now(params_.ecology.ends_when, population_.members()),
            .period_m = bodies_.period_m()};
  }

  [[nodiscard]] observe::RunDescription describe(double until_s) const override {
    auto run = trophic::describe(params_, choice_, habitat_, until_s);
    run.spare_bodies = reproduction::ask::spare_bodies(rules_.recruitment);
    if (std::string slow = bodies_.backend().speed_remark(); !slow.empty()) run.remarks.push_back(std::move(slow));
    return run;
  }

  [[nodiscard]] io::StateColumns state_columns() const override { return io::state_columns(states(), view().robots); }

 private:
  /// Whether the number of individuals may change.
  static constexpr bool grows = !is_neutral<Rules, RuleSlot::recruitment>;

  explicit Ecology(CheckedExperiment<Rules> from)
      : params_{std::move(from.params)},
        choice_{std::move(from.backend)},
        habitat_{std::move(from.habitat)},
        rules_{make_policies<Rules>(params_.rules)},
        web_{rules_.community.web()},
        nursery_{choice_, habitat_.arena, params_.physics, params_.ecology, rules_.steering},
        population_{rules_, web_, genome_seed(params_), founders_of(params_, rules_, web_), {params_.null, &habitat_, &nursery_}},
        bodies_{params_, choice_, habitat_, rules_, population_},
        decisions_{params_.ecology, rules_, params_.seed, population_},
        history_{params_.history} {
    if (!params_.lineup.empty()) population_.enlist(params_.lineup);
    bodies_.embody_founders();
  }

  void run(double until_s, observe::Audience& audience) override {
    if (params_.null == Null::neutral && !params_.history)
      throw std::invalid_argument{"a neutral null: needs the history of a run"};
    try {
      audience.start(describe(until_s), view());
      if (!started_) {
        started_ = true;
        bodies_.show_start(audience, time_s());
        for (BodyIndex body = 0; body < population_.individuals().size(); ++body)
          if (population_[body].lives()) emit(audience, observe::EventKind::birth, body);
        for (const Individual& one : population_.individuals())
          if (history_ && one.lives()) history_.found(one);
        starvation_clock_ = death::ask::start(rules_.starvation, view());
        tick(audience);
      }
      while (time_s() < until_s && !view().is_over && audience.keep_running() && move(audience)) {
        tick(audience);
        audience.between_ticks(*this, false);
      }
      audience.between_ticks(*this, true);
      audience.end(view());
    } catch (const std::exception& error) {
      audience.failure(error.what());
      throw;
    }
  }

  void emit(observe::Audience& audience, observe::EventKind kind, BodyIndex body, std::optional<Cause> cause = {},
            std::optional<IndividualId> other = {}) {
    audience.event(observe::Event{.kind = kind, .body = body, .individual = population_[body], .cause = cause, .other = other},
                   view());
  }

  /// Moves the bodies through a tick. Returns false, with everything as before, if an observer cancelled it.
  [[nodiscard]] bool move(observe::Audience& audience) {
    population_.open_ledger();
    for (BodyIndex body = 0; history_ && body < population_.individuals().size(); ++body)
      if (population_[body].lives() && !bodies_.backend().is_there(body)) bodies_.embody(body, population_.individuals().size());
    if (!bodies_.move(audience, view(), [&](BodyIndex body) { end_diverged(audience, body); })) return false;
    ++tick_;
    population_.walk(bodies_.poses_before(), view());
    return true;
  }

  /// The individual dies and a random one of its species follows. One with a history lives on, away until the next tick.
  void end_diverged(observe::Audience& audience, BodyIndex body) {
    const Individual& self = population_[body];
    if (!self.lives() || params_.history) return bodies_.take_away(body);
    emit_death(audience, {.body = body, .cause = Cause::diverged, .killer = {}, .successor = self.species});
    population_.replace(body, self.species, {}, view());
    begin_life(audience, body);
  }

  void tick(observe::Audience& audience) {
    const bool rules_act = time_s() >= params_.ecology.first_tick_s;
    if (history_) {
      repeat(audience);
    } else if (rules_act && params_.lineup.empty()) {
      activate(audience);
      capture(audience);
      age(audience);
      exhaust(audience);
      starve(audience);
      minimum_predators(audience);
      recruit(audience);
    }
    if (rules_act) decisions_.make(audience, view());
    audience.tick(view());
  }

  /// A neutral null has other genomes than the run that it repeats.
  [[nodiscard]] static std::uint64_t genome_seed(const Params& params) {
    return params.history ? Rng{params.seed, Stream::null_model}.bits() : params.seed;
  }

  /// Repeats what happened in the history up to this tick.
  void repeat(observe::Audience& audience) {
    while (const Happening* const next = history_.next(tick_)) {
      const Happening& event = *next;
      const auto other = event.killer_or_victim ? population_.body_of(*event.killer_or_victim) : std::nullopt;
      if (event.kind == observe::EventKind::birth) {
        using reproduction::Descent;
        const Descent orphan = event.origin == Origin::inherited ? Descent::of_parent_in_name : Descent::random;
        const Parentage parentage{.descent = event.parents.empty() ? orphan : Descent::of_parent,
                                  .parents = history_.parents_of(event)};
        std::optional<GroundPose> place;
        if (!bodies_.backend().is_there(event.body))
          place = place_of_birth(parentage.parents).value_or(bodies_.poses()[event.body]);
        population_.replace(event.body, event.species, parentage, view());
        history_.note_birth(population_[event.body]);
        begin_life(audience, event.body, place);
      } else if (event.kind == observe::EventKind::death) {
        emit_death(audience, {.body = event.body, .cause = *event.cause, .killer = other, .successor = {}});
        population_.vacate(event.body);
        if (grows && !history_.goes_on_in(event.body)) bodies_.take_away(event.body);
      } else if (event.kind == observe::EventKind::activation) {
        const auto rule = death::ask::activates(rules_.activation, states().activation[event.body], event.body, view());
        population_.activate(event.body, time_s(), rule == death::Activates::yes_and_restarts_age);
        emit(audience, observe::EventKind::activation, event.body);
      } else if (event.kind == observe::EventKind::capture && other) {
        population_.feed(event.body, *other, view());
        emit(audience, observe::EventKind::capture, event.body, {}, event.killer_or_victim);
      }
    }
  }

  void activate(observe::Audience& audience) {
    for (BodyIndex body = 0; body < population_.individuals().size(); ++body) {
      if (population_[body].active || !population_[body].lives()) continue;
      const auto activates = death::ask::activates(rules_.activation, states().activation[body], body, view());
      if (activates == death::Activates::no) continue;
      population_.activate(body, time_s(), activates == death::Activates::yes_and_restarts_age);
      emit(audience, observe::EventKind::activation, body);
    }
  }

  void capture(observe::Audience& audience) {
    Rng rng{params_.seed, Stream::captures, 0, static_cast<std::uint64_t>(tick_)};
    const IndividualId first_newborn = population_.next_id();
    const auto captors = states().capture.all();
    const auto captures = death::ask::captures(rules_.capture, captors, view(), rng);
    detail::check_captures(captures, population_.individuals());
    for (const death::Capture& capture : captures) {
      const Individual& hunter = population_[capture.hunter];
      if (std::max(hunter.id, population_[capture.victim].id) >= first_newborn) continue;  // one was caught
      detail::check_prey(web_, capture.hunter, hunter.species, capture.victim, population_[capture.victim].species);
      if (!death::ask::may_die(rules_.floor, population_[capture.victim].species, view())) continue;
      population_.feed(capture.hunter, capture.victim, view());
      emit(audience, observe::EventKind::capture, capture.hunter, {}, population_[capture.victim].id);
      replace_occupant(audience,
                       {.body = capture.victim, .cause = Cause::caught, .killer = capture.hunter, .successor = hunter.species});
    }
  }

  void age(observe::Audience& audience) {
    for (BodyIndex body = 0; body < population_.individuals().size(); ++body) {
      const Individual& individual = population_[body];
      if (!individual.lives()) continue;
      Rng rng{params_.seed, Stream::senescence, individual.id, static_cast<std::uint64_t>(tick_)};
      if (!death::ask::dies(rules_.senescence, states().senescence[body], individual, view(), rng)) continue;
      replace_occupant(
          audience, {.body = body, .cause = death::ask::cause(rules_.senescence), .killer = {}, .successor = individual.species});
    }
  }

  /// Deaths of hunger by the rule Metabolism.
  void exhaust(observe::Audience& audience) {
    if (!Economy<Rules>::has_energy) return;
    const IndividualId first_newborn = population_.next_id();
    for (BodyIndex body = 0; body < population_.individuals().size(); ++body) {
      const Individual& self = population_[body];
      if (!self.lives() || self.id >= first_newborn || !population_.economy().starves(self, body, view())) continue;
      replace_occupant(audience, {.body = body, .cause = Cause::starved, .killer = {}, .successor = {}});
    }
  }

  void starve(observe::Audience& audience) {
    const View now = view();
    const Moment<Rules> moment{rules_, population_, params_.seed, now};
    const perception::Perceives perceives = [&](BodyIndex self, BodyIndex other) { return moment.sees(self, other); };
    const auto hungry = states().starvation.all();
    const death::Starving starving = death::ask::starving(rules_.starvation, hungry, starvation_clock_, now, perceives);
    const IndividualId first_newborn = population_.next_id();
    detail::check_starving(starving, population_.individuals());
    for (const BodyIndex hunter : starving.exempt) audience.exemption(hunter, now);
    for (const BodyIndex victim : starving.victims) {
      if (population_[victim].id >= first_newborn) continue;
      replace_occupant(audience, {.body = victim, .cause = Cause::starved, .killer = {}, .successor = {}});
    }
    if (starving.restarts_clock)
      starvation_clock_ = death::ask::start(rules_.starvation, view(), starvation_clock_, starving.due);
  }

  void minimum_predators(observe::Audience& audience) {
    Rng rng{params_.seed, Stream::sacrifice, 0, static_cast<std::uint64_t>(tick_)};
    const IndividualId first_newborn = population_.next_id();
    const auto given_up = states().minimum_predators.all();
    const auto sacrifices = death::ask::sacrifices(rules_.minimum_predators, given_up, view(), rng);
    detail::check_sacrifices(sacrifices, population_.individuals());
    for (const death::Sacrifice& sacrifice : sacrifices) {
      check_index("minimum_predators", "successor", sacrifice.successor, web_.size());
      if (population_[sacrifice.victim].id >= first_newborn) continue;
      if (!death::ask::may_die(rules_.floor, population_[sacrifice.victim].species, view())) continue;
      replace_occupant(audience,
                       {.body = sacrifice.victim, .cause = Cause::sacrificed, .killer = {}, .successor = sacrifice.successor});
    }
  }

  /// Births without a death.
  void recruit(observe::Audience& audience) {
    if (!grows) return;
    Rng rng{params_.seed, Stream::recruitment, 0, static_cast<std::uint64_t>(tick_)};
    const auto recruiting = states().recruitment.all();
    BodyIndex spare = 0;
    for (const auto& recruit : reproduction::ask::recruits(rules_.recruitment, recruiting, view(), rng)) {
      detail::check_recruit(web_, habitat_.arena, recruit,
                            [&](const Ancestor& parent) { return population_.misfit(recruit.species, parent.genome.get()); });
      while (spare < population_.individuals().size() && population_[spare].lives()) ++spare;
      const bool has_body = spare < population_.individuals().size() && population_.can_endow(recruit);
      const auto place = recruit.place || !has_body ? recruit.place : place_of_birth(recruit.parents);
      if (!has_body || !place) {
        ++refused_births_;
        continue;
      }
      using reproduction::Descent;
      const Parentage parentage{.descent = recruit.parents.empty() ? Descent::random : Descent::of_parent,
                                .parents = recruit.parents,
                                .endowment_J = recruit.endowment_J};
      population_.replace(spare, recruit.species, parentage, view());
      begin_life(audience, spare, place);
    }
    bodies_.stand();
  }

  /// A free place next to the first living one of these, or anywhere; none if there is no room.
  [[nodiscard]] std::optional<GroundPose> place_of_birth(std::span<const Ancestor> parents) const {
    std::optional<BodyIndex> beside;
    for (const Ancestor& parent : parents) {
      if (!beside) beside = population_.body_of(parent.id);
    }
    return bodies_.free_place(beside, population_.next_id());
  }

  /// Death of the occupant and birth of its successor, unless the Recruitment rule leaves the body spare.
  void replace_occupant(observe::Audience& audience, const Vacancy& vacancy) {
    if (for_species(rules_.recruitment, population_[vacancy.body].species).leaves_spare(vacancy, view())) {
      emit_death(audience, vacancy);
      population_.vacate(vacancy.body);
      return bodies_.take_away(vacancy.body);
    }
    reproduce_into(audience, vacancy);
  }

  void emit_death(observe::Audience& audience, const Vacancy& vacancy) {
    const auto killer = vacancy.killer ? std::optional{population_[*vacancy.killer].id} : std::nullopt;
    emit(audience, observe::EventKind::death, vacancy.body, vacancy.cause, killer);
    population_.note_death(vacancy, view());
  }

  /// `place`: where the body of an individual comes into the world; none if it is there.
  void begin_life(observe::Audience& audience, BodyIndex body, const std::optional<GroundPose>& place = {}) {
    if (place) {
      bodies_.set_down(body, *place);
    } else if (Phenotypes<Rules>::differ) {
      bodies_.embody(body, population_.individuals().size());
    } else if (params_.ecology.phase_at_birth == PhaseAtBirth::reset) {
      bodies_.restart(body);
    }
    emit(audience, observe::EventKind::birth, body);
  }

  /// Unless the rules fix the successor's species, it is the parent's or, without a parent, the first species that the dead
  /// individual ate.
  void reproduce_into(observe::Audience& audience, const Vacancy& vacancy) {
    const Parentage parentage = population_.parentage(vacancy, view());
    const Species dead = population_[vacancy.body].species;
    for (const Ancestor& parent : parentage.parents)
      detail::check_parent(web_, vacancy, parent, population_.misfit(parent.species, parent.genome.get()));
    auto successor = vacancy.successor;
    if (!successor)
      successor = parentage.parents.empty() ? web_.first_victim(dead).value_or(dead) : parentage.parents.front().species;
    emit_death(audience, vacancy);
    population_.replace(vacancy.body, *successor, parentage, view());
    begin_life(audience, vacancy.body);
  }

  Params params_;
  BackendChoice choice_;
  Habitat habitat_;
  Policies<Rules> rules_;
  FoodWeb web_;
  EngineNursery<PolicyIn<Rules, RuleSlot::steering>> nursery_;
  Population<Rules> population_;
  Bodies<Rules> bodies_;
  Decisions<Rules> decisions_;
  RepeatedHistory history_;
  death::ClockOf<PolicyIn<Rules, RuleSlot::starvation>> starvation_clock_;
  std::int64_t tick_ = 0;
  bool started_ = false;
  std::uint64_t refused_births_ = 0;  ///< without a free body or a free place
};

}  // namespace trophic
