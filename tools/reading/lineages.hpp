// SPDX-License-Identifier: MIT
// Rows of phylogeny.csv.
#pragma once

#include <tools/reading/run_manifest.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::io {
struct TaxonRow;
}

namespace trophic::analysis {

/// Throws std::invalid_argument, a sentence that names file and individual, unless a row of phylogeny.csv can be of this run: it
/// was born and died in that order within the run, and both columns have the same parent.
void check_taxon(const io::TaxonRow& row, const RunManifest& run);

/// The parents that an ancestor_list names, such as "[7,9]"; none for another text.
[[nodiscard]] std::optional<std::vector<IndividualId>> parents_in(std::string_view ancestor_list);

}  // namespace trophic::analysis
