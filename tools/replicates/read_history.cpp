// SPDX-License-Identifier: MIT
// Definitions of read_history.hpp.
#include <tools/replicates/read_history.hpp>

#include <tools/reading/read_run.hpp>
#include <tools/reading/run_manifest.hpp>
#include <tools/reading/table_reader.hpp>
#include <trophic/io/tables.hpp>

namespace trophic::replicates {

SharedHistory read_history(const std::filesystem::path& folder) {
  const analysis::RunManifest manifest = analysis::read_manifest(folder);
  const std::filesystem::path path = folder / "events.csv";
  if (manifest.status != "complete") throw std::runtime_error{folder.string() + ": is not complete: its neutral null repeats it"};
  analysis::TableReader<io::EventRow> table{path, manifest.web};
  analysis::detail::check_sum(table.csv(), path, manifest.tables);
  auto history = std::make_shared<History>();
  for (io::EventRow row; table.next(row);) {
    if (row.kind == observe::EventKind::tag_switch) continue;
    history->push_back({.tick = row.tick,
                        .kind = row.kind,
                        .body = row.body,
                        .id = row.id,
                        .species = row.species,
                        .origin = row.origin,
                        .parent = row.parent,
                        .cause = row.cause,
                        .killer_or_victim = row.kind == observe::EventKind::death ? row.killer : row.victim});
  }
  return history;
}

}  // namespace trophic::replicates
