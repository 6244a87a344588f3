// SPDX-License-Identifier: MIT
// docs/tables.md is made from the columns that the files are written by.
#include <doctest/doctest.h>

#include <concepts>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <tools/analysis/report/ablation_tables.hpp>
#include <tools/analysis/report/axis_rows.hpp>
#include <tools/analysis/report/means_table.hpp>
#include <tools/analysis/report/metrics_table.hpp>
#include <tools/analysis/report/sweep_rows.hpp>
#include <tools/gait_evolution/history.hpp>
#include <tools/trophic/cross_check/gait_report.hpp>
#include <tools/trophic/cross_check/report.hpp>
#include <trophic/io/column.hpp>
#include <trophic/io/tables.hpp>
#include <type_traits>

namespace {

using namespace trophic;

/// What stands in a column's cells.
template <class T>
std::string cells(const io::Written& written) {
  if constexpr (requires(T value) { value.has_value(); }) {
    return cells<typename T::value_type>(written) + (written.none.empty() ? ", or empty" : ", or " + std::string{written.none});
  } else if constexpr (std::same_as<T, bool>) {
    return "0 or 1";
  } else if constexpr (NamedEnum<T>) {
    std::string names;
    for (const std::string_view name : enum_names(T{})) names += (names.empty() ? "" : ", ") + std::string{name};
    return names;
  } else if constexpr (std::integral<T>) {
    return "whole number";
  } else if constexpr (std::floating_point<T>) {
    return written.decimals < 0 ? "number, exact" : "number, " + std::to_string(written.decimals) + " decimals";
  } else {
    return "text";
  }
}

template <io::TableRow Row>
std::string section(std::string_view file, std::string_view what) {
  std::string text =
      "\n## " + std::string{file} + "\n\n" + std::string{what} + "\n\n| column | unit | cells | meaning |\n|---|---|---|---|\n";
  io::for_each_column<Row>([&](const auto& column) {
    using Kind = std::remove_cvref_t<decltype(column)>;
    std::string name{column.name};
    std::string_view unit;
    std::string kind;
    if constexpr (io::is_species_column<Kind>) {
      kind = "name of a species";
    } else if constexpr (io::is_list_columns<Kind>) {
      name = name + "0, " + name + "1, ...";
      unit = column.unit;
      kind = "number, exact";
    } else {
      unit = column.unit;
      kind = cells<std::remove_cvref_t<decltype(Row{}.*column.member)>>(column.written);
    }
    text += "| " + name + " | " + std::string{unit} + " | " + kind + " | " + std::string{column.help} + " |\n";
  });
  return text;
}

std::string document() {
  return "# Tables\n\nEvery column of every table that trophic writes. Made from the code: the test of this page says how to "
         "make it anew.\n\n"
         "CSV with one header row. Numbers that are exact read back as the same bits. Times are in seconds of the ecology's "
         "clock, which\n"
         "is simulated time in the paper's rules.\n" +
         section<io::EventRow>("events.csv", "A run's events, one a row, in the order in which they happened.") +
         section<io::AgentRow>("agents.csv", "Every robot at every tick, after that tick's rules.") +
         section<io::SenseRow>("senses.csv",
                               "What every robot touched, was told and answered, at the ticks of agents.csv. Written with "
                               "--senses only.\nBodies are as they stand at that moment, contacts those of their boxes' "
                               "shapes.") +
         "\n## states.csv\n\nWhat rules with a State keep for every robot, at the ticks of agents.csv, after that tick's rules. "
         "Written "
         "with --states only.\nThe columns time_s, tick, body and id are those of agents.csv. Then stands a column SLOT.MEMBER "
         "for each "
         "member of each State\nof the table, such as starvation.exemption.adversary_distance_m: numbers exact, an ancestor by "
         "its id, the "
         "numbers of "
         "a list with spaces\nbetween, nothing as an empty cell. Where no rule has a State there are no other columns.\n" +
         section<io::TaxonRow>(
             "phylogeny.csv",
             "Every individual in the ALife data standard, written when it dies. Those alive at the end follow.") +
         section<io::GenomeRow>("genomes.csv",
                                "A row a birth. Where genomes are shared, a later row of the same genome_id holds what "
                                "everybody who shares it\nhas from then on.") +
         section<analysis::MetricRow>("metrics.csv",
                                      "What the analysis measured: every value and every curve of every run, one value a row.") +
         section<analysis::MeanRow>("means.csv", "Each metric of a set next to each of its nulls, for tables of a paper.") +
         section<analysis::SetDifferenceRow>("differences.csv", "Each metric of two sets that were compared.") +
         section<analysis::SwapRow>("ablations.csv", "What each swap of a rule changes, one effect a row.") +
         section<analysis::CellRow>("cells.csv",
                                    "The cells of a sweep. After these columns stands one for each setting that varies between "
                                    "cells, named by its path.") +
         section<analysis::SweepRunRow>("runs.csv", "What the analysis of a sweep measured: one value of one run a row.") +
         section<analysis::SweepMetricRow>("sweep_metrics.csv",
                                           "Each metric of each cell of a sweep, alone and over its shadow.") +
         section<analysis::SweepDifferenceRow>("sweep_differences.csv",
                                               "Each metric of each cell of a sweep beside the reference cell.") +
         section<analysis::AxisEffectRow>("sweep_effects.csv",
                                          "What each value of an axis does to each metric, averaged over the other axes.") +
         section<command::cross_check::CheckRow>("cross_check.csv",
                                                 "What `trophic cross-check` measured of gaits and ecologies.") +
         section<command::cross_check::TrajectoryRow>("trajectories.csv", "Where the robots of a cross-check of gaits went.") +
         section<gait_evolution::GenerationRow>("generations.csv of a gait's evolution", "A row a generation.") +
         section<gait_evolution::TaxonRow>("phylogeny.csv of a gait's evolution",
                                           "Every candidate in the ALife data standard, time in generations.");
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

TEST_CASE("docs/tables.md lists every column that is written") {
  const std::string now = document();
  std::ofstream{WRITTEN_TABLES} << now;
  INFO("made anew: " WRITTEN_TABLES "; cmake --build BUILD --target docs_tables_md puts it into docs/");
  const bool same = content(TABLES_MD) == now;
  CHECK(same);
}
