// SPDX-License-Identifier: MIT
// What an observer may offer: any subset of these hooks, each checked for its signature.
#pragma once

#include <string_view>
#include <trophic/observe/event.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <tuple>
#include <type_traits>
#include <utility>

/// Every hook: (name, what it needs to look like, the arguments it is called with).
#define TROPHIC_OBSERVER_HOOKS(HOOK)                                                                                             \
  HOOK(on_start, "void on_start(const observe::RunDescription&, const View&)", std::declval<const RunDescription&>(),            \
       std::declval<const View&>())                                                                                              \
  HOOK(on_event, "void on_event(const observe::Event&, const View&)", std::declval<const Event&>(), std::declval<const View&>()) \
  HOOK(on_tick, "void on_tick(const View&)", std::declval<const View&>())                                                        \
  HOOK(on_end, "void on_end(const View&)", std::declval<const View&>())                                                          \
  HOOK(on_failure, "void on_failure(std::string_view what)", std::declval<std::string_view>())                                   \
  HOOK(keep_running, "bool keep_running()")

namespace trophic::observe {

namespace detail {

// What is probed in the place of a final class, which nobody inherits and CheckObserver refuses.
struct NotProbed {};

// A name is ambiguous in a class that inherits it twice: so `&Probe::on_tick` is ill-formed exactly if Observer has an on_tick of
// any kind.
#define TROPHIC_PROBE(hook, signature, ...)                                                                \
  struct Has_##hook {                                                                                      \
    int hook;                                                                                              \
  };                                                                                                       \
  template <class Observer>                                                                                \
  struct Probe_##hook : std::conditional_t<std::is_final_v<Observer>, NotProbed, Observer>, Has_##hook {}; \
  template <class Observer>                                                                                \
  concept Names_##hook = !requires {                                                                       \
    &Probe_##hook<Observer>::hook;                                                                         \
  };                                                                                                       \
  template <class Observer>                                                                                \
  concept Takes_##hook = requires(Observer & observer) {                                                   \
    observer.hook(__VA_ARGS__);                                                                            \
  };
TROPHIC_OBSERVER_HOOKS(TROPHIC_PROBE)
#undef TROPHIC_PROBE

/// Fails to compile, with one sentence, if a hook has a wrong signature or if there is none at all.
template <class Observer>
struct CheckObserver {
  static_assert(!std::is_final_v<Observer>,
                "an observer must not be final: whether its hooks have the right signatures could not be told; see "
                "trophic/observe/hooks.hpp");
#define TROPHIC_CHECK_HOOK(hook, signature, ...)                   \
  static_assert(!Names_##hook<Observer> || Takes_##hook<Observer>, \
                "the observer's " #hook " must be callable as " signature "; see trophic/observe/hooks.hpp");
  TROPHIC_OBSERVER_HOOKS(TROPHIC_CHECK_HOOK)
#undef TROPHIC_CHECK_HOOK
#define TROPHIC_ANY_HOOK(hook, signature, ...) || Names_##hook<Observer>
  static_assert(std::is_final_v<Observer> TROPHIC_OBSERVER_HOOKS(TROPHIC_ANY_HOOK),
                "an observer needs at least one hook; see trophic/observe/hooks.hpp");
#undef TROPHIC_ANY_HOOK
  static constexpr bool ok = true;
};

}  // namespace detail

/// An object that watches a run through any subset of the hooks:
///   void on_start(const RunDescription&, const View&)   before the first event of a call of run_until
///   void on_event(const Event&, const View&) births, activations, tag switches, catches, deaths, in order
///   void on_tick(const View&)                after the rules of each tick
///   void on_end(const View&)                 after the last tick
///   void on_failure(std::string_view what)   instead of on_end, when the simulation or an observer threw
///   bool keep_running()                      asked after each tick; false ends the run early, cleanly
template <class O>
concept Observer = detail::CheckObserver<O>::ok;

/// Several observers told of everything in order. Refers to them; lives no longer than they do.
template <class... Observers>
class Audience {
 public:
  static_assert((Observer<Observers> && ...));
  explicit Audience(Observers&... observers) : observers_{observers...} {}

  void start(const RunDescription& run, const View& view) {
    each([&](auto& o) {
      if constexpr (requires { o.on_start(run, view); }) o.on_start(run, view);
    });
  }
  void event(const Event& event, const View& view) {
    each([&](auto& o) {
      if constexpr (requires { o.on_event(event, view); }) o.on_event(event, view);
    });
  }
  void tick(const View& view) {
    each([&](auto& o) {
      if constexpr (requires { o.on_tick(view); }) o.on_tick(view);
    });
  }
  void end(const View& view) {
    each([&](auto& o) {
      if constexpr (requires { o.on_end(view); }) o.on_end(view);
    });
  }
  void failure(std::string_view what) {
    each([&](auto& o) {
      if constexpr (requires { o.on_failure(what); }) o.on_failure(what);
    });
  }
  [[nodiscard]] bool keep_running() {
    bool all = true;
    each([&](auto& o) {
      if constexpr (requires { o.keep_running(); }) all = o.keep_running() && all;
    });
    return all;
  }

 private:
  template <class Call>
  void each(Call&& call) {
    std::apply([&](auto&... o) { (call(o), ...); }, observers_);
  }

  std::tuple<Observers&...> observers_;
};

}  // namespace trophic::observe
