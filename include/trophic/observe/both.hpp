// SPDX-License-Identifier: MIT
// Two audiences of one run.
#pragma once

#include <algorithm>
#include <trophic/observe/audience.hpp>

namespace trophic::observe {

/// Calls the first audience, then the second. Holds references to them and must not outlive them.
class Both final : public Audience {
 public:
  Both(Audience& first, Audience& second) : first_{first}, second_{second} {}

  void start(const RunDescription& run, const View& view) override {
    first_.start(run, view);
    second_.start(run, view);
  }
  void event(const Event& event, const View& view) override {
    first_.event(event, view);
    second_.event(event, view);
  }
  void change(const RunDescription& run, const View& view) override {
    first_.change(run, view);
    second_.change(run, view);
  }
  void tick(const View& view) override {
    first_.tick(view);
    second_.tick(view);
  }
  void between_ticks(Simulation& simulation, bool last) override {
    first_.between_ticks(simulation, last);
    second_.between_ticks(simulation, last);
  }
  void end(const View& view) override {
    first_.end(view);
    second_.end(view);
  }
  void failure(std::string_view what) override {
    first_.failure(what);
    second_.failure(what);
  }
  [[nodiscard]] bool keep_running() override {
    const bool first = first_.keep_running();
    return second_.keep_running() && first;
  }
  [[nodiscard]] bool may_cancel() const override { return first_.may_cancel() || second_.may_cancel(); }
  [[nodiscard]] bool cancels_tick() override {
    const bool first = first_.cancels_tick();
    return second_.cancels_tick() || first;
  }
  [[nodiscard]] bool wants_decisions() override {
    const bool first = first_.wants_decisions();
    return second_.wants_decisions() || first;
  }
  void decision(const DecisionRecord& decision, const View& view) override {
    first_.decision(decision, view);
    second_.decision(decision, view);
  }
  void exemption(BodyIndex hunter, const View& view) override {
    first_.exemption(hunter, view);
    second_.exemption(hunter, view);
  }
  [[nodiscard]] std::int64_t next_frame(const FrameTimes& times, std::int64_t step) override {
    return std::min(first_.next_frame(times, step), second_.next_frame(times, step));
  }
  [[nodiscard]] bool wants_frame(const FrameTimes& times, std::int64_t step) override {
    return first_.wants_frame(times, step) || second_.wants_frame(times, step);
  }
  void frame(const Frame& frame, std::int64_t step) override {
    first_.frame(frame, step);
    second_.frame(frame, step);
  }

 private:
  Audience& first_;
  Audience& second_;
};

}  // namespace trophic::observe
