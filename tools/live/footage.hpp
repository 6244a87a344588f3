// SPDX-License-Identifier: MIT
// A run as messages to its pages: its facts, then each tick's robots, events and poses.
#pragma once

#include <tools/live/live_server.hpp>
#include <tools/trophic/replay/director.hpp>
#include <trophic/io/recording_format.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/json.hpp>

namespace trophic::live {

/// A message to pages. Shared, as each page gets the same.
struct Message {
  enum class Kind { facts, events, tick, poses, state };
  Kind kind = Kind::state;
  std::string text;      ///< JSON; of poses the bytes of a block of a recording: docs/recording.md
  bool is_last = false;  ///< of the run's last tick, which even a slow page gets
};
using SharedMessage = std::shared_ptr<const Message>;

/// A tick as the run hands it over: copies, which another thread writes as messages.
struct TickSight {
  struct Moment {
    double time_s = 0.0;
    std::vector<Pose> roots;
    std::vector<double> angles_rad;  ///< `joints` of each robot; 0 for those that a smaller body lacks
    std::size_t joints = 0;
  };
  /// Robots whose own bodies were set down before a frame.
  struct SetDown {
    double time_s = 0.0;                                       ///< of the frame
    std::vector<std::shared_ptr<const RobotModel>> bodies;     ///< that are new; they are numbered from 0 in this order
    std::vector<std::pair<BodyIndex, std::size_t>> of_robots;  ///< robot, number of its body
  };
  double time_s = 0.0;
  std::int64_t tick = 0;
  std::vector<io::EventRow> events;
  std::vector<command::replay::Scene> scenes;  ///< of the catches among the events, in their order
  std::vector<io::AgentRow> rows;              ///< empty: only events are shown of this tick
  std::vector<bool> are_spare;                 ///< bodies without an individual
  std::vector<double> energy_J;                ///< of each body's individual; empty in a world without energy
  std::vector<double> stock_J;                 ///< of each species; empty in a world without energy
  std::vector<std::pair<std::string, std::vector<double>>> foods_J;  ///< of each food: its name, and in each cell of the floor
  std::vector<std::vector<double>> outputs;                          ///< of each body's brain; empty if it was not evaluated
  std::vector<Moment> frames;
  SetDown set_down;      ///< empty if all robots have one body
  bool is_last = false;  ///< of the run
};

/// Facts of a run that its ticks do not change.
struct RunFacts {
  command::LiveRun run;
  observe::RunDescription description;
  std::vector<std::string> species;
  std::optional<RobotModel> robot;
  Arena arena;
  observe::FrameTimes times;
  std::size_t robots = 0;
  std::size_t joints = 0;  ///< of the first frame
};

/// Frames a simulated second, as recordings have them.
inline constexpr double live_hz = 5.0;

[[nodiscard]] SharedMessage facts_message(const RunFacts& facts);
/// The messages of a tick: bodies, poses, events, robots.
[[nodiscard]] std::vector<SharedMessage> tick_messages(const TickSight& sight, const RunFacts& facts);
[[nodiscard]] SharedMessage message_of(const Json& json, Message::Kind kind = Message::Kind::state);

}  // namespace trophic::live
