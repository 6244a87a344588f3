// SPDX-License-Identifier: MIT
// The descent of all individuals of a run, with their genomes.
#pragma once

#include <tools/reading/run_manifest.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::io {
struct TaxonRow;
}

namespace trophic::analysis {

/// An individual of a forest of descent.
struct Taxon {
  IndividualId id = 0;
  std::optional<std::size_t> parent = {};  ///< the first one's place in the forest; none for a root
  double birth_s = 0.0;
  double death_s = std::numeric_limits<double>::infinity();
  Species species = 0;
  std::vector<double> weights = {};      ///< of its genome
  std::vector<std::size_t> others = {};  ///< the places of its further parents
};

/// Individuals in the order of their births: each parent is before its offspring.
using Forest = std::vector<Taxon>;

/// Throws std::invalid_argument, a sentence that names the file, unless the manifest says that the run has what lineage measures
/// need: it was written to its end, has phylogeny.csv and genomes.csv, and no genome changes after its individual's birth.
void check_lineages(const RunManifest& run);

/// Throws std::invalid_argument, a sentence that names file and individual, unless a row of phylogeny.csv can be of this run: it
/// was born and died in that order within the run, and both columns have the same parent.
void check_taxon(const io::TaxonRow& row, const RunManifest& run);

/// The parents that an ancestor_list names, such as "[7,9]"; none for another text.
[[nodiscard]] std::optional<std::vector<IndividualId>> parents_in(std::string_view ancestor_list);

/// Reads phylogeny.csv and genomes.csv. Throws as check_lineages, and std::invalid_argument for a table that is cut, was changed
/// since the run, or lacks a genome or a parent.
[[nodiscard]] Forest read_lineages(const RunManifest& run);

}  // namespace trophic::analysis
