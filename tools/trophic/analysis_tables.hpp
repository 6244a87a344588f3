// SPDX-License-Identifier: MIT
// Tables that analyses need of runs and only a program can make: decisions of brains, distances of body plans.
#pragma once

#include <filesystem>
#include <span>
#include <tools/command/offers.hpp>
#include <trophic/io/column.hpp>

namespace trophic::command {

/// signatures.csv: one row per individual of a run and of each of its forests of drift, in the order of births.
struct SignatureRow {
  std::string run = {};
  std::size_t forest = 0;
  IndividualId id = 0;
  IndividualId parent = 0;
  std::string others = {};
  std::uint32_t type = 0;
  std::size_t complexity = 0;

  static constexpr auto columns() {
    using io::column;
    using Row = SignatureRow;
    return std::tuple{column("run", &Row::run, "", "folder of the run"),
                      column("forest", &Row::forest, "", "0: the run; 1 to 4: parents and genomes by chance, see drift_of"),
                      column("id", &Row::id, "", "the individual"),
                      column("parent", &Row::parent, "", "its first parent in this forest; a root's is its own id"),
                      column("other_parents", &Row::others, "", "the ids of further parents, separated by spaces"),
                      column("type", &Row::type, "", "equal for genomes of a run whose brains decide alike"),
                      column("complexity", &Row::complexity, "", "pairs of an input and an output that depend on each other")};
  }
};

/// plan_distances.csv: one row per body.
struct PlanDistanceRow {
  std::string run = {};
  IndividualId id = 0;
  std::size_t distance = 0;

  static constexpr auto columns() {
    using io::column;
    using Row = PlanDistanceRow;
    return std::tuple{
        column("run", &Row::run, "", "folder of the run"), column("id", &Row::id, "", "the individual"),
        column("distance", &Row::distance, "", "tree edit distance from the plan of its species' first individual to its plan")};
  }
};

/// The runs that `analyze` takes, as typed.
struct AnalysedRuns {
  std::span<const std::filesystem::path> folders;    ///< of runs or of replicates
  std::optional<std::filesystem::path> shadow = {};  ///< the folder of the shadow, if it is not FOLDER/shadow
  bool any_build = false;                            ///< several builds of a program may have made the runs
};

/// Writes signatures.csv of runs and their nulls into a new file, `jobs` runs at a time. Types have up to 24 inputs that the
/// brains met in the first run and in the first one of the shadow. Throws std::invalid_argument, a sentence that names the file,
/// if the runs may not be pooled, lack a table, or have another rule table than `offer`, and std::runtime_error if `file` cannot
/// be written.
void write_signatures(const std::filesystem::path& file, const AnalysedRuns& runs, const Offer& offer, std::size_t jobs = 1);

/// Writes plan_distances.csv of every run below `folders` that has bodies.csv into a new file. Throws std::invalid_argument, a
/// sentence that names file and individual, for a table that was cut or has a plan that cannot be read, and std::runtime_error if
/// `file` cannot be written.
void write_plan_distances(const std::filesystem::path& file, std::span<const std::filesystem::path> folders);

}  // namespace trophic::command
