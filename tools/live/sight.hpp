// SPDX-License-Identifier: MIT
// The observer that hands a run over to its pages. It draws nothing and changes nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <tools/live/footage.hpp>
#include <tools/live/server.hpp>
#include <tools/live/steering.hpp>
#include <trophic/observe/progress.hpp>
#include <vector>

namespace trophic::live {

/// A tick is handed over with robots and poses if ticks come at a speed that people chose, or `least_gap_s` after the last one:
/// faster ones cannot be seen, and copies of them would slow the run. The last tick is handed over in any case, as are all
/// events.
class Sight {
 public:
  static constexpr double least_gap_s = 0.004;

  Sight(Server& server, Steering& steering) : server_{server}, steering_{steering} {}

  void begin(const command::LiveRun& run);

  [[nodiscard]] double frame_hz() const { return is_full_ ? live_hz : 0.0; }
  void on_start(const observe::RunDescription& run, const View& view);
  void on_change(const observe::RunDescription& run, const View& view);
  void on_frame(const observe::Frame& frame);
  void on_event(const observe::Event& event, const View& view);
  [[nodiscard]] bool wants_decisions() const { return is_full_; }
  void on_decision(const observe::DecisionRecord& record, const View& view);
  void on_tick(const View& view);

 private:
  /// Notes the bodies that were set down since the last frame.
  void see_bodies(const observe::Frame& frame);
  /// The path of a robot since a moment, as far as frames showed it.
  [[nodiscard]] command::replay::Track track_of(std::size_t body, double from_s, const View& view) const;

  Server& server_;
  Steering& steering_;
  std::vector<std::uint64_t> individuals_;     ///< whose bodies the last frame showed, if bodies differ
  std::map<std::string, std::size_t> bodies_;  ///< hashes of bodies, and their numbers
  std::shared_ptr<RunFacts> facts_;
  std::shared_ptr<TickSight> sight_;
  std::deque<std::pair<double, std::vector<Eigen::Vector3d>>> seen_;  ///< moments, and places of robots, as long as scenes last
  observe::Stopwatch watch_;
  double last_full_s_ = 0.0;
  bool is_full_ = true;
};

}  // namespace trophic::live
