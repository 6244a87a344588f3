// SPDX-License-Identifier: MIT
// A folder with everything that a run leaves behind.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
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
#include <utility>
#include <vector>

namespace trophic::io {

/// Throws std::invalid_argument if there is anything of that name.
void check_new_folder(const std::filesystem::path& path);

/// A new folder. Throws std::invalid_argument if something of that name exists, std::runtime_error if it cannot be made.
[[nodiscard]] std::filesystem::path make_new_folder(const std::filesystem::path& path);

/// How much of a run is written down.
struct OutputOptions {
  double replay_hz = default_replay_hz;  ///< frames of the recording in a simulated second; 0: no recording
  std::int64_t agents_every_ticks = 1;   ///< agents.csv has the ticks whose number is a multiple of it
  bool senses = false;                   ///< senses.csv too, at the ticks of agents.csv
  bool states = false;                   ///< states.csv too, at the ticks of agents.csv
  friend bool operator==(const OutputOptions&, const OutputOptions&) = default;
};

/// events.csv, agents.csv, phylogeny.csv, genomes.csv, manifest.json, the recording replay.trp and, where asked for, senses.csv
/// and states.csv in a new folder, with tables of one's own (own_table.hpp). Tables are flushed at every tick, so that a crash
/// keeps what happened before it; the manifest says how the run ended, and how many rows each table has. Watches one call of
/// run_until. No other program can go on in the folder meanwhile.
class RunFolder {
 public:
  static constexpr std::string_view section = "run_folder";  ///< of a checkpoint

  /// Makes the folder at once: see make_new_folder. The manifest says where agents.csv has not every tick, and with senses.csv
  /// names the brain's inputs. `states`: `ecology.state_columns()`, for states.csv.
  /// With `Opening::resumed` the folder is one that is there, and is to be read from a checkpoint next, to the extent to
  /// which it began; throws std::runtime_error if a file is missing or another program works in it.
  explicit RunFolder(const std::filesystem::path& path, Provenance provenance = {}, const OutputOptions& output = {},
                     Opening opening = Opening::created, StateColumns states = {}, const OwnTables& own_tables = {});
  RunFolder(RunFolder&&) noexcept;
  RunFolder& operator=(RunFolder&&) noexcept;
  ~RunFolder();

  void persist(Archive& archive);

  void on_start(const observe::RunDescription& run, const View& view);
  void on_event(const observe::Event& event, const View& view);
  void on_tick(const View& view);
  [[nodiscard]] bool wants_decisions();
  void on_decision(const observe::DecisionRecord& decision, const View& view);
  void on_exemption(BodyIndex hunter, const View& view);
  void on_frame(const observe::Frame& frame);
  [[nodiscard]] double frame_hz() const;
  void on_end(const View& view);
  void on_failure(std::string_view what);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The names of the files that a run leaves in it, a checkpoint aside.
  [[nodiscard]] std::vector<std::string> files() const;
  [[nodiscard]] Manifest& manifest() { return manifest_; }

 private:
  struct Tables;
  [[nodiscard]] std::vector<std::pair<std::string, TableSum>> sums() const;
  void open_more(bool senses, bool states, Opening opening);

  std::filesystem::path path_;
  FolderLock lock_;
  StateColumns states_;
  std::vector<std::unique_ptr<AnyOwnTable>> own_tables_;
  std::unique_ptr<Tables> tables_;
  Manifest manifest_;
  Recording recording_;
};

}  // namespace trophic::io

#if TROPHIC_HEADER_ONLY
#include <trophic/io/run_folder.ipp>
#endif
