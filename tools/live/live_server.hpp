// SPDX-License-Identifier: MIT
// `--live`: a run that a page in a browser shows and steers while it runs, where trophic was built with Boost and the page.
#pragma once

#include <tools/changes/change.hpp>
#include <tools/changes/changing_simulation.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/run/checkpoint/resume.hpp>

namespace trophic::command {

/// Facts of a run that a page shows.
struct LiveRun {
  std::filesystem::path folder;
  std::string rule_table;
  std::vector<std::string> rule_tables;  ///< that the program offers
  std::uint64_t seed = 0;
  double until_s = 0.0;
  NamedParams numbers;     ///< that may change: those of rules
  NamedParams table = {};  ///< the same with the rule table's own values
};

/// A run that a page asks for instead of the present one.
struct Restart {
  std::uint64_t seed = 0;
  std::string rule_table;
  std::vector<observe::ParameterChange> made;  ///< changes of the run before
};

/// A server of pages on this machine.
class LiveServer {
 public:
  LiveServer() = default;
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;
  virtual ~LiveServer() = default;

  /// As checkpoint::run_with_checkpoints, with the pages as an observer.
  virtual void run_with_checkpoints(Simulation& ecology, double until_s, const std::filesystem::path& folder,
                                    const checkpoint::Schedule& schedule, const std::optional<checkpoint::Checkpoint>& from,
                                    io::RunFolder& files, observe::Progress& progress, const replicates::StopOnSignal& stop) = 0;
  /// The run that is shown ended with an error, or the next one could not begin.
  virtual void failed(const std::string& why) = 0;
  /// Shows another run from now on.
  virtual void begin(const LiveRun& run) = 0;
  [[nodiscard]] virtual changes::Conductor& conductor() = 0;
  /// After a run: waits until a page asks for another one; `nullopt` once all pages are closed, or if a signal came.
  [[nodiscard]] virtual std::optional<Restart> next() = 0;
};

}  // namespace trophic::command

namespace trophic::live {

/// Starts a server on a port of this machine, 0 for one that is free, and prints the address of its page. Throws
/// std::invalid_argument if it cannot.
[[nodiscard]] std::unique_ptr<command::LiveServer> open(std::uint16_t port);

}  // namespace trophic::live
