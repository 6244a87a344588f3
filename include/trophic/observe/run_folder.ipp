// SPDX-License-Identifier: MIT
// Definitions of run_folder.hpp.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <trophic/observe/agent_log.hpp>
#include <trophic/observe/event_log.hpp>
#include <trophic/observe/genome_log.hpp>
#include <trophic/observe/phylogeny.hpp>
#include <trophic/observe/run_folder.hpp>
#include <utility>

namespace trophic::observe {

TROPHIC_INLINE std::filesystem::path make_new_folder(const std::filesystem::path& path) {
  if (std::filesystem::exists(std::filesystem::symlink_status(path))) {
    throw std::invalid_argument{"output folder " + path.string() + ": exists already; runs are never overwritten"};
  }
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error{"output folder " + path.string() + ": cannot be made: " + error.message()};
  return path;
}

struct RunFolder::Tables {
  EventLog events;
  AgentLog agents;
  Phylogeny phylogeny;
  GenomeLog genomes;
};

TROPHIC_INLINE RunFolder::RunFolder(const std::filesystem::path& path, Provenance provenance, double replay_hz)
    : path_{make_new_folder(path)},
      tables_{std::make_unique<Tables>(Tables{.events = EventLog{path_ / "events.csv"},
                                              .agents = AgentLog{path_ / "agents.csv"},
                                              .phylogeny = Phylogeny{path_ / "phylogeny.csv"},
                                              .genomes = GenomeLog{path_ / "genomes.csv"}})},
      manifest_{path_ / "manifest.json", std::move(provenance)},
      recording_{path_ / "replay.trp", replay_hz} {}
TROPHIC_INLINE RunFolder::RunFolder(RunFolder&&) noexcept = default;
TROPHIC_INLINE RunFolder& RunFolder::operator=(RunFolder&&) noexcept = default;
TROPHIC_INLINE RunFolder::~RunFolder() = default;

TROPHIC_INLINE void RunFolder::on_start(const RunDescription& run, const View& view) {
  manifest_.on_start(run, view);
  recording_.on_start(run, view);
}

TROPHIC_INLINE void RunFolder::on_event(const Event& event, const View& view) {
  tables_->events.on_event(event, view);
  tables_->phylogeny.on_event(event, view);
  tables_->genomes.on_event(event, view);
  manifest_.on_event(event, view);
}

TROPHIC_INLINE void RunFolder::on_tick(const View& view) {
  tables_->events.on_tick(view);
  tables_->agents.on_tick(view);
  tables_->phylogeny.on_tick(view);
  tables_->genomes.on_tick(view);
  manifest_.on_tick(view);
}

TROPHIC_INLINE void RunFolder::on_end(const View& view) {
  tables_->events.on_end(view);
  tables_->phylogeny.on_end(view);
  recording_.on_end(view);
  manifest_.on_end(view);
}

TROPHIC_INLINE void RunFolder::on_failure(std::string_view what) {
  recording_.on_failure(what);
  manifest_.on_failure(what);
}

}  // namespace trophic::observe
