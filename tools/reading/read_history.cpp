// SPDX-License-Identifier: MIT
// Definitions of read_history.hpp.
#include <tools/reading/read_history.hpp>

#include <tools/reading/checked_rows.hpp>
#include <tools/reading/lineages.hpp>
#include <trophic/io/tables.hpp>

namespace trophic::replicates {

SharedHistory read_history(const std::filesystem::path& folder) {
  const analysis::RunManifest manifest = analysis::read_manifest(folder);
  if (manifest.status != "complete")
    throw std::runtime_error{folder.string() + ": must be complete, because its neutral null repeats it"};
  auto history = std::make_shared<History>();
  std::unordered_map<IndividualId, std::vector<IndividualId>> parents;
  analysis::for_each_row<io::TaxonRow>(manifest, "phylogeny.csv", [&](const io::TaxonRow& row) {
    analysis::check_taxon(row, manifest);
    parents[row.id] = *analysis::parents_in(row.ancestor_list);
  });
  analysis::for_each_row<io::EventRow>(manifest, "events.csv", [&](const io::EventRow& row) {
    if (row.kind == observe::EventKind::tag_switch) return;
    history->push_back({.tick = row.tick,
                        .kind = row.kind,
                        .body = row.body,
                        .id = row.id,
                        .species = row.species,
                        .origin = row.origin,
                        .parents = parents[row.id],
                        .cause = row.cause,
                        .killer_or_victim = row.kind == observe::EventKind::death ? row.killer : row.victim});
  });
  return history;
}

}  // namespace trophic::replicates
