// SPDX-License-Identifier: MIT
// Deaths and the births that follow from them.
#pragma once

#include <trophic/ecology/checks.hpp>
#include <trophic/ecology/ecology_state.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/reproduction/parent/contract.hpp>

namespace trophic {

/// Chooses between a random and an inherited genome for the next newborn and calls the parent rule.
template <class Rules>
[[nodiscard]] Parentage parentage_of(const Policies<Rules>& rules, const Population<Rules>& population, const Vacancy& vacancy,
                                     const View& view) {
  Rng source{population.seed(), Stream::genome_source, population.next_id()};
  Parentage result{.descent = rules.genome_source.descent(source)};
  if (result.descent == reproduction::Descent::random) return result;
  Rng rng{population.seed(), Stream::parent, population.next_id()};
  const auto parent = reproduction::ask::parent(rules.parent, population.states().parent.all(), vacancy, view, rng);
  if (parent) result.parents.push_back(*parent);
  return result;
}

/// Ends and begins lives in bodies, and reports both to observers.
template <class Rules>
class Turnover {
 public:
  /// `all` must outlive it.
  explicit Turnover(EcologyState<Rules>& all) : all_{all} {}

  void emit(observe::Audience& audience, observe::EventKind kind, BodyIndex body, std::optional<Cause> cause = {},
            std::optional<IndividualId> other = {}) const {
    audience.event(
        observe::Event{.kind = kind, .body = body, .individual = all_.population[body], .cause = cause, .other = other},
        all_.view());
  }

  void emit_death(observe::Audience& audience, const Vacancy& vacancy) {
    const auto killer = vacancy.killer ? std::optional{all_.population[*vacancy.killer].id} : std::nullopt;
    emit(audience, observe::EventKind::death, vacancy.body, vacancy.cause, killer);
    all_.population.note_death(vacancy, all_.view());
  }

  /// Death of the occupant and birth of its successor, unless the Recruitment rule leaves the body spare.
  void replace_occupant(observe::Audience& audience, const Vacancy& vacancy) {
    if (for_species(all_.rules.recruitment, all_.population[vacancy.body].species).leaves_spare(vacancy, all_.view())) {
      emit_death(audience, vacancy);
      all_.population.vacate(vacancy.body);
      return all_.bodies.take_away(vacancy.body);
    }
    reproduce_into(audience, vacancy);
  }

  /// `place`: where the body of an individual enters the world; empty if it is there already.
  void begin_life(observe::Audience& audience, BodyIndex body, const std::optional<GroundPose>& place = {}) {
    if (place) {
      all_.bodies.set_down(body, *place);
    } else if (Phenotypes<Rules>::differ) {
      all_.bodies.embody(body, all_.population.individuals().size());
    } else if (all_.params.ecology.phase_at_birth == PhaseAtBirth::reset) {
      all_.bodies.restart(body);
    }
    emit(audience, observe::EventKind::birth, body);
  }

  /// Returns a free place next to the first living one of these, or anywhere; empty if there is no room.
  [[nodiscard]] std::optional<GroundPose> place_of_birth(std::span<const Ancestor> parents) const {
    std::optional<BodyIndex> beside;
    for (const Ancestor& parent : parents) {
      if (!beside) beside = all_.population.body_of(parent.id);
    }
    return all_.bodies.free_place(beside, all_.population.next_id());
  }

 private:
  /// Unless the rules fix the successor's species, it is the parent's or, without a parent, the first species that the dead
  /// individual ate.
  void reproduce_into(observe::Audience& audience, const Vacancy& vacancy) {
    const Parentage own = parentage_of(all_.rules, all_.population, vacancy, all_.view());
    const Species dead = all_.population[vacancy.body].species;
    for (const Ancestor& parent : own.parents)
      detail::check_parent(all_.web, vacancy, parent, all_.population.misfit(parent.species, parent.genome.get()));
    auto successor = vacancy.successor;
    if (!successor) successor = own.parents.empty() ? all_.web.first_victim(dead).value_or(dead) : own.parents.front().species;
    emit_death(audience, vacancy);
    all_.population.replace(vacancy.body, *successor, own, all_.view());
    begin_life(audience, vacancy.body);
  }

  EcologyState<Rules>& all_;
};

}  // namespace trophic
