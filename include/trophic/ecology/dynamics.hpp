// SPDX-License-Identifier: MIT
// The dynamics of an ecology: what happens in a tick, and in which order.
#pragma once

#include <exception>
#include <trophic/ecology/decisions.hpp>
#include <trophic/ecology/describe.hpp>
#include <trophic/ecology/recruiting.hpp>
#include <trophic/ecology/repetition.hpp>
#include <trophic/ecology/spaces.hpp>
#include <trophic/ecology/stepping.hpp>
#include <trophic/ecology/table_simulation.hpp>
#include <trophic/io/state_columns.hpp>
#include <trophic/perception/visibility/contract.hpp>

namespace trophic {

/// Steps an ecology by the rules of its table. Within a tick, after the bodies have moved: activation of newborns, catches,
/// senescence, hunger by the rule Metabolism, starvation, the minimum-predators rule, births without a death, perception and
/// brains, log. Before all of these, energy is spent and taken from the resource; the rule Order may let species act in turn.
/// Tick 0 is the start. A policy that returns an invalid value or violates its contract causes a RuleError.
template <class Rules>
class Dynamics final : public TableSimulation<Rules>, private Stepping {
 public:
  explicit Dynamics(CheckedExperiment<Rules> from) : all_{std::move(from)} {}

  void persist(Archive& archive) override {
    check_between_ticks();
    archive(all_.tick, started_, starvation_clock_, all_.population, all_.bodies);
    repetition_.persist(archive);
    if (grows<Rules>) archive(all_.refused_births);
  }

  [[nodiscard]] double time_s() const override { return all_.time_s(); }
  [[nodiscard]] std::int64_t tick() const override { return all_.tick; }
  [[nodiscard]] View view() const override { return all_.view(); }
  [[nodiscard]] const AnyBackend& backend() const override { return all_.bodies.backend(); }
  [[nodiscard]] const Experiment<Rules>& params() const override { return all_.params; }
  [[nodiscard]] const Habitat& habitat() const override { return all_.habitat; }
  [[nodiscard]] const RuleStates<Rules>& states() const override { return all_.population.states(); }

  [[nodiscard]] observe::RunDescription describe(double until_s) const override { return described(until_s, Decider::genome); }
  [[nodiscard]] io::StateColumns state_columns() const override { return io::state_columns(states()); }
  [[nodiscard]] Stepping& stepping() override { return *this; }

 private:
  [[nodiscard]] observe::RunDescription described(double until_s, Decider decider) const {
    auto run = trophic::describe(all_.params, all_.choice, all_.habitat, until_s, decider);
    run.spare_bodies = reproduction::ask::spare_bodies(all_.rules.recruitment);
    if (std::string slow = backend().speed_remark(); !slow.empty()) run.remarks.push_back(std::move(slow));
    return run;
  }

  void run(double until_s, observe::Audience& audience) override {
    if constexpr (control::IsOutside<typename Population<Rules>::Brain>) {
      throw std::invalid_argument{
          "rules.brain = outside: decisions come from outside the ecology: must be run by SteppedRun "
          "(trophic/ecology/stepped_run.hpp) or from Python"};
    }
    check_can_begin();
    try {
      audience.start(describe(until_s), view());
      while (reach_decisions(until_s, audience)) {
        if (rules_act()) decisions_.make(audience, view());
        end_tick(audience);
      }
      end(audience);
    } catch (const std::exception& error) {
      audience.failure(error.what());
      throw;
    }
  }

  [[nodiscard]] observe::RunDescription describe_outside(double until_s) const override {
    return described(until_s, Decider::outside);
  }

  [[nodiscard]] Spaces spaces() const override { return spaces_of<Rules>(all_.web.size(), all_.population.tags()); }

  void begin(double until_s, observe::Audience& audience) override {
    check_can_begin();
    audience.start(describe_outside(until_s), view());
  }

  [[nodiscard]] bool sense(double until_s, observe::Audience& audience) override {
    while (!is_in_tick_) {
      if (!reach_decisions(until_s, audience)) {
        stop(audience);
        return false;
      }
      is_in_tick_ = true;
      if (rules_act()) decisions_.begin(view());
      ask_next(audience);
    }
    return true;
  }

  [[nodiscard]] bool is_in_tick() const override { return is_in_tick_; }
  void stop(observe::Audience& audience) override { end(audience); }

  /// Lets the next robots of the tick perceive, until some wait for a decision or the tick ends.
  void ask_next(observe::Audience& audience) {
    for (; rules_act() && decisions_.sense(view()); decisions_.act(audience, view())) {
      has_asked_ = false;
      if (decisions_.asked().empty()) continue;
      return note_perceived();
    }
    is_in_tick_ = false;
    end_tick(audience);
  }

  [[nodiscard]] const Perceived& perceived() const override { return perceived_; }

  [[nodiscard]] std::span<const double> own_outputs() override {
    if (has_asked_) return own_outputs_;
    has_asked_ = true;
    decisions_.ask_brains();
    own_outputs_.clear();
    for (const BodyIndex body : perceived_.bodies) {
      const auto& outputs = decisions_.choice(body).outputs;
      own_outputs_.insert(own_outputs_.end(), outputs.begin(), outputs.end());
    }
    return own_outputs_;
  }

  void check(std::span<const double> outputs) const override { all_.population.check_outputs(perceived_.bodies, outputs); }

  void decide(std::span<const double> outputs, observe::Audience& audience) override {
    auto from = outputs.begin();
    for (const BodyIndex body : perceived_.bodies) {
      auto& own = decisions_.choice(body).outputs;
      std::copy_n(from, own.size(), own.begin());
      from += std::ssize(own);
    }
    decisions_.act(audience, view());
    ask_next(audience);
  }

  void note_perceived() {
    const auto asked = decisions_.asked();
    perceived_.bodies.assign(asked.begin(), asked.end());
    perceived_.inputs_each = Population<Rules>::Sensors::size;
    perceived_.outputs_each = Population<Rules>::Acts::outputs;
    perceived_.inputs.clear();
    for (const BodyIndex body : asked) {
      const auto& inputs = decisions_.choice(body).inputs;
      perceived_.inputs.insert(perceived_.inputs.end(), inputs.begin(), inputs.end());
    }
  }

  void check_between_ticks() const {
    if (is_in_tick_) throw std::logic_error{"the robots of tick " + std::to_string(all_.tick) + " wait for decide(outputs)"};
  }
  void check_can_begin() const {
    check_between_ticks();
    repetition_.check();
  }

  /// Runs to where the robots of the next tick perceive. Returns false if the run ends before it.
  [[nodiscard]] bool reach_decisions(double until_s, observe::Audience& audience) {
    if (!started_) {
      start(audience);
    } else if (!(time_s() < until_s && !view().is_over && audience.keep_running() && move(audience))) {
      return false;
    }
    let_live_and_die(audience);
    return true;
  }

  void start(observe::Audience& audience) {
    started_ = true;
    all_.bodies.show_start(audience, time_s());
    for (BodyIndex body = 0; body < population().individuals().size(); ++body)
      if (population()[body].lives()) turnover_.emit(audience, observe::EventKind::birth, body);
    repetition_.start();
    starvation_clock_ = death::ask::start(all_.rules.starvation, view());
  }

  void end_tick(observe::Audience& audience) {
    audience.tick(view());
    if (all_.tick > 0) audience.between_ticks(*this, false);
  }

  void end(observe::Audience& audience) {
    audience.between_ticks(*this, true);
    audience.end(view());
  }

  /// Moves the bodies through a tick. Returns false and leaves everything unchanged if an observer cancelled it.
  [[nodiscard]] bool move(observe::Audience& audience) {
    population().open_ledger();
    repetition_.bring_back();
    if (!all_.bodies.move(audience, view(), [&](BodyIndex body) { end_diverged(audience, body); })) return false;
    ++all_.tick;
    const View now = view();
    population().walk(all_.bodies.poses_before(), now);
    if (in_turn()) return true;
    population().spend(all_.bodies.poses_before(), now, AllAct{});
    population().grow(now);
    population().bite(now, AllAct{});
    return true;
  }

  /// The individual dies and is replaced by a random one of its species. In a repetition of a history it lives on, removed from
  /// the world until the next tick.
  void end_diverged(observe::Audience& audience, BodyIndex body) {
    const Individual& self = population()[body];
    if (!self.lives() || repetition_) return all_.bodies.take_away(body);
    turnover_.emit_death(audience, {.body = body, .cause = Cause::diverged, .killer = {}, .successor = self.species});
    population().replace(body, self.species, {}, view());
    turnover_.begin_life(audience, body);
  }

  [[nodiscard]] bool rules_act() const { return time_s() >= all_.params.ecology.first_tick_s; }

  /// What happens in a tick before robots perceive.
  void let_live_and_die(observe::Audience& audience) {
    const bool lives_end = rules_act() && !repetition_ && all_.params.lineup.empty();
    if (lives_end) activate(audience);
    if (in_turn()) {
      act_in_turn(audience, lives_end);
    } else if (lives_end) {
      kill(audience, AllAct{});
    }
    if (repetition_) repetition_.tick(audience);
    if (lives_end) {
      starve(audience);
      minimum_predators(audience);
      if (!in_turn()) recruit(audience, AllAct{});
    }
  }

  /// Whether species act in turn.
  [[nodiscard]] bool in_turn() const {
    if constexpr (is_neutral<Rules, RuleSlot::order>) return false;
    return all_.rules.order.in_turn();
  }

  /// Performs all acts of one species after another. `lives_end`: whether there are deaths and births.
  void act_in_turn(observe::Audience& audience, bool lives_end) {
    for (Species species = 0; species < all_.web.size(); ++species) {
      const SpeciesActs acting{species};
      if (all_.tick > 0) population().spend(all_.bodies.poses_before(), view(), acting);
      if (all_.tick > 0) population().bite(view(), acting);
      if (!lives_end) continue;
      kill(audience, acting);
      recruit(audience, acting);
    }
    if (all_.tick > 0) population().grow(view());
  }

  /// Catches, and deaths of age and hunger.
  void kill(observe::Audience& audience, const auto& acting) {
    capture(audience, acting);
    age(audience, acting);
    if constexpr (has_energy<Rules>) exhaust(audience, acting);
  }

  void recruit(observe::Audience& audience, const auto& acting) {
    if constexpr (grows<Rules>)
      if (have_decided()) trophic::recruit(all_, turnover_, audience, acting);
  }

  void activate(observe::Audience& audience) {
    for (BodyIndex body = 0; body < population().individuals().size(); ++body) {
      if (population()[body].active || !population()[body].lives()) continue;
      const auto activates =
          death::ask::activates(all_.rules.activation, population().states().activation[body], body, all_.view());
      if (activates == death::Activates::no) continue;
      population().activate(body, all_.time_s(), activates == death::Activates::yes_and_restarts_age);
      turnover_.emit(audience, observe::EventKind::activation, body);
    }
  }

  /// Catches by the acting individuals.
  void capture(observe::Audience& audience, const auto& acting) {
    Rng rng{all_.params.seed, Stream::captures, acting.turn, tick_number()};
    const IndividualId first_newborn = population().next_id();
    const auto captors = population().states().capture.all();
    const auto captures = death::ask::captures(all_.rules.capture, captors, all_.view(), rng);
    detail::check_captures(captures, population().individuals());
    for (const death::Capture& capture : captures) {
      const Individual& hunter = population()[capture.hunter];
      if (!acting(hunter)) continue;
      if (std::max(hunter.id, population()[capture.victim].id) >= first_newborn) continue;  // an individual was caught
      detail::check_prey(all_.web, capture.hunter, hunter.species, capture.victim, population()[capture.victim].species);
      if (!death::ask::may_die(all_.rules.floor, population()[capture.victim].species, all_.view())) continue;
      population().feed(capture.hunter, capture.victim, all_.view());
      turnover_.emit(audience, observe::EventKind::capture, capture.hunter, {}, population()[capture.victim].id);
      turnover_.replace_occupant(
          audience, {.body = capture.victim, .cause = Cause::caught, .killer = capture.hunter, .successor = hunter.species});
    }
  }

  void age(observe::Audience& audience, const auto& acting) {
    for (BodyIndex body = 0; body < population().individuals().size(); ++body) {
      const Individual& individual = population()[body];
      if (!acting(individual)) continue;
      Rng rng{all_.params.seed, Stream::senescence, individual.id, tick_number()};
      if (!death::ask::dies(all_.rules.senescence, population().states().senescence[body], individual, all_.view(), rng))
        continue;
      turnover_.replace_occupant(
          audience,
          {.body = body, .cause = death::ask::cause(all_.rules.senescence), .killer = {}, .successor = individual.species});
    }
  }

  /// Deaths of hunger under the rule Metabolism.
  void exhaust(observe::Audience& audience, const auto& acting) requires has_energy<Rules> {
    const IndividualId first_newborn = population().next_id();
    for (BodyIndex body = 0; body < population().individuals().size(); ++body) {
      const Individual& self = population()[body];
      if (!acting(self) || self.id >= first_newborn || !population().economy().starves(self, body, all_.view())) continue;
      turnover_.replace_occupant(audience, {.body = body, .cause = Cause::starved, .killer = {}, .successor = {}});
    }
  }

  void starve(observe::Audience& audience) {
    const View now = all_.view();
    const Moment<Rules> moment{all_.rules, population(), all_.params.seed, now};
    const perception::Perceives perceives = [&](BodyIndex self, BodyIndex other) { return moment.sees(self, other); };
    const auto hungry = population().states().starvation.all();
    const death::Starving starving = death::ask::starving(all_.rules.starvation, hungry, starvation_clock_, now, perceives);
    const IndividualId first_newborn = population().next_id();
    detail::check_starving(starving, population().individuals());
    for (const BodyIndex hunter : starving.exempt) audience.exemption(hunter, now);
    for (const BodyIndex victim : starving.victims) {
      if (population()[victim].id >= first_newborn) continue;
      turnover_.replace_occupant(audience, {.body = victim, .cause = Cause::starved, .killer = {}, .successor = {}});
    }
    if (starving.restarts_clock)
      starvation_clock_ = death::ask::start(all_.rules.starvation, all_.view(), starvation_clock_, starving.due);
  }

  void minimum_predators(observe::Audience& audience) {
    Rng rng{all_.params.seed, Stream::sacrifice, 0, tick_number()};
    const IndividualId first_newborn = population().next_id();
    const auto given_up = population().states().minimum_predators.all();
    const auto sacrifices = death::ask::sacrifices(all_.rules.minimum_predators, given_up, all_.view(), rng);
    detail::check_sacrifices(sacrifices, population().individuals());
    for (const death::Sacrifice& sacrifice : sacrifices) {
      check_index("minimum_predators", "successor", sacrifice.successor, all_.web.size());
      if (population()[sacrifice.victim].id >= first_newborn) continue;
      if (!death::ask::may_die(all_.rules.floor, population()[sacrifice.victim].species, all_.view())) continue;
      turnover_.replace_occupant(
          audience, {.body = sacrifice.victim, .cause = Cause::sacrificed, .killer = {}, .successor = sacrifice.successor});
    }
  }

  /// Whether brains could decide in an earlier tick: the first decisions come after births.
  [[nodiscard]] bool have_decided() const {
    const EcologyParams& ecology = all_.params.ecology;
    return all_.tick > 0 && clock_s(all_.tick - 1, ecology.tick_s) >= ecology.first_tick_s;
  }

  [[nodiscard]] Population<Rules>& population() { return all_.population; }
  [[nodiscard]] std::uint64_t tick_number() const { return static_cast<std::uint64_t>(all_.tick); }

  EcologyState<Rules> all_;
  Turnover<Rules> turnover_{all_};
  Repetition<Rules> repetition_{all_, turnover_};
  Decisions<Rules> decisions_{all_.params.ecology, all_.rules, all_.params.seed, all_.population};
  death::ClockOf<PolicyIn<Rules, RuleSlot::starvation>> starvation_clock_;
  bool started_ = false;
  // Of a run that is decided from outside.
  bool is_in_tick_ = false;  ///< whether robots wait for decisions
  bool has_asked_ = false;   ///< whether own_outputs_ are those of the brains of the robots that wait
  Perceived perceived_;
  std::vector<double> own_outputs_;
};

/// The dynamics of an experiment, whose models are loaded by trophic/habitat/load/habitat.hpp. Throws std::invalid_argument
/// naming field, value and bound, or a robot that the rules cannot steer; std::runtime_error for a missing or invalid file.
template <class Rules>
[[nodiscard]] std::unique_ptr<TableSimulation<Rules>> make_dynamics(Experiment<Rules> params, BackendChoice backend,
                                                                    std::string_view installed) {
  return std::make_unique<Dynamics<Rules>>(load_checked(std::move(params), std::move(backend), installed));
}

/// The same in a habitat made by the program.
template <class Rules>
[[nodiscard]] std::unique_ptr<TableSimulation<Rules>> make_dynamics_in(Habitat habitat, Experiment<Rules> params,
                                                                       BackendChoice backend) {
  return std::make_unique<Dynamics<Rules>>(checked(std::move(params), std::move(backend), std::move(habitat)));
}

}  // namespace trophic
