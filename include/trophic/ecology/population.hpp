// SPDX-License-Identifier: MIT
// Owns the individuals: founders, births, ids, genomes and tags.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/ecology/act_memory.hpp>
#include <trophic/ecology/census.hpp>
#include <trophic/ecology/checks.hpp>
#include <trophic/ecology/economy.hpp>
#include <trophic/ecology/genomes.hpp>
#include <trophic/ecology/state_hooks.hpp>
#include <trophic/rules/rule_states.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// One individual per body, starting with the founders, and the states of all rules; the only writer of both. Applies the birth
/// rules of a table; the ecology decides which body becomes vacant, and when. A table with a Recruitment rule also has bodies
/// without an individual.
template <class Rules>
class Population {
 public:
  using Sensors = PolicyIn<Rules, RuleSlot::sensors>;
  using Brain = AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>;
  using Acts = typename ActMemory<Rules>::Acts;
  static_assert(control::detail::SameInputs<Sensors::size, control::detail::inputs_taken<Brain, Sensors::size>>,
                "the brain in Rules::Brain needs a different number of inputs than the sensors in Rules::Sensors provide");

  /// Founders of these species, one per body, all with random genomes (Sec. "Initialization"). Hunted species start inactive.
  /// A body for which `founders` has no_species starts spare; the id of every founder is the number of its body.
  /// Throws RuleError for a brain that lists no tag or a tag twice, and for a species or a tag that does not exist, here and at
  /// later births.
  Population(const Policies<Rules>& rules, const FoodWeb& web, std::uint64_t seed, std::span<const Species> founders,
             const BirthSetting& setting = {})
      : rules_{rules},
        web_{web},
        seed_{seed},
        tags_{for_species(rules.brain, 0).tags()},
        genomes_{rules, web, seed, setting},
        economy_{rules, seed, web.size(), setting.habitat},
        census_{web.size()} {
    check_tags(tags_);
    for (const Species species : founders)
      if (species != no_species) check_index("community", "species", species, web.size());
    census_.reserve(founders.size());
    for (const Species species : founders) found(species);
    for (BodyIndex body = 0; body < census_.bodies(); ++body) acts_.rest(body);
  }

  [[nodiscard]] std::span<const Individual> individuals() const { return census_.all(); }
  [[nodiscard]] std::span<const std::size_t> members() const { return census_.members(); }  ///< number per species
  [[nodiscard]] IndividualId next_id() const { return next_id_; }                           ///< id of the next newborn
  [[nodiscard]] const Individual& operator[](BodyIndex body) const { return census_[body]; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }         ///< seed of all random numbers of births
  [[nodiscard]] std::span<const int> tags() const { return tags_; }  ///< that brains may choose
  [[nodiscard]] const RuleStates<Rules>& states() const { return states_; }
  [[nodiscard]] const Economy<Rules>& economy() const { return economy_; }

  /// Writes all individuals and states to an archive, or reads them from it (trophic/params/archive.hpp). Throws
  /// std::invalid_argument for bytes that are not a population of these rules, and is then in an undefined state.
  void persist(Archive& archive) {
    const std::size_t bodies = census_.bodies();
    persist_keepers(archive, rules_, states_);
    archive(next_id_, genomes_.next_id(), census_.saved());
    for_each_state(rules_, states_, [&](const auto&, auto& states) { archive(states); });
    genomes_.persist(archive, web_.size());
    archive(economy_);
    acts_.persist(archive);
    if (!archive.reads()) return;
    Archive::require(census_.bodies() == bodies, "a different number of robots");
    for (const Individual& one : census_.all()) {
      const bool has_rules = one.id < next_id_ && one.species < web_.size() && genomes_.fits(one);
      detail::check_saved(one, tags_, one.lives() && has_rules, bodies);
    }
    genomes_.check_bounds(census_.all(), web_);
    census_.count_all();
    for_each_state(rules_, states_, [&](const auto&, const auto& states) {
      Archive::require(states.all().size() == bodies, "different numbers of states and robots");
    });
  }

  /// Like those of the census.
  void stand_at(std::span<const GroundPose> poses) { census_.stand_at(poses); }
  void leave_tree() { census_.leave_tree(); }
  [[nodiscard]] const SearchTree* tree() const { return census_.tree(); }
  [[nodiscard]] const SearchTree& last_tree() const { return census_.last_tree(); }

  /// Gives the founders these genomes, body by body, and makes all active. Throws as Genomes::enlist does.
  void enlist(std::span<const Contestant> lineup) {
    for (BodyIndex body = 0; body < census_.bodies(); ++body) {
      genomes_.enlist(body, census_[body], lineup[body]);
      census_.change(body).active = true;
      census_.mark(body);
    }
  }

  /// Lets the newborn in a body be caught and perceived; restarts its age if the rule requires it.
  void activate(BodyIndex body, double time_s, bool restarts_age) {
    census_.change(body).active = true;
    census_.mark(body);
    if (restarts_age) census_.change(body).age_from_s = time_s;
  }

  /// Begins the ledger of energy of a tick.
  void open_ledger() { economy_.open_ledger(); }

  /// Registers that all bodies have moved, from `before`.
  void walk(std::span<const GroundPose> before, const View& view) { notify_walk(rules_, states_, before, view); }
  /// Let the acting individuals spend energy; let the resource grow; let the acting individuals bite.
  void spend(std::span<const GroundPose> before, const View& view, const auto& acting) {
    economy_.spend(census_.change_all(), before, view, acting);
  }
  void grow(const View& view) { economy_.grow(view); }
  void bite(const View& view, const auto& acting) { economy_.bite(census_.change_all(), view, acting); }

  /// Feeds the hunter. Its victim is still there; `replace` removes it.
  void feed(BodyIndex hunter, BodyIndex victim, const View& view) {
    census_.change(hunter).fed_tick = view.tick;
    economy_.eat(hunter, victim, census_.change_all(), view);
    notify_catch(rules_, states_, hunter, victim, view);
  }

  /// Notifies the rules of all others of a death. The dying individual is still there; `replace` or `vacate` removes it.
  void note_death(const Vacancy& death, const View& view) {
    notify_death(rules_, states_, death, view);
    economy_.lose(death, census_.change(death.body), view);
  }

  /// Changes the field after a birth of the rule Recruitment.
  void note_birth(std::span<const Ancestor> parents, const View& view, Rng& rng) {
    if constexpr (energy::detail::TakesBirths<PolicyIn<Rules, RuleSlot::resource>>)
      economy_.take_birth(bodies_of(parents), view, rng);
  }

  /// Registers an individual's adversary at this tick, if it perceives one.
  void sight(BodyIndex body, const std::optional<Sighting>& sighting, const View& view) {
    Individual& self = census_.change(body);
    self.adversary = sighting ? std::optional{sighting->adversary} : std::nullopt;
    self.adversary_distance_m = sighting ? sighting->distance_m : std::numeric_limits<double>::quiet_NaN();
    notify_sighting(rules_, states_, body, sighting, view);
  }

  using Inputs = typename Sensors::Values;
  using Outputs = typename ActMemory<Rules>::Outputs;

  /// Returns the inputs of an individual's brain: the first of the sensors' values.
  [[nodiscard]] std::span<const double> inputs_of(BodyIndex body, const Inputs& inputs) const {
    return std::span{inputs}.first(Sensors::size_of(census_[body].species));
  }

  /// Sets the outputs of an individual's brain for these inputs.
  void ask_brain(BodyIndex body, const Inputs& inputs, Outputs& outputs) {
    const Individual& self = census_[body];
    control::ask::answer(for_species(rules_.brain, self.species), states_.brain[body], inputs_of(body, inputs),
                         self.genome->weights, outputs);
  }

  /// The same for several individuals, one after another or, if the brain evaluates all at once, together. `choices`: by body.
  void ask_brains(std::span<const BodyIndex> asked, auto& choices) {
    if constexpr (control::EvaluatesAll<Brain>) {
      for (Species species = 0; species < web_.size(); ++species) ask_species(species, asked, choices);
    } else {
      for (const BodyIndex body : asked) ask_brain(body, choices[body].inputs, choices[body].outputs);
    }
  }

  /// Returns the decision that these outputs stand for. Throws RuleError for an unlisted tag or a number that is not finite.
  [[nodiscard]] control::Decision decision(BodyIndex body, const Outputs& outputs) const {
    const Individual& self = census_[body];
    const control::Decision decision =
        control::ask::decision_of<Acts>(for_species(rules_.brain, self.species), std::span<const double, Acts::outputs>{outputs},
                                        {.target_angle_rad = self.target_angle_rad, .tag = self.tag});
    check_tag(tags_, decision.tag, "brain");
    check_finite("brain", "a target angle", {&decision.target_angle_rad, 1});
    check_finite("brain", "outputs", outputs);
    return decision;
  }

  [[nodiscard]] ActMemory<Rules>& acts() { return acts_; }
  [[nodiscard]] const ActMemory<Rules>& acts() const { return acts_; }

  /// Sets the target angle, positive to the right.
  void turn(BodyIndex body, double target_angle_rad) { census_.change(body).target_angle_rad = target_angle_rad; }
  void show_tag(BodyIndex body, int tag) {
    if (census_[body].tag == tag) return;
    census_.change(body).tag = tag;
    census_.mark(body);
  }
  void restart_tag_clock(BodyIndex body, double time_s) { census_.change(body).tag_since_s = time_s; }

  /// The body of an individual; empty if it is dead.
  [[nodiscard]] std::optional<BodyIndex> body_of(IndividualId id) const { return census_.body_of(id); }
  /// The bodies of the living ancestors among these.
  [[nodiscard]] std::vector<BodyIndex> bodies_of(std::span<const Ancestor> ancestors) const {
    std::vector<BodyIndex> bodies;
    for (const Ancestor& one : ancestors) {
      if (const auto body = body_of(one.id)) bodies.push_back(*body);
    }
    return bodies;
  }

  /// As Genomes::misfit.
  [[nodiscard]] std::optional<std::string> misfit(Species species, const Genome* genome) const {
    return genomes_.misfit(species, genome);
  }
  /// The phenotype of each body; empty if all have the habitat's.
  [[nodiscard]] std::span<const Phenotype> phenotypes() const { return genomes_.phenotypes().all(); }
  /// The number of refused mutations of bodies.
  [[nodiscard]] std::uint64_t refused_bodies() const { return genomes_.phenotypes().refused(); }

  /// Removes the individual from a body, which is spare from then on.
  void vacate(BodyIndex body) { census_.vacate(body); }

  /// Replaces the body's occupant by an offspring or a random newcomer of `species`, in the same place; fills a spare body.
  void replace(BodyIndex body, Species species, const Parentage& parentage, const View& view) {
    const std::span parents{parentage.parents};
    Individual born = newborn(species, view.time_s, view.tick, &census_[body]);
    auto genome = genomes_.inherit(born, parents);
    const std::vector<BodyIndex> living = bodies_of(parents);
    create_states(born, body, genome && !living.empty() ? std::optional{living.front()} : std::nullopt);
    if (!parents.empty()) {
      genomes_.descend(born, body, parents, std::move(genome), states_.mutation[body]);
    } else {
      born.genome = genomes_.draw(born, body);
      if (parentage.descent == reproduction::Descent::of_parent_in_name) born.origin = Origin::inherited;
    }
    if (parentage.endowment_J == 0.0 || living.empty()) {
      economy_.endow_from_outside(born);
    } else {
      economy_.endow(born, parentage.endowment_J, census_.change_all(), parentage.payers(living));
    }
    census_.replace(body, std::move(born));
    acts_.rest(body);
    for (const BodyIndex parent : living) {
      if (parent != body) notify_offspring(rules_, states_, parent, body, view);
    }
  }

  /// Throws std::invalid_argument unless `outputs` has a decision for each of these individuals, one after another.
  void check_outputs(std::span<const BodyIndex> bodies, std::span<const double> outputs) const {
    if (outputs.size() != bodies.size() * Acts::outputs) {
      throw std::invalid_argument{"outputs: " + std::to_string(outputs.size()) + " numbers: must be " +
                                  std::to_string(bodies.size() * Acts::outputs) + ", " + std::to_string(Acts::outputs) +
                                  " for each of " + std::to_string(bodies.size()) + " robots"};
    }
    for (std::size_t row = 0; row < bodies.size(); ++row) {
      const auto own = outputs.subspan(row * Acts::outputs).template first<Acts::outputs>();
      const auto wrong = wrong_output(own);
      if (!wrong) continue;
      const Individual& self = census_[bodies[row]];
      throw std::invalid_argument{"outputs: row " + std::to_string(row) + ", individual " + std::to_string(self.id) + " (" +
                                  web_.name(self.species) + "): " + *wrong};
    }
  }

 private:
  /// Why these outputs are not a decision, if they are not.
  [[nodiscard]] std::optional<std::string> wrong_output(std::span<const double, Acts::outputs> outputs) const {
    for (std::size_t i = 0; i < outputs.size(); ++i)
      if (!std::isfinite(outputs[i])) return Acts::output_names()[i] + " = " + number_text(outputs[i]) + ": must be finite";
    if constexpr (!control::EvaluatesOutputs<Brain>) {
      for (const int tag : tags_)
        if (outputs[1] == tag) return std::nullopt;
      return "tag = " + number_text(outputs[1]) + ": must be one of the brain's tags";
    }
    return acts_.out_of_bounds(outputs);
  }

  /// The outputs of those individuals of a species that are asked, in one call.
  void ask_species(Species species, std::span<const BodyIndex> asked, auto& choices) requires control::EvaluatesAll<Brain> {
    std::vector<BodyIndex> bodies;
    std::vector<double> inputs;
    std::vector<std::span<const double>> genomes;
    for (const BodyIndex body : asked) {
      if (census_[body].species != species) continue;
      const auto own = inputs_of(body, choices[body].inputs);
      bodies.push_back(body);
      inputs.insert(inputs.end(), own.begin(), own.end());
      genomes.emplace_back(census_[body].genome->weights);
    }
    if (bodies.empty()) return;
    std::vector<double> outputs(bodies.size() * Acts::outputs);
    for_species(rules_.brain, species).evaluate_all(inputs, genomes, outputs);
    auto from = outputs.begin();
    for (const BodyIndex body : bodies) {
      std::copy_n(from, Acts::outputs, choices[body].outputs.begin());
      from += Acts::outputs;
    }
  }

  /// Adds a body with a founder of a species, or a spare one.
  void found(Species species) {
    Individual born = newborn(species, 0.0, 0, nullptr);
    if (species == no_species) {
      for_each_state(rules_, states_, [&]<class P>(const P&, BodyStates<P>& states) { states.push_back({}); });
      census_.add(spare_body(born.tag, 0.0));
      return genomes_.add_spare();
    }
    for_each_state(rules_, states_, [&]<class P>(const P& policy, BodyStates<P>& states) {
      states.push_back(for_species(policy, born.species).born(born, nullptr, StateOf<P>{}));
    });
    born.genome = genomes_.draw(born, census_.bodies());
    economy_.endow_from_outside(born);
    census_.add(std::move(born));
  }

  /// Creates the states of a newborn.
  void create_states(const Individual& born, BodyIndex body, std::optional<BodyIndex> parent) {
    for_each_state(rules_, states_, [&](const auto& policy, auto& states) {
      states[body] =
          for_species(policy, born.species).born(born, parent ? &states[*parent] : nullptr, std::as_const(states)[body]);
    });
  }

  /// Returns a newborn without its genome. `previous` is the body's last occupant, empty for a founder.
  [[nodiscard]] Individual newborn(Species species, double time_s, std::int64_t tick, const Individual* previous) {
    Individual born = newborn_at(next_id_++, species, !web_.is_hunted(species), time_s, tick);
    Rng rng{seed_, Stream::newborn_tag, born.id};
    born.tag = rules_.newborn_tag.tag(previous != nullptr ? std::optional{previous->tag} : std::nullopt, tags_, rng);
    check_tag(tags_, born.tag, "newborn_tag");
    if (previous != nullptr) born.target_angle_rad = previous->target_angle_rad;
    return born;
  }

  const Policies<Rules>& rules_;
  const FoodWeb& web_;
  std::uint64_t seed_;
  std::vector<int> tags_;
  Genomes<Rules> genomes_;
  Economy<Rules> economy_;
  Census census_;
  IndividualId next_id_ = 0;  ///< id of the next newborn
  RuleStates<Rules> states_;
  ActMemory<Rules> acts_;
};

}  // namespace trophic
