// SPDX-License-Identifier: MIT
// The observers of a run, as an ecology calls them.
#pragma once

#include <trophic/observe/decision_record.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/hooks.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// Observers of any type: ecologies are compiled once, not for every set of observers. See trophic/observe/hooks.hpp for the
/// meaning of each function.
class Audience {
 public:
  Audience() = default;
  Audience(const Audience&) = delete;
  Audience& operator=(const Audience&) = delete;
  virtual ~Audience() = default;

  virtual void start(const RunDescription& run, const View& view) = 0;
  virtual void event(const Event& event, const View& view) = 0;
  virtual void change(const RunDescription& run, const View& view) = 0;
  virtual void tick(const View& view) = 0;
  virtual void between_ticks(Simulation& simulation, bool last) = 0;
  virtual void end(const View& view) = 0;
  virtual void failure(std::string_view what) = 0;
  [[nodiscard]] virtual bool keep_running() = 0;

  /// Whether an observer may cancel a tick, so that the state before it must be saved.
  [[nodiscard]] virtual bool may_cancel() const = 0;
  [[nodiscard]] virtual bool cancels_tick() = 0;

  /// Whether an observer wants decision records.
  [[nodiscard]] virtual bool wants_decisions() = 0;
  virtual void decision(const DecisionRecord& decision, const View& view) = 0;
  virtual void exemption(BodyIndex hunter, const View& view) = 0;

  /// The first control step of a tick after `step` at which an observer wants a frame, at the latest the tick's last step.
  [[nodiscard]] virtual std::int64_t next_frame(const FrameTimes& times, std::int64_t step) = 0;
  [[nodiscard]] virtual bool wants_frame(const FrameTimes& times, std::int64_t step) = 0;
  /// Passes the frame after `step` to the observers that want it.
  virtual void frame(const Frame& frame, std::int64_t step) = 0;
};

/// Calls these observers in order. Holds references to them and must not outlive them.
template <class... Observers>
class AudienceOf final : public Audience {
 public:
  static_assert((Observer<Observers> && ...));
  explicit AudienceOf(Observers&... observers) : observers_{observers...} {}

  void start(const RunDescription& run, const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_start(run, view); }) o.on_start(run, view);
    });
  }
  void event(const Event& event, const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_event(event, view); }) o.on_event(event, view);
    });
  }
  void change(const RunDescription& run, const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_change(run, view); }) o.on_change(run, view);
    });
  }
  void tick(const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_tick(view); }) o.on_tick(view);
    });
  }
  void between_ticks(Simulation& simulation, bool last) override {
    each([&](auto& o) {
      if constexpr (requires { o.between_ticks(simulation, last); }) o.between_ticks(simulation, last);
    });
  }
  void end(const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_end(view); }) o.on_end(view);
    });
  }
  void failure(std::string_view what) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_failure(what); }) o.on_failure(what);
    });
  }
  [[nodiscard]] bool keep_running() override {
    bool all = true;
    each([&](auto& o) {
      if constexpr (requires { o.keep_running(); }) all = o.keep_running() && all;
    });
    return all;
  }
  [[nodiscard]] bool may_cancel() const override { return (detail::Takes_cancels_tick<Observers> || ...); }
  [[nodiscard]] bool cancels_tick() override {
    bool any = false;
    each([&](auto& o) {
      if constexpr (requires { o.cancels_tick(); }) any = o.cancels_tick() || any;
    });
    return any;
  }
  [[nodiscard]] bool wants_decisions() override {
    bool any = false;
    each([&](auto& o) {
      if constexpr (requires { o.wants_decisions(); }) any = o.wants_decisions() || any;
    });
    return any;
  }
  void decision(const DecisionRecord& decision, const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.wants_decisions(); }) {
        if (o.wants_decisions()) o.on_decision(decision, view);
      }
    });
  }
  void exemption(BodyIndex hunter, const View& view) override {
    each([&](auto& o) {
      if constexpr (requires { o.on_exemption(hunter, view); }) o.on_exemption(hunter, view);
    });
  }
  [[nodiscard]] std::int64_t next_frame(const FrameTimes& times, std::int64_t step) override {
    std::int64_t next = times.steps;
    each_frame_hz([&](auto&, double hz) { next = std::min(next, times.next(step, hz)); });
    return next;
  }
  [[nodiscard]] bool wants_frame(const FrameTimes& times, std::int64_t step) override {
    bool any = false;
    each_frame_hz([&](auto&, double hz) { any = any || times.due(step, hz); });
    return any;
  }
  void frame(const Frame& frame, std::int64_t step) override {
    each_frame_hz([&](auto& o, double hz) {
      if (frame.times.due(step, hz)) o.on_frame(frame);
    });
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
