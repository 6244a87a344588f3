// SPDX-License-Identifier: MIT
// The observer that passes the events of a run to a window. It draws nothing and changes nothing.
#pragma once

#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>

namespace trophic::watch {

class Exchange;

/// Between two ticks it may pause the run until the viewer wants to see more of it. Must not outlive its exchange.
class Spectator {
 public:
  /// Frames a simulated second; in between, robots move straight.
  static constexpr double watched_hz = 10.0;

  Spectator() = default;  ///< without a window
  explicit Spectator(Exchange& exchange) : exchange_{&exchange} {}

  [[nodiscard]] double frame_hz() const;
  void on_start(const observe::RunDescription& run, const View& view);
  void on_frame(const observe::Frame& frame);
  void on_event(const observe::Event& event, const View& view);
  void on_tick(const View& view);

 private:
  [[nodiscard]] bool is_heard() const;

  Exchange* exchange_ = nullptr;
};

}  // namespace trophic::watch
