// SPDX-License-Identifier: MIT
// What an observer may offer: any subset of these hooks, each checked for its signature.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <trophic/observe/deliberation.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
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
  HOOK(keep_running, "bool keep_running()")                                                                                      \
  HOOK(gives_up_tick, "bool gives_up_tick()")                                                                                    \
  HOOK(on_deliberation, "void on_deliberation(const observe::Deliberation&, const View&)", std::declval<const Deliberation&>(),  \
       std::declval<const View&>())                                                                                              \
  HOOK(wants_deliberations, "bool wants_deliberations()")                                                                        \
  HOOK(on_reprieve, "void on_reprieve(BodyIndex, const View&)", BodyIndex{}, std::declval<const View&>())                        \
  HOOK(on_frame, "void on_frame(const observe::Frame&)", std::declval<const Frame&>())                                           \
  HOOK(frame_hz, "double frame_hz()")

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
  static_assert(Names_on_frame<Observer> == Names_frame_hz<Observer>,
                "an observer with on_frame needs double frame_hz(), how often, and one with frame_hz needs on_frame; see "
                "trophic/observe/hooks.hpp");
  static_assert(Names_on_deliberation<Observer> == Names_wants_deliberations<Observer>,
                "an observer with on_deliberation needs bool wants_deliberations(), whether it is to be told now, and one with "
                "wants_deliberations needs on_deliberation; see trophic/observe/hooks.hpp");
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
///   bool gives_up_tick()                     asked between the control steps of a tick, which may take seconds; true ends
///                                            the run as it stood after the tick before
///   void on_frame(const Frame&)              where the bodies are, at the start and then before the rules of each tick and,
///   double frame_hz()                        frames a simulated second, between two ticks; 0: never
///   void on_deliberation(const Deliberation&, const View&)   what each brain was told and answered, robot by robot,
///   bool wants_deliberations()               as long as this says true
///   void on_reprieve(BodyIndex, const View&) whom the Reprieve rule spared from starving, once or more often in a procedure
/// Who saves the run itself also has a template
///   void between_ticks(Ecology&, bool last)  after on_tick of each tick, and once more, as the last, before on_end
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
  /// Whether somebody wants to know what brains are told and answer.
  [[nodiscard]] bool wants_deliberations() {
    bool any = false;
    each([&](auto& o) {
      if constexpr (requires { o.wants_deliberations(); }) any = o.wants_deliberations() || any;
    });
    return any;
  }
  void deliberation(const Deliberation& deliberation, const View& view) {
    each([&](auto& o) {
      if constexpr (requires { o.wants_deliberations(); }) {
        if (o.wants_deliberations()) o.on_deliberation(deliberation, view);
      }
    });
  }
  void reprieve(BodyIndex hunter, const View& view) {
    each([&](auto& o) {
      if constexpr (requires { o.on_reprieve(hunter, view); }) o.on_reprieve(hunter, view);
    });
  }
  template <class Ecology>
  void between_ticks(Ecology& ecology, bool last) {
    each([&](auto& o) {
      if constexpr (requires { o.between_ticks(ecology, last); }) o.between_ticks(ecology, last);
    });
  }
  /// The first control step of a tick after `step` after which an observer wants a frame; the tick's last at the latest.
  [[nodiscard]] std::int64_t next_frame(const FrameTimes& times, std::int64_t step) {
    std::int64_t next = times.steps;
    each_frame_hz([&](auto&, double hz) { next = std::min(next, times.next(step, hz)); });
    return next;
  }
  [[nodiscard]] bool wants_frame(const FrameTimes& times, std::int64_t step) {
    bool any = false;
    each_frame_hz([&](auto&, double hz) { any = any || times.due(step, hz); });
    return any;
  }
  /// Shows the frame after `step` to those that want it.
  void frame(const Frame& frame, std::int64_t step) {
    each_frame_hz([&](auto& o, double hz) {
      if (frame.times.due(step, hz)) o.on_frame(frame);
    });
  }
  [[nodiscard]] bool keep_running() {
    bool all = true;
    each([&](auto& o) {
      if constexpr (requires { o.keep_running(); }) all = o.keep_running() && all;
    });
    return all;
  }
  /// Whether somebody may give up a tick, so that the state before it must be kept.
  static constexpr bool may_give_up = (detail::Takes_gives_up_tick<Observers> || ...);
  [[nodiscard]] bool gives_up_tick() {
    bool any = false;
    each([&](auto& o) {
      if constexpr (requires { o.gives_up_tick(); }) any = o.gives_up_tick() || any;
    });
    return any;
  }

 private:
  template <class Call>
  void each(Call&& call) {
    std::apply([&](auto&... o) { (call(o), ...); }, observers_);
  }

  template <class Call>
  void each_frame_hz(Call&& call) {
    each([&](auto& o) {
      if constexpr (requires { o.frame_hz(); }) call(o, o.frame_hz());
    });
  }

  std::tuple<Observers&...> observers_;
};

}  // namespace trophic::observe
