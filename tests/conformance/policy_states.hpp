// SPDX-License-Identifier: MIT
// States that a policy might keep for a population, and that they can be kept.
#pragma once

#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/params/policy.hpp>

namespace trophic::conformance {

namespace detail {

/// Any value of a member that a State may have.
template <class T>
void draw(T& value, Rng& rng) {
  if constexpr (HasFields<T>) {
    for_each_field(value, [&](const auto&, auto& member) { draw(member, rng); });
  } else if constexpr (std::same_as<T, bool>) {
    value = rng.chance(0.5);
  } else if constexpr (std::is_arithmetic_v<T>) {
    value = static_cast<T>(rng.index(100)) / static_cast<T>(10);
  } else if constexpr (std::same_as<T, Ancestor>) {
    value = test::ancestor(1 + rng.index(99), rng.index(2));
  } else if constexpr (requires { value.emplace(); }) {
    if (rng.chance(0.5)) draw(value.emplace(), rng);
  }
}

}  // namespace detail

/// A State that a policy might keep for an individual: drawn anew from the seed, the same in every world in which this
/// individual lives, whatever its body and id. Vectors stay as they are at birth.
template <class Policy>
[[nodiscard]] StateOf<Policy> own_state(const Policy& policy, const Individual& individual, std::uint64_t seed) {
  StateOf<Policy> own{};
  if constexpr (Stateful<Policy>) {
    own = policy.born(individual, nullptr, own);
    Rng rng{seed, Stream::user, individual.genome->id, 77};
    detail::draw(own, rng);
  }
  return own;
}

/// The same for all individuals, by body; nothing for a policy without State.
template <class Policy>
[[nodiscard]] std::vector<StateOf<Policy>> own_states(const Policy& policy, const test::HandPopulation& robots,
                                                      std::uint64_t seed) {
  std::vector<StateOf<Policy>> states;
  for (const Individual& one : robots.individuals) states.push_back(own_state(policy, one, seed));
  return states;
}

/// The states of all bodies, as a question about all of them is given them (AllStates); for a policy made of parts those of its
/// parts.
template <class Policy>
class AnyStates {
 public:
  AnyStates(const Policy& policy, const test::HandPopulation& robots, std::uint64_t seed)
      : states_{own_states(policy, robots, seed)} {}
  [[nodiscard]] AllStates<Policy> all() const { return states_; }

 private:
  std::vector<StateOf<Policy>> states_;
};
template <template <class...> class Whole, class... Ps>
requires MadeOfParts<Whole<Ps...>>
class AnyStates<Whole<Ps...>> {
 public:
  AnyStates(const Whole<Ps...>& policy, const test::HandPopulation& robots, std::uint64_t seed)
      : AnyStates{policy, robots, seed, std::index_sequence_for<Ps...>{}} {}
  [[nodiscard]] AllStates<Whole<Ps...>> all() const {
    return std::apply([](const auto&... parts) { return AllStates<Whole<Ps...>>{parts.all()...}; }, parts_);
  }

 private:
  template <std::size_t... place>
  AnyStates(const Whole<Ps...>& policy, const test::HandPopulation& robots, std::uint64_t seed, std::index_sequence<place...>)
      : parts_{AnyStates<Ps>{policy.template part<place>(), robots, seed}...} {}

  std::tuple<AnyStates<Ps>...> parts_;
};

/// A State lists all that it holds, so that it can be saved, and the policy says what a newborn starts with.
template <class Policy>
void check_state() {
  if constexpr (Stateful<Policy>) {
    using State = typename Policy::State;
    static_assert(Parameters<State> && trophic::detail::members_of<State> == trophic::detail::fields_of<State> &&
                  trophic::detail::listed_once<State>());
    static_assert(trophic::detail::only_state_members<State>() && trophic::detail::BornWithState<Policy>);
    CHECK_NOTHROW(static_cast<void>(make_policy<Policy>({}).born(Individual{}, nullptr, State{})));
  }
}

}  // namespace trophic::conformance
