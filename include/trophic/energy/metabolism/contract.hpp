// SPDX-License-Identifier: MIT
// The contract of a slot: the energy of individuals.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Metabolism                                                                                            \
  "double first_J(const Individual&, Rng&) const, double upkeep_J(BodyIndex, double walked_m, const View&) const, double "     \
  "bite_J(BodyIndex, std::size_t food, double there_J, const View&) const, double meal_J(BodyIndex hunter, BodyIndex victim, " \
  "const View&) const, bool starves(BodyIndex, const View&) const; bonus_J, if there is one, must be callable as double "      \
  "bonus_J(BodyIndex hunter, BodyIndex victim, const View&) const, grant_J as double grant_J(const Individual&) const, and "   \
  "waste_J as double waste_J(BodyIndex, std::size_t food, double bite_J, const View&) const; "                                 \
  "see trophic/energy/metabolism/contract.hpp"

namespace trophic::energy {

namespace detail {

TROPHIC_PROBE_NAME(bonus_J)
TROPHIC_PROBE_NAME(grant_J)
template <class P>
concept GivesBonus = requires(const P policy, BodyIndex body, const View& view) {
  { policy.bonus_J(body, body, view) } -> std::same_as<double>;
};
template <class P>
concept GivesGrant = requires(const P policy, const Individual& newborn) {
  { policy.grant_J(newborn) } -> std::same_as<double>;
};

TROPHIC_PROBE_NAME(waste_J)
template <class P>
concept WastesFood = requires(const P policy, BodyIndex body, std::size_t food, const View& view) {
  { policy.waste_J(body, food, 1.0, view) } -> std::same_as<double>;
};

}  // namespace detail

/// The only owner of energy. `view.robots[body].energy_J` is the energy of the individual in a body; every rule and sensor may
/// read it. Only the population changes it, by the amounts that this rule returns, so energy never appears from nowhere.
/// energy.csv is its ledger.
///
/// - `first_J(newborn, rng)`: returns the energy of a founder, or of a newborn that no parent endows
/// - `upkeep_J(self, walked_m, view)`: returns what an individual spends in a tick in which it walked this distance, >= 0
/// - `bite_J(self, food, there_J, view)`: returns what it takes of the there_J of `view.foods[food]` in its cell, >= 0 and at
/// most
///   there_J; asked once a tick for each food in order, after upkeep, individuals in random order, in a table with a rule
///   Resource
/// - `meal_J(hunter, victim, view)`: returns how much of its victim's energy a hunter gets, >= 0 and at most all of it; the rest
/// is lost
/// - optional: `bonus_J(hunter, victim, view)`: returns what a hunter gets from outside at a catch, >= 0, as in worlds without a
/// budget
/// - optional: `grant_J(newborn)`: returns what a newborn gets from outside on top of the `energy_J` that its parents gave, >= 0
/// - optional: `waste_J(self, food, bite_J, view)`: returns what it destroys of that food with this bite, >= 0; at most what is
///   left in the cell
/// - `starves(self, view)`: returns whether an individual dies of hunger (Cause::starved); asked after bites and catches
///
/// A newborn's endowment is part of its birth: Recruit::endowment_J of the rule Recruitment.
template <class P>
concept Metabolism = requires(const P policy, const Individual& newborn, BodyIndex body, double number, const View& view,
                              Rng& rng) {
  { policy.first_J(newborn, rng) } -> std::same_as<double>;
  { policy.upkeep_J(body, number, view) } -> std::same_as<double>;
  { policy.bite_J(body, std::size_t{}, number, view) } -> std::same_as<double>;
  { policy.meal_J(body, body, view) } -> std::same_as<double>;
  { policy.starves(body, view) } -> std::same_as<bool>;
  requires !detail::StateNames_bonus_J<P> || detail::GivesBonus<P>;
  requires !detail::StateNames_grant_J<P> || detail::GivesGrant<P>;
  requires !detail::StateNames_waste_J<P> || detail::WastesFood<P>;
};

namespace ask {

/// Returns 0 for a rule without a bonus.
template <class P>
[[nodiscard]] double bonus_J([[maybe_unused]] const P& policy, [[maybe_unused]] BodyIndex hunter,
                             [[maybe_unused]] BodyIndex victim, [[maybe_unused]] const View& view) {
  if constexpr (detail::GivesBonus<P>) return policy.bonus_J(hunter, victim, view);
  return 0.0;
}

/// Returns 0 for a rule without a grant.
template <class P>
[[nodiscard]] double grant_J([[maybe_unused]] const P& policy, [[maybe_unused]] const Individual& newborn) {
  if constexpr (detail::GivesGrant<P>) return policy.grant_J(newborn);
  return 0.0;
}

/// Returns 0 for a rule without waste.
template <class P>
[[nodiscard]] double waste_J([[maybe_unused]] const P& policy, [[maybe_unused]] BodyIndex self, [[maybe_unused]] std::size_t food,
                             [[maybe_unused]] double bite_J, [[maybe_unused]] const View& view) {
  if constexpr (detail::WastesFood<P>) return policy.waste_J(self, food, bite_J, view);
  return 0.0;
}

}  // namespace ask

}  // namespace trophic::energy
