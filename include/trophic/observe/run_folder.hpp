// SPDX-License-Identifier: MIT
// A folder with everything that a run leaves behind.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <trophic/observe/agent_log.hpp>
#include <trophic/observe/event_log.hpp>
#include <trophic/observe/genome_log.hpp>
#include <trophic/observe/manifest.hpp>
#include <trophic/observe/phylogeny.hpp>
#include <utility>

namespace trophic::observe {

/// A new folder. Throws std::invalid_argument if something of that name exists, std::runtime_error if it cannot be made.
[[nodiscard]] inline std::filesystem::path make_new_folder(const std::filesystem::path& path) {
  if (std::filesystem::exists(std::filesystem::symlink_status(path))) {
    throw std::invalid_argument{"output folder " + path.string() + ": exists already; runs are never overwritten"};
  }
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error{"output folder " + path.string() + ": cannot be made: " + error.message()};
  return path;
}

/// events.csv, agents.csv, phylogeny.csv, genomes.csv and manifest.json in a new folder. Files are flushed at every tick, so that
/// a crash keeps what happened before it; the manifest says how the run ended. Watches one call of run_until.
class RunFolder {
 public:
  /// Makes the folder at once: see make_new_folder.
  explicit RunFolder(const std::filesystem::path& path, Facts facts = {})
      : path_{make_new_folder(path)},
        events_{path_ / "events.csv"},
        agents_{path_ / "agents.csv"},
        phylogeny_{path_ / "phylogeny.csv"},
        genomes_{path_ / "genomes.csv"},
        manifest_{path_ / "manifest.json", std::move(facts)} {}

  void on_start(const Run& run, const View& view) { manifest_.on_start(run, view); }
  void on_event(const Event& event, const View& view) {
    events_.on_event(event, view);
    phylogeny_.on_event(event, view);
    genomes_.on_event(event, view);
    manifest_.on_event(event, view);
  }
  void on_tick(const View& view) {
    events_.on_tick(view);
    agents_.on_tick(view);
    phylogeny_.on_tick(view);
    genomes_.on_tick(view);
    manifest_.on_tick(view);
  }
  void on_end(const View& view) {
    events_.on_end(view);
    phylogeny_.on_end(view);
    manifest_.on_end(view);
  }
  void on_failure(std::string_view what) { manifest_.on_failure(what); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] Manifest& manifest() { return manifest_; }

 private:
  std::filesystem::path path_;
  EventLog events_;
  AgentLog agents_;
  Phylogeny phylogeny_;
  GenomeLog genomes_;
  Manifest manifest_;
};

}  // namespace trophic::observe
