// SPDX-License-Identifier: MIT
// Definitions of analysis_tables.hpp.
#include <atomic>
#include <map>
#include <tools/contest/play_contests.hpp>
#include <tools/reading/checked_rows.hpp>
#include <tools/reading/csv_reader.hpp>
#include <tools/reading/drift.hpp>
#include <tools/reading/lineages.hpp>
#include <tools/reading/met_inputs.hpp>
#include <tools/reading/pooled_runs.hpp>
#include <tools/reading/shadow.hpp>
#include <tools/reading/signatures.hpp>
#include <tools/replicates/parallel.hpp>
#include <tools/trophic/analysis_tables.hpp>
#include <trophic/habitat/body/distance.hpp>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command {

namespace detail::tables {

using analysis::RunManifest;

constexpr std::size_t forests_of_drift = 4;
constexpr std::size_t signature_inputs = 24;

/// The brain of a run's rule table. Throws std::invalid_argument if the program does not have that table as it was.
[[nodiscard]] analysis::Decide brain_of(const RunManifest& run, const Offer& offer) {
  const contest::Plan plan{.rule_table = run.rules,
                           .engine = run.backend.substr(0, run.backend.find(' ')),
                           .fingerprint = run.fingerprint,
                           .params = run.params};
  if (const std::string why = why_not_played(plan, offer, "analyze them with the program that made them"); !why.empty()) {
    throw std::invalid_argument{run.folder.string() + ": " + why};
  }
  return experiment_of(plan, offer)->brain();
}

/// The rows of a run. `inputs`: by species.
[[nodiscard]] std::string signatures_of(const RunManifest& run, const analysis::Decide& brain,
                                        const std::vector<std::vector<analysis::Inputs>>& inputs) {
  std::vector<analysis::Forest> forests{analysis::read_lineages(run)};
  for (std::size_t k = 0; k < forests_of_drift; ++k) {
    Rng rng{run.seed, Stream::null_model, k};
    forests.push_back(analysis::drift_of(forests.front(), rng));
  }
  analysis::Signatures signatures{[&](Species species, std::span<const double> met, std::span<const double> weights) {
                                    try {
                                      return brain(species, met, weights);
                                    } catch (const std::invalid_argument& error) {
                                      throw std::invalid_argument{(run.folder / "genomes.csv").string() + ": " + error.what()};
                                    }
                                  },
                                  inputs};
  std::string rows;
  for (std::size_t number = 0; number < forests.size(); ++number) {
    for (const analysis::Taxon& taxon : forests[number]) {
      std::string others;
      for (const std::size_t other : taxon.others) {
        others += (others.empty() ? "" : " ") + std::to_string(forests[number][other].id);
      }
      io::append_row(rows,
                     SignatureRow{.run = run.folder.string(),
                                  .forest = number,
                                  .id = taxon.id,
                                  .parent = taxon.parent ? forests[number][*taxon.parent].id : taxon.id,
                                  .others = others,
                                  .type = signatures.type_of(taxon.species, taxon.weights),
                                  .complexity = signatures.complexity(taxon.species, taxon.weights)},
                     run.web);
    }
  }
  return rows;
}

/// The rows of a run with bodies.csv. The first individual of a species is that with the lowest id.
void append_distances(const std::filesystem::path& folder, std::string& rows) {
  const std::filesystem::path path = folder / "bodies.csv";
  const RunManifest run = analysis::read_manifest(folder);
  analysis::CsvReader table{path, {"id", "species", "modules_text"}};
  struct Body {
    std::string species;
    std::string plan;
  };
  std::map<IndividualId, Body> bodies;
  while (table.next()) bodies[table.get<IndividualId>(0)] = {std::string{table.text(1)}, table.get<std::string>(2)};
  std::unordered_map<std::string, body::ModuleTree> first;           // of each species
  std::map<std::pair<std::string, std::string>, std::size_t> known;  // by species and plan
  for (const auto& [id, one] : bodies) {
    const auto [distance, is_new] = known.try_emplace({one.species, one.plan}, 0);
    if (is_new) {
      try {
        const body::ModuleTree plan = body::read_plan(one.plan);
        distance->second = body::edit_distance(first.try_emplace(one.species, plan).first->second, plan);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument{path.string() + ": id " + std::to_string(id) + ": " + error.what()};
      }
    }
    io::append_row(rows, PlanDistanceRow{.run = folder.string(), .id = id, .distance = distance->second}, run.web);
  }
}

}  // namespace detail::tables

void write_signatures(const std::filesystem::path& file, const AnalysedRuns& runs, const Offer& offer, std::size_t jobs) {
  using namespace detail::tables;
  const auto shadows = runs.shadow ? std::vector{*runs.shadow} : analysis::null_folders(runs.folders, Null::shadow);
  std::vector<RunManifest> all = analysis::pooled_runs(runs.folders, false, runs.any_build).manifests;
  std::vector<RunManifest> met{all.front()};
  if (!shadows.empty()) {
    const auto shadow = analysis::pooled_runs(shadows, false, runs.any_build).manifests;
    analysis::check_shadow(all.front(), shadow.front());
    met.push_back(shadow.front());
    all.insert(all.end(), shadow.begin(), shadow.end());
  }
  if (const auto folders = analysis::null_folders(runs.folders, Null::neutral); !folders.empty()) {
    std::ranges::move(analysis::pooled_runs(folders, false, runs.any_build).manifests, std::back_inserter(all));
  }
  for (const RunManifest& run : all) analysis::check_lineages(run);
  const analysis::Decide brain = brain_of(all.front(), offer);
  const auto inputs = analysis::met_inputs(met, signature_inputs);
  std::vector<std::string> rows(all.size());
  std::atomic<bool> has_failed = false;
  const auto attempts = replicates::in_parallel(
      all.size(), jobs,
      [&](std::size_t i) {
        try {
          rows[i] = signatures_of(all[i], brain, inputs);
        } catch (...) {
          has_failed = true;
          throw;
        }
      },
      [&] { return !has_failed; });
  for (const replicates::Attempt& attempt : attempts) {
    if (!attempt.error.empty()) throw std::invalid_argument{attempt.error};
  }
  std::string text = io::header_of<SignatureRow>();
  for (const std::string& of_run : rows) text += of_run;
  write_new_file(file, text);
}

void write_plan_distances(const std::filesystem::path& file, std::span<const std::filesystem::path> folders) {
  std::string text = io::header_of<PlanDistanceRow>();
  try {
    for (const std::filesystem::path& folder : folders) {
      std::vector<std::filesystem::path> runs;
      for (const auto& entry :
           std::filesystem::recursive_directory_iterator{folder, std::filesystem::directory_options::follow_directory_symlink}) {
        if (entry.path().filename() == "bodies.csv") runs.push_back(entry.path().parent_path());
      }
      std::ranges::sort(runs);
      for (const std::filesystem::path& run : runs) detail::tables::append_distances(run, text);
    }
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
  write_new_file(file, text);
}

}  // namespace trophic::command
