// SPDX-License-Identifier: MIT
// Rules with a state: what a policy keeps for each body, what a newborn starts with, and when it changes.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/sighting.hpp>
#include <trophic/population/view.hpp>
#include <type_traits>
#include <utility>
#include <vector>

/// A rule with a state is a policy with a nested `struct State { ... };` that lists its members by `fields()` as Params do. The
/// population keeps one State for each body and slot. Policies stay const: the population hands a policy its own state.
///
///   State born(const Individual& newborn, const State* parent, const State& body) const
///
/// is what a newborn starts with; a policy with a State must have it. The newborn has no genome yet. `parent` is the state of its
/// living parent; null for founders, random newcomers, offspring of the dead and where Heredity passes nothing on. `body` is the
/// state of the body's last owner; State{} for founders. `return {};` resets it, `return body;` keeps it with the body,
/// `return parent ? *parent : State{};` inherits it.
///
/// A checkpoint holds all states, so that a run goes on as if it had not been cut off: that is why a State may hold no more than
/// what rule_states.hpp allows.
///
/// The question of a slot that is about one body may take `const State& own` as its last argument, one about the whole population
/// `std::span<const State> states`, by body: see the slot's contract. A brain's decide takes `State& own`.
///
/// Any of these hooks changes the state `own` of whoever lives in the body `self`; each is called where it stands in a tick:
///   void on_walk(State& own, BodyIndex self, double distance_m, const View&) const
///     after the bodies have moved: the straight distance between the places at this tick and the last
///   void on_catch(State& own, BodyIndex self, BodyIndex victim, const View&) const
///     self catches victim, which is still in the view
///   void on_caught(State& own, BodyIndex self, BodyIndex hunter, const View&) const
///     self is caught and still in the view
///   void on_sighting(State& own, BodyIndex self, const std::optional<Sighting>& sighting, const View&) const
///     after perception: the adversary, if self perceives one
#define TROPHIC_STATE_HOOKS(HOOK)                                                          \
  HOOK(on_walk, double, "void on_walk(State&, BodyIndex, double distance_m, const View&)") \
  HOOK(on_catch, BodyIndex, "void on_catch(State&, BodyIndex, BodyIndex, const View&)")    \
  HOOK(on_caught, BodyIndex, "void on_caught(State&, BodyIndex, BodyIndex, const View&)")  \
  HOOK(on_sighting, const std::optional<Sighting>&,                                        \
       "void on_sighting(State&, BodyIndex, const std::optional<Sighting>&, const View&)")

/// Defines `ask::question(policy, own, arguments...)`: `policy.question(arguments..., own)` where the policy takes its state,
/// else `policy.question(arguments...)`. A contract's concept and whoever asks go through it.
#define TROPHIC_QUESTION(question)                                                                               \
  namespace ask {                                                                                                \
  template <class P, class... Arguments>                                                                         \
  concept takes_##question = requires(const P& policy, Arguments&... arguments) {                                \
    policy.question(arguments...);                                                                               \
  };                                                                                                             \
  template <class P, class Own, class... Arguments>                                                              \
  requires(takes_##question<P, Arguments..., Own> || takes_##question<P, Arguments...>) constexpr decltype(auto) \
      question(const P& policy, [[maybe_unused]] Own& own, Arguments&&... arguments) {                           \
    if constexpr (takes_##question<P, Arguments..., Own>) {                                                      \
      return policy.question(arguments..., own);                                                                 \
    } else {                                                                                                     \
      return policy.question(arguments...);                                                                      \
    }                                                                                                            \
  }                                                                                                              \
  }

namespace trophic {

/// A policy that keeps something for each body.
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

/// Whether every listed member, nested ones included, can be written down.
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

// A name is ambiguous in a class that inherits it twice: so `&Probe::on_walk` is ill-formed exactly if the policy has an on_walk
// of any kind.
#define TROPHIC_PROBE_HOOK(hook, Happened, signature)                                                                            \
  struct StateHas_##hook {                                                                                                       \
    int hook;                                                                                                                    \
  };                                                                                                                             \
  template <class P>                                                                                                             \
  struct StateProbe_##hook : P, StateHas_##hook {};                                                                              \
  template <class P>                                                                                                             \
  concept StateNames_##hook = !std::is_final_v<P> && !requires {                                                                 \
    &StateProbe_##hook<P>::hook;                                                                                                 \
  };                                                                                                                             \
  template <class P>                                                                                                             \
  concept StateTakes_##hook = Stateful<P>&& requires(const P& policy, typename P::State& own, Happened what, const View& view) { \
    policy.hook(own, BodyIndex{}, what, view);                                                                                   \
  };
TROPHIC_STATE_HOOKS(TROPHIC_PROBE_HOOK)
#undef TROPHIC_PROBE_HOOK

/// A policy with a State can tell what a newborn starts with.
template <class P>
concept BornWithState = requires(const P& policy, const Individual& newborn, const typename P::State* parent,
                                 const typename P::State& body) {
  { policy.born(newborn, parent, body) } -> std::same_as<typename P::State>;
};

/// Fails to compile, with one sentence, if a policy names hooks that nobody would call.
template <class Policy>
struct CheckStateHooks {
#define TROPHIC_CHECK_STATE_HOOK(hook, Happened, signature)                                                  \
  static_assert(!StateNames_##hook<Policy> || Stateful<Policy>, "a policy has " #hook                        \
                                                                " but no State, so it would never be "       \
                                                                "called; see trophic/population/state.hpp"); \
  static_assert(!StateNames_##hook<Policy> || !Stateful<Policy> || StateTakes_##hook<Policy>,                \
                "a policy's " #hook " must be callable as " signature " const; see trophic/population/state.hpp");
  TROPHIC_STATE_HOOKS(TROPHIC_CHECK_STATE_HOOK)
#undef TROPHIC_CHECK_STATE_HOOK
  static constexpr bool ok = true;
};

/// In a struct: fails to compile, with one sentence about `who`, if a policy's State is not what is asked for above.
#define TROPHIC_CHECK_STATE_OF(Policy, who)                                                                                   \
  static_assert(                                                                                                              \
      !Stateful<Policy> ||                                                                                                    \
          (Parameters<StateOf<Policy>> && OpenParams<StateOf<Policy>> &&                                                      \
           AllListed<members_of<StateOf<Policy>>, fields_of<StateOf<Policy>>> && listed_once<StateOf<Policy>>()),             \
      "the State of " who                                                                                                     \
      " must be an aggregate that lists every member once in fields(), as Params do; see trophic/population/state.hpp");      \
  static_assert(!Stateful<Policy> || only_state_members<StateOf<Policy>>(),                                                   \
                "the State of " who                                                                                           \
                " may hold numbers, enumerations, Ancestors, each also optional, and vectors of numbers: what can be saved"); \
  static_assert(!Stateful<Policy> || BornWithState<Policy>, who                                                               \
                " has a State, so it needs State born(const Individual& newborn, const State* parent, const State& body) "    \
                "const: what a newborn starts with; see trophic/population/state.hpp");                                       \
  static_assert(CheckStateHooks<Policy>::ok);

}  // namespace detail

/// What a policy keeps for each body: its nested State, or nothing.
template <class P>
using StateOf = typename detail::state_of<P>::type;

/// The states of one slot, by body. Nothing at all for a policy without State.
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

  /// Nothing of a State that cannot be saved: that has been reported above.
  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (detail::SavableState<P>) archive(states_);
  }

 private:
  std::vector<State> states_;
};

}  // namespace trophic
