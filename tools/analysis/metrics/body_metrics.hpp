// SPDX-License-Identifier: MIT
// Measures of the bodies, gaits and brains of a run: their shape, their size, their number, and how fast they walk.
#pragma once

#include <filesystem>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/reading/read_run.hpp>

namespace trophic::analysis {

/// Throws std::invalid_argument, a sentence that names the file, unless the run has bodies.csv or genes.csv: a run has them if
/// bodies, gaits or brains differ.
void check_bodies(const std::filesystem::path& folder);

/// The measures of each species among those alive at the ends of windows of 200 s, or of a twentieth of a shorter run: as means
/// over the windows of the early and of the late half of the run, and as curves.
///   body_*        of bodies.csv: the descriptors of docs/bodies.md, modules, hinges and mass; means over individuals
///   body_plans    different plans, and body_plans_shannon their Shannon number
///   body_change   tree edit distance from the plan of the species' first individual; mean over individuals
///   brain_genes, gait_genes   of genes.csv: genes of that part; means over individuals
///   walked        distance per second between the rows of agents.csv, over all that live in both; it includes turns
/// A measure whose table the run lacks has no value. Throws as check_bodies, and std::invalid_argument for a table that is cut,
/// was changed since the run, or has a plan that cannot be read.
/// A run without a folder has no value of any.
[[nodiscard]] RunMetrics measure_bodies(const RunData& run);

/// The measures of a run's bodies, or those of measure_run.
[[nodiscard]] RunMetrics measure_shipped(const RunData& run, bool bodies);

}  // namespace trophic::analysis
