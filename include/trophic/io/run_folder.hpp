// SPDX-License-Identifier: MIT
// A folder with all files of a run.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <trophic/io/growing_file.hpp>
#include <trophic/io/manifest.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/io/recording.hpp>
#include <trophic/io/state_log.hpp>
#include <trophic/observe/decision_record.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::io {

/// Thrown for an output folder that is there already, also if another program made it a moment ago.
struct FolderExists : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Throws FolderExists if the path exists.
inline void check_new_folder(const std::filesystem::path& path) {
  if (!std::filesystem::exists(std::filesystem::symlink_status(path))) return;
  throw FolderExists{"output folder " + path.string() + ": exists already; runs are never overwritten"};
}

/// Makes a new folder. Throws FolderExists if the path exists, std::runtime_error if it cannot be made.
[[nodiscard]] std::filesystem::path make_new_folder(const std::filesystem::path& path);

class AgentLog;
class SenseLog;

/// Optional output of a run.
struct OutputOptions {
  double replay_hz = default_replay_hz;  ///< recorded frames per simulated second; 0: no recording
  std::int64_t agents_every_ticks = 1;   ///< agents.csv has only ticks that are multiples of this
  bool senses = false;                   ///< also write senses.csv, at the ticks of agents.csv
  bool states = false;                   ///< also write states.csv, at the ticks of agents.csv
  friend bool operator==(const OutputOptions&, const OutputOptions&) = default;
};

/// events.csv, agents.csv, phylogeny.csv, genomes.csv, manifest.json, the recording replay.trp and, if requested, senses.csv
/// and states.csv in a new folder, with own tables (own_table.hpp). Tables are flushed at every tick, so a crash keeps the past
/// events; they are on the disk before the manifest has the run's end and the number of rows of each. Observes one call of
/// run_until. Meanwhile no other program can resume in the folder.
class RunFolder {
 public:
  static constexpr std::string_view section = "run_folder";  ///< name of its section in a checkpoint

  /// Makes the folder at once: see make_new_folder. The manifest has the interval of a thinned agents.csv and, with senses.csv,
  /// the names of the brain's inputs. `states`: `ecology.state_columns()`, for states.csv.
  /// With `Opening::resumed` the folder must exist; read it from a checkpoint next, with its original output options. Throws
  /// std::runtime_error if a file is missing or another program works in the folder.
  explicit RunFolder(const std::filesystem::path& path, Provenance provenance = {}, const OutputOptions& output = {},
                     Opening opening = Opening::created, StateColumns states = {}, const OwnTables& own_tables = {});

  void persist(Archive& archive);

  void on_start(const observe::RunDescription& run, const View& view);
  void on_event(const observe::Event& event, const View& view) {
    each([&](AnyOwnTable& table) { table.observer().event(event, view); });
    manifest_.on_event(event, view);
  }
  void on_change(const observe::RunDescription& run, const View& view) {
    each([&](AnyOwnTable& table) { table.observer().change(run, view); });
    manifest_.on_change(run, view);
  }
  void on_tick(const View& view) {
    each([&](AnyOwnTable& table) { table.observer().tick(view); });
    manifest_.on_tick(view);
  }
  [[nodiscard]] bool wants_decisions() {
    bool any = false;
    each([&](AnyOwnTable& table) { any = table.observer().wants_decisions() || any; });
    return any;
  }
  void on_decision(const observe::DecisionRecord& decision, const View& view) {
    each([&](AnyOwnTable& table) { table.observer().decision(decision, view); });
  }
  void on_exemption(BodyIndex hunter, const View& view) {
    each([&](AnyOwnTable& table) { table.observer().exemption(hunter, view); });
  }
  void on_frame(const observe::Frame& frame);
  [[nodiscard]] double frame_hz() const;
  void on_end(const View& view);
  void on_failure(std::string_view what) {
    each([&](AnyOwnTable& table) { table.observer().failure(what); });
    manifest_.set_tables(sums());
    manifest_.on_failure(what);
    recording_.on_failure(what);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The names of the run's files in the folder, without checkpoints.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    each([&](const AnyOwnTable& table) { names.push_back(table.file_name()); });
    names.emplace_back("manifest.json");
    if (recording_.frame_hz() > 0.0) names.emplace_back("replay.trp");
    return names;
  }
  [[nodiscard]] Manifest& manifest() { return manifest_; }

 private:
  struct Shipped;

  void open(std::string_view file_name, Opening opening);
  void each(auto&& call) const {
    for (const auto& table : tables_) {
      if (table) call(*table);
    }
  }
  [[nodiscard]] std::vector<std::pair<std::string, TableSum>> sums() const {
    std::vector<std::pair<std::string, TableSum>> all;
    each([&](const AnyOwnTable& table) { all.emplace_back(table.file_name(), table.sum()); });
    return all;
  }

  std::filesystem::path path_;
  FolderLock lock_;
  std::int64_t agents_every_ticks_ = 1;
  StateColumns states_;
  std::vector<std::unique_ptr<AnyOwnTable>> tables_;  ///< all shipped ones, null in a run without them; then own ones
  const AgentLog* agents_ = nullptr;
  SenseLog* senses_ = nullptr;
  Manifest manifest_;
  Recording recording_;
};

}  // namespace trophic::io

#if TROPHIC_HEADER_ONLY
#include <trophic/io/run_folder.ipp>
#endif
