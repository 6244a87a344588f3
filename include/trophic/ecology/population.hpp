// SPDX-License-Identifier: MIT
// Owns the individuals: founders, births, ids, genomes, tags and the tree by which they are found.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/ecology/act_memory.hpp>
#include <trophic/ecology/births.hpp>
#include <trophic/ecology/brain_genes.hpp>
#include <trophic/ecology/economy.hpp>
#include <trophic/ecology/lineup.hpp>
#include <trophic/ecology/phenotypes.hpp>
#include <trophic/ecology/state_hooks.hpp>
#include <trophic/ecology/trait_genes.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/rules/rule_states.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>
#include <unordered_map>

namespace trophic {

/// One individual per body, starting with the founders, and the states of all rules: the only writer of both. Applies the birth
/// rules of a table; the ecology decides which body falls vacant, and when. A table with a Recruitment rule has bodies without an
/// individual, too.
template <class Rules>
class Population {
 public:
  using Sensors = PolicyIn<Rules, RuleSlot::sensors>;
  using Brain = AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>;
  using Acts = typename ActMemory<Rules>::Acts;
  static_assert(control::detail::SameInputs<Sensors::size, control::detail::inputs_taken<Brain, Sensors::size>>,
                "the brain in Rules::Brain takes another number of inputs than the sensors in Rules::Sensors give");

  /// Founders of these species, one per body, all with random genomes (Sec. "Initialization"). Hunted species start inactive.
  /// A body for which `founders` has no_species starts spare; the id of every founder is the number of its body.
  /// Throws RuleError for a brain that lists no tag or one twice, and for a species or a tag that does not exist, here and at
  /// later births.
  Population(const Policies<Rules>& rules, const FoodWeb& web, std::uint64_t seed, std::span<const Species> founders,
             const BirthSetting& setting = {})
      : rules_{rules},
        web_{web},
        seed_{seed},
        null_{setting.null},
        tags_{for_species(rules.brain, 0).tags()},
        brains_{rules, seed},
        traits_{rules, seed},
        phenotypes_{rules, seed, setting.habitat, setting.nursery},
        economy_{rules, seed, web.size(), setting.habitat} {
    check_tags(tags_);
    for (const Species species : founders)
      if (species != no_species) check_index("community", "species", species, web.size());
    members_.resize(web.size());
    for (const Species species : founders) {
      Individual born = newborn(species, 0.0, 0, nullptr);
      if (species == no_species) {
        for_each_state(rules_, states_, [&]<class P>(const P&, BodyStates<P>& states) { states.push_back({}); });
        individuals_.push_back(spare_body(born.tag, 0.0));
        phenotypes_.add_spare();
        continue;
      }
      for_each_state(rules_, states_, [&]<class P>(const P& policy, BodyStates<P>& states) {
        states.push_back(for_species(policy, born.species).born(born, nullptr, StateOf<P>{}));
      });
      born.genome = drawn_genome(born, individuals_.size());
      economy_.endow_from_outside(born);
      ++members_[species];
      bodies_[born.id] = individuals_.size();
      individuals_.push_back(std::move(born));
    }
    for (BodyIndex body = 0; body < individuals_.size(); ++body) acts_.rest(body);
  }

  [[nodiscard]] std::span<const Individual> individuals() const { return individuals_; }
  [[nodiscard]] std::span<const std::size_t> members() const { return members_; }  ///< of each species
  [[nodiscard]] IndividualId next_id() const { return next_id_; }                  ///< of the next newborn
  [[nodiscard]] const Individual& operator[](BodyIndex body) const { return individuals_[body]; }
  [[nodiscard]] const RuleStates<Rules>& states() const { return states_; }
  [[nodiscard]] const Economy<Rules>& economy() const { return economy_; }

  /// Writes all individuals and states to an archive, or reads them from it (trophic/params/archive.hpp). Throws
  /// std::invalid_argument for bytes that are not a population of these rules, and is then in an undefined state.
  template <class Archive>
  void persist(Archive& archive) {
    const std::size_t bodies = individuals_.size();
    std::string keepers;  // states can only be read by the rules that wrote them
    for_each_state(rules_, states_, [&](const auto& policy, auto&) { keepers.append(policy.name).push_back(' '); });
    std::string there = keepers;
    archive(there);
    Archive::require(there == keepers, "rules with other states");
    archive(next_id_, next_genome_id_, individuals_);
    for_each_state(rules_, states_, [&](const auto&, auto& states) { archive(states); });
    phenotypes_.persist(archive, web_.size());
    archive(economy_);
    acts_.persist(archive);
    if (!archive.reads()) return;
    Archive::require(individuals_.size() == bodies, "another number of robots");
    for (const Individual& individual : individuals_) check_saved(individual);
    std::ranges::fill(members_, std::size_t{0});
    bodies_.clear();
    for (BodyIndex body = 0; body < bodies; ++body) {
      if (!individuals_[body].lives()) continue;
      ++members_[individuals_[body].species];
      bodies_[individuals_[body].id] = body;
    }
    for_each_state(rules_, states_, [&](const auto&, const auto& states) {
      Archive::require(states.all().size() == bodies, "another number of states than of robots");
    });
  }

  /// Places bodies at `poses`, one for each; refers to them. Searches can use a tree from then on, until `leave_tree`.
  void stand_at(std::span<const GroundPose> poses) {
    poses_ = poses;
    tree_ = SearchTree{poses_, individuals_};
  }
  /// Bodies stand elsewhere: searches visit all of them until the next `stand_at`.
  void leave_tree() { poses_ = {}; }
  /// Finds the closest bodies; null before `stand_at`.
  [[nodiscard]] const SearchTree* tree() const { return poses_.empty() ? nullptr : &tree_; }

  /// Gives the founders these genomes, body by body, and makes all active. Throws std::invalid_argument for a genome that the
  /// brain does not take.
  void enlist(std::span<const Contestant> lineup) {
    for (BodyIndex body = 0; body < individuals_.size(); ++body) {
      const Genome& given = lineup[body].genome;
      Genome& genome = *individuals_[body].genome;
      if (const auto demand = brains_.misfit(lineup[body].species, &given)) {
        throw std::invalid_argument{"a contest of genomes of " + std::to_string(given.weights.size()) + " weights: must have " +
                                    *demand + ", as the table's brain takes it"};
      }
      const auto is_in_one = [&](auto part) { return (genome.*part).empty() != (given.*part).empty(); };
      if (is_in_one(&Genome::gait_genes) || is_in_one(&Genome::body_genes) || genome.traits.size() != given.traits.size())
        throw std::invalid_argument{"a contest of genomes without some parts: must have the table's gaits, bodies and traits"};
      genome = {genome.id, given.weights, given.gait_genes, given.body_genes, given.traits};
      phenotypes_.express(body, individuals_[body], genome);
      individuals_[body].active = true;
      mark(body);
    }
  }

  /// Lets the newborn in a body be caught and seen; restarts its age if the rule requires it.
  void activate(BodyIndex body, double time_s, bool restarts_age) {
    individuals_[body].active = true;
    mark(body);
    if (restarts_age) individuals_[body].age_from_s = time_s;
  }

  /// Begins the ledger of energy of a tick.
  void open_ledger() { economy_.open_ledger(); }

  /// Notes that all bodies have moved, from `before`, and lets all spend and bite.
  void walk(std::span<const GroundPose> before, const View& view) {
    notify_walk(rules_, states_, before, view);
    economy_.spend_and_bite(individuals_, before, view);
  }

  /// Feeds the hunter. Its victim is still there; `replace` removes it.
  void feed(BodyIndex hunter, BodyIndex victim, const View& view) {
    individuals_[hunter].fed_tick = view.tick;
    economy_.eat(hunter, victim, individuals_, view);
    notify_catch(rules_, states_, hunter, victim, view);
  }

  /// Notifies the rules of all others of a death. The dying individual is still there; `replace` or `vacate` removes it.
  void note_death(const Vacancy& death, const View& view) {
    notify_death(rules_, states_, death, view);
    economy_.lose(death, individuals_[death.body], view);
  }

  /// Notes an individual's adversary at this tick, if it perceives one.
  void sight(BodyIndex body, const std::optional<Sighting>& sighting, const View& view) {
    Individual& self = individuals_[body];
    self.adversary = sighting ? std::optional{sighting->adversary} : std::nullopt;
    self.adversary_distance_m = sighting ? sighting->distance_m : std::numeric_limits<double>::quiet_NaN();
    notify_sighting(rules_, states_, body, sighting, view);
  }

  /// The brain's decision for these inputs, and its outputs. Throws RuleError for a tag that is not listed and a number that is
  /// not finite.
  using Outputs = typename ActMemory<Rules>::Outputs;
  [[nodiscard]] control::Decision decide(BodyIndex body, std::span<const double> inputs, Outputs& outputs) {
    check_finite("sensors", "inputs", inputs);
    const Individual& self = individuals_[body];
    const control::Decision decision = control::ask::decide<Acts>(
        for_species(rules_.brain, self.species), states_.brain[body], inputs, weights(body),
        std::span<double, Acts::outputs>{outputs}, {.target_angle_rad = self.target_angle_rad, .tag = self.tag});
    check_tag(tags_, decision.tag, "brain");
    check_finite("brain", "a target angle", {&decision.target_angle_rad, 1});
    check_finite("brain", "outputs", outputs);
    return decision;
  }

  [[nodiscard]] ActMemory<Rules>& acts() { return acts_; }
  [[nodiscard]] const ActMemory<Rules>& acts() const { return acts_; }

  /// Sets the target angle, positive to the right.
  void turn(BodyIndex body, double target_angle_rad) { individuals_[body].target_angle_rad = target_angle_rad; }
  void show_tag(BodyIndex body, int tag) {
    if (individuals_[body].tag == tag) return;
    individuals_[body].tag = tag;
    mark(body);
  }
  void restart_tag_clock(BodyIndex body, double time_s) { individuals_[body].tag_since_s = time_s; }

  /// Chooses between a random and an inherited genome and calls the parent rule. Changes nothing.
  [[nodiscard]] Parentage parentage(const reproduction::Vacancy& vacancy, const View& view) const {
    Rng source{seed_, Stream::genome_source, next_id_};
    Parentage result{.descent = rules_.genome_source.descent(source)};
    if (result.descent != reproduction::Descent::random) {
      Rng rng{seed_, Stream::parent, next_id_};
      const auto parent = reproduction::ask::parent(rules_.parent, states_.parent.all(), vacancy, view, rng);
      if (parent) result.parents.push_back(*parent);
    }
    return result;
  }

  /// The body of an individual; none for the dead.
  [[nodiscard]] std::optional<BodyIndex> body_of(IndividualId id) const {
    const auto found = bodies_.find(id);
    return found == bodies_.end() ? std::nullopt : std::optional{found->second};
  }

  /// The demand of a species' brain that a genome violates, "a genome of 15 weights"; none if it fits.
  [[nodiscard]] std::optional<std::string> misfit(Species species, const Genome* genome) const {
    return brains_.misfit(species, genome);
  }

  /// The body and the gait in each body; empty if all have the habitat's.
  [[nodiscard]] std::span<const Phenotype> phenotypes() const { return phenotypes_.all(); }
  /// The number of mutations of bodies that were refused.
  [[nodiscard]] std::uint64_t refused_bodies() const { return phenotypes_.refused(); }

  /// Whether the living parents of a birth have the energy that it hands over, in equal parts.
  [[nodiscard]] bool can_endow(const reproduction::Recruit& recruit) const {
    const std::vector<BodyIndex> living = bodies_of(recruit.parents);
    if (!Economy<Rules>::has_energy || living.empty()) return true;
    const double part_J = recruit.endowment_J / static_cast<double>(living.size());
    return std::ranges::all_of(living, [&](BodyIndex body) { return part_J <= std::max(individuals_[body].energy_J, 0.0); });
  }

  /// Takes the individual out of a body, which is spare from then on.
  void vacate(BodyIndex body) {
    remove(body);
    individuals_[body] = spare_body(individuals_[body].tag, individuals_[body].target_angle_rad);
    mark(body);
  }

  /// Replaces the body's occupant by an offspring or a random newcomer of `species`, in the same place; fills a spare body.
  void replace(BodyIndex body, Species species, const Parentage& parentage, const View& view) {
    const std::span parents{parentage.parents};
    Individual born = newborn(species, view.time_s, view.tick, &individuals_[body]);
    std::vector<std::vector<double>> before;  // a heredity may share a parent's genome and change it
    for (const Ancestor& parent : parents) before.push_back(parent.genome->weights);
    Rng rng{seed_, Stream::crossover, born.id};
    const auto& rule = for_species(rules_.heredity, species);
    auto genome =
        parents.empty() || draws_anew() ? nullptr : reproduction::ask::inherit(rule, parents, brains_.neurons(species), rng);
    if (const auto demand = genome && !genome->weights.empty() ? brains_.misfit(species, genome.get()) : std::nullopt) {
      throw RuleError{"heredity", "a genome of " + std::to_string(genome->weights.size()) + " weights: must have " + *demand};
    }
    const std::vector<BodyIndex> living = bodies_of(parents);
    create_states(born, body, genome && !living.empty() ? std::optional{living.front()} : std::nullopt);
    if (!parents.empty()) {
      descend(born, body, parents, std::move(genome), before);
    } else {
      born.genome = drawn_genome(born, body);
      if (parentage.descent == reproduction::Descent::of_parent_in_name) born.origin = Origin::inherited;
    }
    endow(born, parentage.endowment_J, living);
    remove(body);
    ++members_[species];
    bodies_[born.id] = body;
    individuals_[body] = std::move(born);
    mark(body);
    acts_.rest(body);
    for (const BodyIndex parent : living) {
      if (parent != body) notify_offspring(rules_, states_, parent, body, view);
    }
  }

 private:
  /// The bodies of those ancestors that live.
  [[nodiscard]] std::vector<BodyIndex> bodies_of(std::span<const Ancestor> ancestors) const {
    std::vector<BodyIndex> bodies;
    for (const Ancestor& one : ancestors) {
      if (const auto body = body_of(one.id)) bodies.push_back(*body);
    }
    return bodies;
  }

  void endow(Individual& born, double endowment_J, std::span<const BodyIndex> living) {
    if (endowment_J == 0.0 || living.empty()) return economy_.endow_from_outside(born);
    economy_.endow(born, endowment_J, individuals_, living);
  }

  /// A body's species, tag or activity changed.
  void mark(BodyIndex body) {
    if (!poses_.empty()) tree_.mark(body, poses_[body], individuals_[body]);
  }

  [[nodiscard]] std::span<const double> weights(BodyIndex body) const { return individuals_[body].genome->weights; }

  /// Throws std::invalid_argument for an individual that cannot exist under these rules.
  void check_saved(const Individual& individual) const {
    const bool has_tag = std::ranges::count(tags_, individual.tag) == 1;
    if (!individual.lives()) {
      if (individual.id == no_individual && !individual.genome && !individual.active && !individual.adversary && has_tag) return;
      throw std::invalid_argument{"a spare body of other rules"};
    }
    const bool sound = individual.id < next_id_ && individual.species < web_.size() &&
                       !brains_.misfit(individual.species, individual.genome.get()) && has_tag &&
                       individual.adversary.value_or(0) < individuals_.size() &&
                       individual.genome->traits.size() == TraitGenes<Rules>::names.size();
    if (!sound) throw std::invalid_argument{"an individual of other rules"};
  }

  /// Creates the states of a newborn.
  void create_states(const Individual& born, BodyIndex body, std::optional<BodyIndex> parent) {
    for_each_state(rules_, states_, [&](const auto& policy, auto& states) {
      states[body] =
          for_species(policy, born.species).born(born, parent ? &states[*parent] : nullptr, std::as_const(states)[body]);
    });
  }

  /// Takes the individual of a body, if any, from the counts.
  void remove(BodyIndex body) {
    if (!individuals_[body].lives()) return;
    --members_[individuals_[body].species];
    bodies_.erase(individuals_[body].id);
  }

  /// A newborn without its genome. `previous` is the body's last occupant, none for a founder.
  [[nodiscard]] Individual newborn(Species species, double time_s, std::int64_t tick, const Individual* previous) {
    Individual born;
    born.id = next_id_++;
    born.species = species;
    born.active = !web_.is_hunted(species);
    born.born_s = born.age_from_s = born.tag_since_s = time_s;
    born.fed_tick = tick;
    Rng rng{seed_, Stream::newborn_tag, born.id};
    born.tag = rules_.newborn_tag.tag(previous != nullptr ? std::optional{previous->tag} : std::nullopt, tags_, rng);
    check_tag(tags_, born.tag, "newborn_tag");
    if (previous != nullptr) born.target_angle_rad = previous->target_angle_rad;
    return born;
  }

  [[nodiscard]] std::shared_ptr<Genome> drawn_genome(const Individual& born, BodyIndex body) {
    auto genome = std::make_shared<Genome>(Genome{.id = next_genome_id_++});
    const IndividualId as = null_ == Null::clones ? 0 : born.id;
    brains_.draw(*genome, born, as);
    traits_.draw_or_mutate(*genome, born, as);
    phenotypes_.develop(body, born, *genome, as);
    return genome;
  }

  /// Whether offspring draw genomes instead of inheriting them.
  [[nodiscard]] bool draws_anew() const { return null_ == Null::shadow || null_ == Null::clones; }

  /// Sets origin, parents and genome of a newborn with parents. `genome` is the inherited one, mutated here, with parts that are
  /// empty drawn; if null, a genome is drawn. `before`: the weights of each parent before all this.
  void descend(Individual& born, BodyIndex body, std::span<const Ancestor> parents, std::shared_ptr<Genome> genome,
               std::span<const std::vector<double>> before) {
    born.origin = Origin::inherited;
    for (const Ancestor& parent : parents) born.parents.push_back(parent.id);
    if (!genome) {
      born.genome = drawn_genome(born, body);
    } else {
      const bool is_shared = std::ranges::any_of(parents, [&](const Ancestor& parent) { return parent.genome == genome; });
      if (!is_shared) genome->id = next_genome_id_++;
      brains_.draw_or_mutate(*genome, states_.mutation[body], born);
      traits_.draw_or_mutate(*genome, born, born.id);
      phenotypes_.develop(body, born, *genome, born.id);
      born.genome = std::move(genome);
    }
    born.mutation_distance = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& weights : before)
      born.mutation_distance = std::min(born.mutation_distance, brains_.distance(born.species, weights, born.genome->weights));
  }

  const Policies<Rules>& rules_;
  const FoodWeb& web_;
  std::uint64_t seed_;
  Null null_;
  std::vector<int> tags_;
  BrainGenes<Rules> brains_;
  TraitGenes<Rules> traits_;
  Phenotypes<Rules> phenotypes_;
  Economy<Rules> economy_;
  IndividualId next_id_ = 0;
  std::uint64_t next_genome_id_ = 0;
  std::vector<Individual> individuals_;
  std::vector<std::size_t> members_;                         ///< of each species
  std::unordered_map<IndividualId, BodyIndex> bodies_ = {};  ///< the body of each individual
  std::span<const GroundPose> poses_ = {};                   ///< of the bodies
  SearchTree tree_;
  RuleStates<Rules> states_;
  ActMemory<Rules> acts_;
};

}  // namespace trophic
