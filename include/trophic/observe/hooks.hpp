// SPDX-License-Identifier: MIT
// The hooks that an observer may have: any subset, each checked for its signature.
#pragma once

#include <trophic/observe/decision_record.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <type_traits>

/// Every hook: (name, required signature, arguments of the call).
#define TROPHIC_OBSERVER_HOOKS(HOOK)                                                                                             \
  HOOK(on_start, "void on_start(const observe::RunDescription&, const View&)", std::declval<const RunDescription&>(),            \
       std::declval<const View&>())                                                                                              \
  HOOK(on_event, "void on_event(const observe::Event&, const View&)", std::declval<const Event&>(), std::declval<const View&>()) \
  HOOK(on_change, "void on_change(const observe::RunDescription&, const View&)", std::declval<const RunDescription&>(),          \
       std::declval<const View&>())                                                                                              \
  HOOK(on_tick, "void on_tick(const View&)", std::declval<const View&>())                                                        \
  HOOK(on_end, "void on_end(const View&)", std::declval<const View&>())                                                          \
  HOOK(on_failure, "void on_failure(std::string_view what)", std::declval<std::string_view>())                                   \
  HOOK(keep_running, "bool keep_running()")                                                                                      \
  HOOK(cancels_tick, "bool cancels_tick()")                                                                                      \
  HOOK(on_decision, "void on_decision(const observe::DecisionRecord&, const View&)", std::declval<const DecisionRecord&>(),      \
       std::declval<const View&>())                                                                                              \
  HOOK(wants_decisions, "bool wants_decisions()")                                                                                \
  HOOK(on_exemption, "void on_exemption(BodyIndex, const View&)", BodyIndex{}, std::declval<const View&>())                      \
  HOOK(between_ticks, "void between_ticks(Simulation&, bool last)", std::declval<Simulation&>(), true)                           \
  HOOK(on_frame, "void on_frame(const observe::Frame&)", std::declval<const Frame&>())                                           \
  HOOK(frame_hz, "double frame_hz()")

namespace trophic {
class Simulation;
}

namespace trophic::observe {

namespace detail {

// Probed in place of a final class, which cannot be inherited and is rejected by CheckObserver.
struct NotProbed {};

// A name is ambiguous in a class that inherits it twice: `&Probe::on_tick` is ill-formed exactly if Observer has any on_tick.
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

/// Fails to compile with one message if a hook has a wrong signature or if there is no hook.
template <class Observer>
struct CheckObserver {
  static_assert(!std::is_final_v<Observer>,
                "an observer must not be final: the signatures of its hooks could not be checked; see "
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
                "an observer with on_frame needs double frame_hz(), and one with frame_hz needs on_frame; see "
                "trophic/observe/hooks.hpp");
  static_assert(Names_on_decision<Observer> == Names_wants_decisions<Observer>,
                "an observer with on_decision needs bool wants_decisions(), and one with "
                "wants_decisions needs on_decision; see trophic/observe/hooks.hpp");
  static constexpr bool ok = true;
};

}  // namespace detail

/// An object that observes a run through any subset of the hooks:
///   void on_start(const RunDescription&, const View&)      before the first event of a call of run_until
///   void on_event(const Event&, const View&)               births, activations, tag switches, catches, deaths, in order
///   void on_change(const RunDescription&, const View&)     between two ticks, after parameters took other values, which
///                                                          the description's changes end with
///   void on_tick(const View&)                              after the rules of each tick
///   void on_end(const View&)                               after the last tick
///   void on_failure(std::string_view what)                 instead of on_end, if the simulation or an observer threw
///   bool keep_running()                                    called after each tick; false ends the run early, cleanly
///   bool cancels_tick()                                    called between the control steps of a tick, which may take
///                                                          seconds; true ends the run in its state after the tick before
///   void on_frame(const Frame&)                            the poses of all bodies: at the start, before the rules of each
///                                                          tick, and at the rate of frame_hz in between
///   double frame_hz()                                      frames per simulated second; 0: never
///   void on_decision(const DecisionRecord&, const View&)   inputs, outputs and decision of each brain, robot by robot
///   bool wants_decisions()                                 whether on_decision is called
///   void on_exemption(BodyIndex, const View&)              a hunter that is exempt from starving, once or more in a
///                                                          starvation procedure
///   void between_ticks(Simulation&, bool last)             for observers that save the run: after on_tick of each tick, and
///                                                          once more, with last = true, before on_end
template <class O>
concept Observer = detail::CheckObserver<O>::ok;

}  // namespace trophic::observe
