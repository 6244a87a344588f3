// SPDX-License-Identifier: MIT
// Rules with a state: the data that a policy stores per body, its value for a newborn, and the hooks that change it.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/population/parts.hpp>
#include <trophic/population/sighting.hpp>
#include <trophic/population/vacancy.hpp>
#include <trophic/population/view.hpp>

/// A rule with a state is a policy with a nested `struct State { ... };` that lists its members in `fields()`, as Params do. The
/// population stores one State per body and slot. Policies stay const: the population passes a policy its own state.
///
///   State born(const Individual& newborn, const State* parent, const State& body) const
///
/// returns the state of a newborn; a policy with a State must have it. The newborn has no genome yet. `parent` is the state of
/// its first living parent; null for founders, random newcomers, offspring of the dead, and if Heredity passes nothing on. `body`
/// is the state of the body's previous occupant; State{} for founders. `return {};` resets it, `return body;` keeps it with the
/// body, `return parent ? *parent : State{};` inherits it. The shadow inherits nothing; `hand_over` below is for what a parent
/// gives away, and acts in every null.
///
/// Checkpoints hold all states, so a resumed run gives the same bytes. A State may therefore contain only the types that
/// rule_states.hpp allows.
///
/// A contract function about one body may take `const State& own` as its last argument; one about the whole population or about a
/// parent may take `std::span<const State> states`, by body: see the slot's contract. A brain's decide and a mutation take
/// `State& own`.
///
/// Each of these hooks changes the state `own` of the individual in the body `self`, at its moment in a tick:
///   void on_walk(State& own, BodyIndex self, double distance_m, const View&) const
///     after the bodies have moved: the straight distance between the positions at this tick and the last
///   void on_catch(State& own, BodyIndex self, BodyIndex victim, const View&) const
///     self catches victim, which is still in the view
///   void on_caught(State& own, BodyIndex self, BodyIndex hunter, const View&) const
///     self is caught and still in the view
///   void on_sighting(State& own, BodyIndex self, const std::optional<Sighting>& sighting, const View&) const
///     after perception: the adversary, if self perceives one
///   void on_offspring(State& own, BodyIndex self, BodyIndex newborn, const View&) const
///     self is a parent of an individual that is born in the body `newborn`; also if the newborn inherits nothing
///   void hand_over(State& own, State& newborn, const View&) const
///     just before on_offspring, for each living parent: transfers what a parent gives, such as a shell
///   void on_other_death(State& own, BodyIndex self, const Vacancy& death, const View&) const
///     another individual dies of any cause and is still in the view; its successor's parent has been chosen
#define TROPHIC_STATE_HOOKS(HOOK)                                                                       \
  HOOK(on_walk, double, "void on_walk(State&, BodyIndex, double distance_m, const View&)")              \
  HOOK(on_catch, BodyIndex, "void on_catch(State&, BodyIndex, BodyIndex, const View&)")                 \
  HOOK(on_caught, BodyIndex, "void on_caught(State&, BodyIndex, BodyIndex, const View&)")               \
  HOOK(on_sighting, const std::optional<Sighting>&,                                                     \
       "void on_sighting(State&, BodyIndex, const std::optional<Sighting>&, const View&)")              \
  HOOK(on_offspring, BodyIndex, "void on_offspring(State&, BodyIndex, BodyIndex newborn, const View&)") \
  HOOK(on_other_death, const Vacancy&, "void on_other_death(State&, BodyIndex, const Vacancy&, const View&)")

namespace trophic {

/// A policy with a State.
template <class P>
concept Stateful = requires {
  typename P::State;
};

/// The State of a policy without one.
struct NoState {
  friend bool operator==(const NoState&, const NoState&) = default;
};

namespace detail {

template <class P>
struct state_of {
  using type = NoState;
};
template <Stateful P>
struct state_of<P> {
  using type = typename P::State;
};

template <class T>
inline constexpr bool is_state_member = std::is_arithmetic_v<T> || NamedEnum<T> || std::same_as<T, Ancestor>;
template <class T>
inline constexpr bool is_state_member<std::optional<T>> = is_state_member<T>;
template <class T>
inline constexpr bool is_state_member<std::vector<T>> = std::is_arithmetic_v<T>;

/// Whether every listed member, including nested ones, can be saved.
template <class State>
[[nodiscard]] consteval bool only_state_members() {
  if constexpr (HasFields<State>) {
    const auto fits = []<class Owner, class T>(const Field<Owner, T>&) {
      if constexpr (HasFields<T> || std::is_empty_v<T>) return only_state_members<T>();
      return is_state_member<T>;
    };
    return std::apply([&](const auto&... fields) { return (fits(fields) && ...); }, State::fields());
  }
  return true;
}

/// A policy with a State that can be saved.
template <class P>
concept SavableState = Stateful<P> && only_state_members<typename P::State>();

template <class P>
struct answers_for_species {
  using type = P;
};
template <class P>
requires requires {
  typename P::OfOneSpecies;
}
struct answers_for_species<P> {
  using type = typename P::OfOneSpecies;
};

// A name is ambiguous in a class that inherits it twice: `&Probe::on_walk` is ill-formed exactly if the policy has any on_walk.
#define TROPHIC_PROBE_NAME(hook)                                 \
  struct StateHas_##hook {                                       \
    int hook;                                                    \
  };                                                             \
  template <class P>                                             \
  struct StateProbe_##hook : P, StateHas_##hook {};              \
  template <class P>                                             \
  concept StateNames_##hook = !std::is_final_v<P> && !requires { \
    &StateProbe_##hook<P>::hook;                                 \
  };
#define TROPHIC_PROBE_HOOK(hook, Happened, signature)                                                                            \
  TROPHIC_PROBE_NAME(hook)                                                                                                       \
  template <class P>                                                                                                             \
  concept StateTakes_##hook = Stateful<P>&& requires(const P& policy, typename P::State& own, Happened what, const View& view) { \
    policy.hook(own, BodyIndex{}, what, view);                                                                                   \
  };
TROPHIC_STATE_HOOKS(TROPHIC_PROBE_HOOK)
TROPHIC_PROBE_NAME(born)
TROPHIC_PROBE_NAME(hand_over)
#undef TROPHIC_PROBE_HOOK

/// A policy with a State whose parents give some of it to newborns.
template <class P>
concept HandsOver = Stateful<P> &&
    requires(const P& policy, typename P::State& own, typename P::State& newborn, const View& view) {
  policy.hand_over(own, newborn, view);
};

/// A policy with a State that has `born`.
template <class P>
concept BornWithState = requires(const typename answers_for_species<P>::type& policy, const Individual& newborn,
                                 const typename P::State* parent, const typename P::State& body) {
  { policy.born(newborn, parent, body) } -> std::same_as<typename P::State>;
};

/// Fails to compile with one message if a policy has hooks that are never called.
template <class Policy>
struct CheckStateHooks {
#define TROPHIC_CHECK_STATE_HOOK(hook, Happened, signature)                                                  \
  static_assert(!StateNames_##hook<Policy> || Stateful<Policy>, "a policy has " #hook                        \
                                                                " but no State, so it would never be "       \
                                                                "called; see trophic/population/state.hpp"); \
  static_assert(!StateNames_##hook<Policy> || !Stateful<Policy> || StateTakes_##hook<Policy>,                \
                "a policy's " #hook " must be callable as " signature " const; see trophic/population/state.hpp");
  TROPHIC_STATE_HOOKS(TROPHIC_CHECK_STATE_HOOK)
  static_assert(!StateNames_born<Policy> || Stateful<Policy>,
                "a policy has born but no State, so it would never be called; see trophic/population/state.hpp");
  static_assert(!StateNames_hand_over<Policy> || HandsOver<Policy>,
                "a policy's hand_over must be callable as void hand_over(State& own, State& newborn, const View&) const; see "
                "trophic/population/state.hpp");
#undef TROPHIC_CHECK_STATE_HOOK
  static constexpr bool ok = true;
};

/// In a struct: fails to compile with one message about `who` if a policy's State violates the requirements above.
#define TROPHIC_CHECK_STATE_OF(Policy, who)                                                                                \
  static_assert(                                                                                                           \
      !Stateful<Policy> ||                                                                                                 \
          (Parameters<StateOf<Policy>> && OpenParams<StateOf<Policy>> &&                                                   \
           AllListed<members_of<StateOf<Policy>>, fields_of<StateOf<Policy>>> && listed_once<StateOf<Policy>>()),          \
      "the State of " who                                                                                                  \
      " must be an aggregate that lists every member once in fields(), as Params do; see trophic/population/state.hpp");   \
  static_assert(                                                                                                           \
      !Stateful<Policy> || only_state_members<StateOf<Policy>>(),                                                          \
      "the State of " who                                                                                                  \
      " may hold only what can be saved: numbers, enumerations, Ancestors, optionals of these, and vectors of numbers");   \
  static_assert(!Stateful<Policy> || has_no_mutable_member<StateOf<Policy>>(),                                             \
                "the State of " who " has a mutable member: only hooks and brains may change a state");                    \
  static_assert(!Stateful<Policy> || BornWithState<Policy>, who                                                            \
                " has a State, so it needs State born(const Individual& newborn, const State* parent, const State& body) " \
                "const: what a newborn starts with; see trophic/population/state.hpp");                                    \
  static_assert(CheckStateHooks<Policy>::ok);

}  // namespace detail

/// The State of a policy, or NoState.
template <class P>
using StateOf = typename detail::state_of<P>::type;

/// The policy type that applies to a species: the policy itself, unless its parameters differ by species.
template <class P>
using AnswersForSpecies = typename detail::answers_for_species<P>::type;

/// The policy that applies to a species: the policy itself, unless its parameters differ by species (rules/by_species.hpp).
template <class P>
[[nodiscard]] const AnswersForSpecies<P>& for_species(const P& policy, [[maybe_unused]] Species species) {
  if constexpr (std::same_as<AnswersForSpecies<P>, P>) {
    return policy;
  } else {
    return policy.of(species);
  }
}

namespace detail {

template <class P>
struct all_states_of {
  using type = std::span<const StateOf<P>>;
};
template <template <class...> class Whole, class... Ps>
requires MadeOfParts<Whole<Ps...>>
struct all_states_of<Whole<Ps...>> {
  using type = std::tuple<typename all_states_of<Ps>::type...>;
};

}  // namespace detail

/// The states of all bodies, as contract functions about the whole population get them: `std::span<const State>`, by body; for a
/// policy composed of parts (population/parts.hpp), a std::tuple with those of its parts.
template <class P>
using AllStates = typename detail::all_states_of<P>::type;

/// The state of one body; NoState for a policy without State, whose span is empty.
template <class State>
[[nodiscard]] const State& state_of_body(std::span<const State> states, BodyIndex body) {
  return states[body];
}
[[nodiscard]] inline const NoState& state_of_body(std::span<const NoState>, BodyIndex) {
  static constexpr NoState none;
  return none;
}

/// The states of one slot, by body. Empty for a policy without State.
template <class P>
class BodyStates {
 public:
  [[nodiscard]] const NoState& operator[](BodyIndex) const { return none_; }
  [[nodiscard]] NoState& operator[](BodyIndex) { return none_; }
  [[nodiscard]] std::span<const NoState> all() const { return {}; }

 private:
  NoState none_;
};

template <Stateful P>
class BodyStates<P> {
 public:
  using State = typename P::State;
  [[nodiscard]] const State& operator[](BodyIndex body) const { return states_[body]; }
  [[nodiscard]] State& operator[](BodyIndex body) { return states_[body]; }
  [[nodiscard]] std::span<const State> all() const { return states_; }
  void push_back(State state) { states_.push_back(std::move(state)); }

  /// Does nothing for a State that cannot be saved; this error is reported above.
  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (detail::SavableState<P>) archive(states_);
  }

 private:
  std::vector<State> states_;
};

/// The states of a policy composed of parts: those of each part.
template <template <class...> class Whole, class... Ps>
requires MadeOfParts<Whole<Ps...>>
class BodyStates<Whole<Ps...>> {
 public:
  template <std::size_t place>
  [[nodiscard]] const auto& part() const {
    return std::get<place>(parts_);
  }
  template <std::size_t place>
  [[nodiscard]] auto& part() {
    return std::get<place>(parts_);
  }
  [[nodiscard]] AllStates<Whole<Ps...>> all() const {
    return std::apply([](const auto&... parts) { return AllStates<Whole<Ps...>>{parts.all()...}; }, parts_);
  }

 private:
  std::tuple<BodyStates<Ps>...> parts_;
};

}  // namespace trophic
