// SPDX-License-Identifier: MIT
// Births by energy: individuals with enough energy reproduce.
#pragma once

#include <trophic/reproduction/recruitment/contract.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: an active individual with at least `birth` energy has an offspring of its species next to it and gives it the `share` of
/// its energy; the oldest individuals come first. If activation depends on behaviour, so do births; with `only_active` = false
/// inactive individuals reproduce as well. The dead are not replaced. `spare_bodies` start without an individual. All parameters
/// are free. Reads: energies, activity.   Random draws: 0.
struct AtEnergy {
  static constexpr std::string_view name = "at_energy";
  static constexpr std::string_view source = "not in the paper; as in Polyworld [yaeger1994]";
  using NamesOneParent = AtEnergy;
  using NoNewcomers = AtEnergy;

  struct Params {
    std::size_t spare_bodies = 0;
    double birth_J = 100.0;
    double share = 0.5;
    bool only_active = true;
    static constexpr auto fields() {
      return std::tuple{
          field("spare_bodies", &Params::spare_bodies, at_least(0), "number of bodies without an individual at the start")
              .read_at_start(),
          field("birth_J", &Params::birth_J, above(0.0), "energy at which an individual reproduces"),
          field("share", &Params::share, above_to(0.0, 1.0), "share of its energy that a parent gives to its offspring"),
          field("only_active", &Params::only_active, "whether only active individuals reproduce")};
    }
  };
  Params params;

  [[nodiscard]] std::string_view why_no_effect(std::string_view number, const FoodWeb& web, OneSpecies species) const {
    const bool none_is_inactive = species && !web.is_hunted(*species);
    return number == "only_active" && none_is_inactive ? "for a species that is hunted by none and so always active" : "";
  }

  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<Recruit> recruits(const View& view, Rng&) const {
    std::vector<Recruit> births;
    for (const Individual& one : view.robots) {
      const bool may = one.lives() && (one.active || !params.only_active);
      if (!may || one.energy_J < params.birth_J) continue;
      births.push_back({.species = one.species, .parents = {one.as_ancestor()}, .endowment_J = params.share * one.energy_J});
    }
    std::ranges::sort(births, {}, [](const Recruit& birth) { return birth.parents.front().id; });
    return births;
  }
};
static_assert(Recruitment<AtEnergy>);

}  // namespace trophic::reproduction::recruitment
