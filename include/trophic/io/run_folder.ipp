// SPDX-License-Identifier: MIT
// Definitions of run_folder.hpp.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <trophic/io/agent_log.hpp>
#include <trophic/io/body_log.hpp>
#include <trophic/io/event_log.hpp>
#include <trophic/io/genome_log.hpp>
#include <trophic/io/phylogeny.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/io/sense_log.hpp>
#include <trophic/support/without_slash.hpp>
#include <utility>
#include <vector>

namespace trophic::io {

namespace detail {

[[noreturn]] inline void refuse_folder(const std::filesystem::path& path) {
  throw std::invalid_argument{"output folder " + path.string() + ": exists already; runs are never overwritten"};
}

}  // namespace detail

TROPHIC_INLINE void check_new_folder(const std::filesystem::path& path) {
  if (std::filesystem::exists(std::filesystem::symlink_status(path))) detail::refuse_folder(path);
}

TROPHIC_INLINE std::filesystem::path make_new_folder(const std::filesystem::path& path) {
  check_new_folder(path);
  const auto require = [&](const std::error_code& error) {
    if (error) throw std::runtime_error{"output folder " + path.string() + ": cannot be made: " + error.message()};
  };
  std::error_code error;
  const std::filesystem::path name = without_slash(path);
  if (name.has_parent_path()) std::filesystem::create_directories(name.parent_path(), error);
  require(error);
  // Of two programs that want the same folder one makes it.
  const bool made = std::filesystem::create_directory(name, error);
  require(error);
  if (!made) detail::refuse_folder(path);
  return path;
}

struct RunFolder::Tables {
  EventLog events;
  AgentLog agents;
  Phylogeny phylogeny;
  GenomeLog genomes;
  std::optional<SenseLog> senses;
  std::optional<StateLog> states;
  std::optional<GeneLog> genes;
  std::optional<BodyLog> bodies;

  [[nodiscard]] std::vector<std::pair<std::string, TableSum>> sums() const {
    std::vector<std::pair<std::string, TableSum>> all{{"events.csv", events.sum()},
                                                      {"agents.csv", agents.sum()},
                                                      {"phylogeny.csv", phylogeny.sum()},
                                                      {"genomes.csv", genomes.sum()}};
    if (senses) all.emplace_back(SenseLog::file_name, senses->sum());
    if (states) all.emplace_back(StateLog::file_name, states->sum());
    if (genes) all.emplace_back(GeneLog::file_name, genes->sum());
    if (bodies) all.emplace_back(BodyLog::file_name, bodies->sum());
    return all;
  }
};

TROPHIC_INLINE RunFolder::RunFolder(const std::filesystem::path& path, Provenance provenance, const OutputOptions& output,
                                    Opening opening, StateColumns states, const OwnTables& own_tables)
    : path_{opening == Opening::created ? make_new_folder(path) : path},
      lock_{path_},
      states_{std::move(states)},
      tables_{std::make_unique<Tables>(Tables{.events = EventLog{path_ / "events.csv", opening},
                                              .agents = AgentLog{path_ / "agents.csv", opening, output.agents_every_ticks},
                                              .phylogeny = Phylogeny{path_ / "phylogeny.csv", opening},
                                              .genomes = GenomeLog{path_ / "genomes.csv", opening},
                                              .senses = std::nullopt,
                                              .states = std::nullopt,
                                              .genes = std::nullopt,
                                              .bodies = std::nullopt})},
      manifest_{path_ / "manifest.json", std::move(provenance)},
      recording_{path_ / "replay.trp", output.replay_hz, opening} {
  if (opening == Opening::created) open_more(output.senses, output.states, opening);
  for (const MakeOwnTable& make : own_tables) own_tables_.push_back(make(path_, opening));
}
TROPHIC_INLINE RunFolder::RunFolder(RunFolder&&) noexcept = default;
TROPHIC_INLINE RunFolder& RunFolder::operator=(RunFolder&&) noexcept = default;
TROPHIC_INLINE RunFolder::~RunFolder() = default;

TROPHIC_INLINE void RunFolder::persist(Archive& archive) {
  archive(tables_->events, tables_->agents, tables_->phylogeny, tables_->genomes, manifest_, recording_);
  bool senses = tables_->senses.has_value();
  bool states = tables_->states.has_value();
  bool genes = tables_->genes.has_value();
  bool bodies = tables_->bodies.has_value();
  archive(senses, states, genes, bodies);
  if (archive.reads()) open_more(senses, states, Opening::resumed);
  if (archive.reads() && genes) tables_->genes.emplace(path_ / GeneLog::file_name, Opening::resumed);
  if (senses) archive(*tables_->senses);
  if (states) archive(*tables_->states);
  if (archive.reads() && bodies) tables_->bodies.emplace(path_ / BodyLog::file_name, Opening::resumed);
  if (genes) archive(*tables_->genes);
  if (bodies) archive(*tables_->bodies);
  for (const auto& table : own_tables_) {
    std::string name = table->file_name();
    archive(name);
    Archive::require(name == table->file_name(), "other tables of one's own");
    table->persist(archive);
  }
}

TROPHIC_INLINE std::vector<std::pair<std::string, TableSum>> RunFolder::sums() const {
  auto all = tables_->sums();
  for (const auto& table : own_tables_) all.emplace_back(table->file_name(), table->sum());
  return all;
}

TROPHIC_INLINE void RunFolder::open_more(bool senses, bool states, Opening opening) {
  const std::int64_t every_ticks = tables_->agents.every_ticks();
  if (senses) tables_->senses.emplace(path_ / SenseLog::file_name, opening, every_ticks);
  if (states) tables_->states.emplace(path_ / StateLog::file_name, states_, opening, every_ticks);
}

TROPHIC_INLINE void RunFolder::on_start(const observe::RunDescription& run, const View& view) {
  manifest_.set_agents_every_ticks(tables_->agents.every_ticks());
  if (tables_->senses) {
    tables_->senses->on_start(run, view);
    manifest_.set_inputs(run.inputs);
  }
  if (run.has_more_genes && !tables_->genes) tables_->genes.emplace(path_ / GeneLog::file_name, Opening::created);
  if (run.bodies_differ && !tables_->bodies) tables_->bodies.emplace(path_ / BodyLog::file_name, Opening::created);
  if (tables_->genes) tables_->genes->on_start(run, view);
  tables_->phylogeny.on_start(run, view);
  tables_->genomes.on_start(run, view);
  manifest_.on_start(run, view);
  recording_.on_start(run, view);
  for (const auto& table : own_tables_) table->observer().start(run, view);
}

TROPHIC_INLINE void RunFolder::on_event(const observe::Event& event, const View& view) {
  tables_->events.on_event(event, view);
  tables_->phylogeny.on_event(event, view);
  tables_->genomes.on_event(event, view);
  if (tables_->genes) tables_->genes->on_event(event, view);
  if (tables_->bodies) tables_->bodies->on_event(event, view);
  manifest_.on_event(event, view);
  for (const auto& table : own_tables_) table->observer().event(event, view);
}

TROPHIC_INLINE bool RunFolder::wants_decisions() {
  bool any = tables_->senses.has_value();
  for (const auto& table : own_tables_) any = table->observer().wants_decisions() || any;
  return any;
}

TROPHIC_INLINE void RunFolder::on_decision(const observe::DecisionRecord& decision, const View& view) {
  if (tables_->senses) tables_->senses->on_decision(decision, view);
  for (const auto& table : own_tables_) table->observer().decision(decision, view);
}

TROPHIC_INLINE void RunFolder::on_exemption(BodyIndex hunter, const View& view) {
  if (tables_->senses) tables_->senses->on_exemption(hunter, view);
  for (const auto& table : own_tables_) table->observer().exemption(hunter, view);
}

TROPHIC_INLINE void RunFolder::on_frame(const observe::Frame& frame) {
  if (recording_.frame_hz() > 0.0) recording_.on_frame(frame);
  if (tables_->senses) tables_->senses->on_frame(frame);
}

TROPHIC_INLINE double RunFolder::frame_hz() const {
  if (recording_.frame_hz() > 0.0) return recording_.frame_hz();
  return tables_->senses ? tables_->senses->frame_hz() : 0.0;
}

TROPHIC_INLINE std::vector<std::string> RunFolder::files() const {
  std::vector<std::string> names;
  for (const auto& [name, sum] : sums()) names.push_back(name);
  names.emplace_back("manifest.json");
  if (recording_.frame_hz() > 0.0) names.emplace_back("replay.trp");
  return names;
}

TROPHIC_INLINE void RunFolder::on_tick(const View& view) {
  tables_->events.on_tick(view);
  tables_->agents.on_tick(view);
  tables_->phylogeny.on_tick(view);
  tables_->genomes.on_tick(view);
  if (tables_->genes) tables_->genes->on_tick(view);
  if (tables_->bodies) tables_->bodies->on_tick(view);
  if (tables_->senses) tables_->senses->on_tick(view);
  if (tables_->states) tables_->states->on_tick(view);
  manifest_.on_tick(view);
  for (const auto& table : own_tables_) table->observer().tick(view);
}

TROPHIC_INLINE void RunFolder::on_end(const View& view) {
  // On the disk before the manifest says that the run is complete.
  tables_->events.on_end(view);
  tables_->agents.on_end(view);
  tables_->phylogeny.on_end(view);
  tables_->genomes.on_end(view);
  if (tables_->genes) tables_->genes->on_end(view);
  if (tables_->bodies) tables_->bodies->on_end(view);
  for (const auto& table : own_tables_) table->observer().end(view);
  recording_.on_end(view);
  manifest_.set_tables(sums());
  if (recording_.frame_hz() > 0.0) manifest_.set_recording(recording_.frames(), recording_.checksum());
  manifest_.on_end(view);
}

TROPHIC_INLINE void RunFolder::on_failure(std::string_view what) {
  for (const auto& table : own_tables_) table->observer().failure(what);
  manifest_.set_tables(sums());
  manifest_.on_failure(what);
  recording_.on_failure(what);
}

}  // namespace trophic::io
