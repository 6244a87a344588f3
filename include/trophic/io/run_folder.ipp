// SPDX-License-Identifier: MIT
// Definitions of run_folder.hpp.
#pragma once

#include <system_error>
#include <trophic/io/agent_log.hpp>
#include <trophic/io/body_log.hpp>
#include <trophic/io/energy_log.hpp>
#include <trophic/io/event_log.hpp>
#include <trophic/io/genome_log.hpp>
#include <trophic/io/phylogeny.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/io/sense_log.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/without_slash.hpp>

namespace trophic::io {

TROPHIC_INLINE std::filesystem::path make_new_folder(const std::filesystem::path& path) {
  check_new_folder(path);
  const auto require = [&](const std::error_code& error) {
    if (error) throw std::runtime_error{"output folder " + path.string() + ": cannot be made: " + error.message()};
  };
  std::error_code error;
  const std::filesystem::path name = without_slash(path);
  if (name.has_parent_path()) std::filesystem::create_directories(name.parent_path(), error);
  require(error);
  // If two programs request the same folder, only one makes it.
  const bool made = std::filesystem::create_directory(name, error);
  require(error);
  if (!made) check_new_folder(path);
  return path;
}

/// A table of trophic.
struct RunFolder::Shipped {
  std::string_view file_name;
  std::unique_ptr<AnyOwnTable> (*open)(RunFolder& folder, const std::filesystem::path& path, Opening opening);

  template <class Log>
  static std::unique_ptr<AnyOwnTable> plain(RunFolder&, const std::filesystem::path& path, Opening opening) {
    return std::make_unique<detail::OwnTableOf<Log>>(path, opening);
  }
  static std::unique_ptr<AnyOwnTable> agents(RunFolder& folder, const std::filesystem::path& path, Opening opening) {
    auto table = std::make_unique<detail::OwnTableOf<AgentLog>>(path, opening, folder.agents_every_ticks_);
    folder.agents_ = &table->table();
    return table;
  }
  static std::unique_ptr<AnyOwnTable> senses(RunFolder& folder, const std::filesystem::path& path, Opening opening) {
    auto table = std::make_unique<detail::OwnTableOf<SenseLog>>(path, opening, folder.agents_->every_ticks());
    folder.senses_ = &table->table();
    return table;
  }
  static std::unique_ptr<AnyOwnTable> states(RunFolder& folder, const std::filesystem::path& path, Opening opening) {
    return std::make_unique<detail::OwnTableOf<StateLog>>(path, folder.states_, opening, folder.agents_->every_ticks());
  }

  /// Every one, in the order of checkpoints.
  static std::span<const Shipped> all() {
    static constexpr std::array tables{Shipped{EventLog::file_name, plain<EventLog>},
                                       Shipped{AgentLog::file_name, agents},
                                       Shipped{Phylogeny::file_name, plain<Phylogeny>},
                                       Shipped{GenomeLog::file_name, plain<GenomeLog>},
                                       Shipped{SenseLog::file_name, senses},
                                       Shipped{StateLog::file_name, states},
                                       Shipped{GeneLog::file_name, plain<GeneLog>},
                                       Shipped{BodyLog::file_name, plain<BodyLog>},
                                       Shipped{EnergyLog::file_name, plain<EnergyLog>},
                                       Shipped{ResourceLog::file_name, plain<ResourceLog>},
                                       Shipped{FieldLog::file_name, plain<FieldLog>}};
    static_assert(std::ranges::all_of(tables, is_run_table, &Shipped::file_name));
    return tables;
  }
  static constexpr std::size_t in_every_run = 4;  ///< the first ones
};

TROPHIC_INLINE void RunFolder::open(std::string_view file_name, Opening opening) {
  const auto all = Shipped::all();
  const auto shipped = std::ranges::find(all, file_name, &Shipped::file_name);
  auto& table = tables_[static_cast<std::size_t>(shipped - all.begin())];
  if (!table) table = shipped->open(*this, path_ / file_name, opening);
}

TROPHIC_INLINE RunFolder::RunFolder(const std::filesystem::path& path, Provenance provenance, const OutputOptions& output,
                                    Opening opening, StateColumns states, const OwnTables& own_tables)
    : path_{opening == Opening::created ? make_new_folder(path) : path},
      lock_{path_},
      states_{std::move(states)},
      tables_(Shipped::all().size()),
      manifest_{path_ / "manifest.json", std::move(provenance)},
      recording_{path_ / "replay.trp", output.replay_hz, opening} {
  agents_every_ticks_ = output.agents_every_ticks;
  for (const Shipped& table : Shipped::all().first(Shipped::in_every_run)) open(table.file_name, opening);
  if (opening == Opening::created && output.senses) open(SenseLog::file_name, opening);
  if (opening == Opening::created && output.states) open(StateLog::file_name, opening);
  for (const MakeOwnTable& make : own_tables) tables_.push_back(make(path_, opening));
}

TROPHIC_INLINE void RunFolder::persist(Archive& archive) {
  const std::span tables{tables_};
  const auto optional = Shipped::all().subspan(Shipped::in_every_run);
  for (const auto& table : tables.first(Shipped::in_every_run)) table->persist(archive);
  archive(manifest_, recording_);
  for (std::size_t i = 0; i < optional.size(); ++i) {
    bool is_there = tables_[Shipped::in_every_run + i] != nullptr;
    archive(is_there);
    if (archive.reads() && is_there) open(optional[i].file_name, Opening::resumed);
  }
  for (const auto& table : tables.subspan(Shipped::in_every_run, optional.size())) {
    if (table) table->persist(archive);
  }
  for (const auto& table : tables.subspan(Shipped::all().size())) {
    std::string name = table->file_name();
    archive(name);
    Archive::require(name == table->file_name(), "different own tables");
    table->persist(archive);
  }
}

TROPHIC_INLINE void RunFolder::on_start(const observe::RunDescription& run, const View& view) {
  manifest_.set_agents_every_ticks(agents_->every_ticks());
  if (senses_ != nullptr) manifest_.set_inputs(run.inputs);
  if (run.has_more_genes) open(GeneLog::file_name, Opening::created);
  if (run.bodies_differ) open(BodyLog::file_name, Opening::created);
  if (run.has_energy) open(EnergyLog::file_name, Opening::created);
  if (run.has_resource) open(ResourceLog::file_name, Opening::created);
  if (run.has_resource) open(FieldLog::file_name, Opening::created);
  each([&](AnyOwnTable& table) { table.observer().start(run, view); });
  manifest_.on_start(run, view);
  recording_.on_start(run, view);
}

TROPHIC_INLINE void RunFolder::on_frame(const observe::Frame& frame) {
  if (recording_.frame_hz() > 0.0) recording_.on_frame(frame);
  if (senses_ != nullptr) senses_->on_frame(frame);
}

TROPHIC_INLINE double RunFolder::frame_hz() const {
  if (recording_.frame_hz() > 0.0) return recording_.frame_hz();
  return senses_ != nullptr ? senses_->frame_hz() : 0.0;
}

TROPHIC_INLINE void RunFolder::on_end(const View& view) {
  // The files must be on the disk before the manifest says that the run is complete.
  each([&](AnyOwnTable& table) {
    table.observer().end(view);
    if (const auto file = path_ / table.file_name(); std::filesystem::exists(file)) sync_file(file);
  });
  recording_.on_end(view);
  manifest_.set_tables(sums());
  if (recording_.frame_hz() > 0.0) manifest_.set_recording(recording_.frames(), recording_.checksum());
  manifest_.on_end(view);
}

}  // namespace trophic::io
