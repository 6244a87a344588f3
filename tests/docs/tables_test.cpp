// SPDX-License-Identifier: MIT
// docs/tables.md is made from the columns that the files are written by: the programs' first, then those of the Python module.
#include <doctest/doctest.h>

#include <concepts>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tools/changes/change.hpp>
#include <tools/gait_evolution/files.hpp>
#include <trophic/io/column.hpp>
#include <trophic/io/energy_log.hpp>
#include <trophic/io/tables.hpp>

namespace {

using namespace trophic;

/// The kind of a column's cells.
template <class T>
std::string cells(const io::Written& written) {
  if constexpr (requires(T value) { value.has_value(); }) {
    const std::string none{written.none.empty() ? std::string_view{"empty"} : written.none};
    return cells<typename T::value_type>(written) + (written.if_any ? "" : ", or " + none);
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
    } else if constexpr (io::is_named_columns<Kind>) {
      name = "..." + name;
      kind = "number, exact, or empty";
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

constexpr std::string_view introduction = R"(# Tables

Every column of every table that trophic writes. The program `docs_tables` and the module
`trophic.report.columns` make this page from the code.

CSV with one header row. Numbers marked "exact" read back as the same bits. Times are in seconds of the ecology's clock, which is
simulated time in the paper's rules.
)";

constexpr std::string_view states = R"(
## states.csv

The states of rules for every robot, at the ticks of agents.csv, after that tick's rules. Written only with --states.
The columns time_s, tick, body and id are those of agents.csv. One column SLOT.MEMBER follows for each member of each State of the
table, such as starvation.exemption.adversary_distance_m. Numbers are exact, ancestors are ids, lists are separated by spaces, and an
empty cell means no value.
)";

constexpr std::string_view bodies = R"(
## bodies.csv

The body of every newborn, one per row. Written only if bodies differ. Plans are trees of modules, numbered from 0 in the order of their
first births. The first columns are id (of the newborn), time_s, species, plan, parent_plan and edit_distance. The distance counts modules
that are inserted, deleted or changed since the parent's plan; both cells are empty without a parent. The columns modules_text, modules,
hinges, bricks, mass_kg and reach_m follow. The reach is the largest distance of a point from the root. The last columns are
the descriptors of trophic/habitat/body/descriptors.hpp, from size to joints; size is relative to 20 modules. Numbers are exact.
)";

std::string document() {
  std::string text{introduction};
  text += section<io::EventRow>("events.csv", "The events of a run in chronological order, one per row.");
  text += section<io::AgentRow>("agents.csv", "Every robot at every tick, after that tick's rules.");
  text += section<io::SenseRow>(
      "senses.csv",
      R"(Contacts of every robot, and inputs and outputs of its brain, at the ticks of agents.csv. Written only with --senses.
Contacts are those between the boxes of the bodies at that moment.)");
  text += states;
  text += section<io::TaxonRow>(
      "phylogeny.csv", "Every individual in the ALife data standard, written when it dies; those alive at the end follow.");
  text += section<io::GenomeRow>("genomes.csv",
                                 "One row per birth. If genomes are shared, a later row with the same genome_id has the new "
                                 "weights of all its individuals.");
  text += section<io::GeneRow>("genes.csv",
                               R"(One row per gene of every newborn. Written only if individuals inherit gaits or bodies, or if
brains grow.)");
  text += section<changes::ChangeRow>("changes.csv",
                                      "The changes to rule parameters during a run, in chronological order. Written "
                                      "only with --changes and --live; --changes reads it.");
  text += bodies;
  text += section<io::EnergyRow>(
      "energy.csv",
      R"(The energy of each species at every tick, after that tick's rules. Written only with a rule Metabolism.
stock_J is the previous row's plus outside_J, field_J, victims_J and received_J, less upkeep_J, eaten_J, given_J and lost_J.)");
  text += section<io::ResourceRow>(
      "resource.csv",
      R"(Each food of the resource at every tick. Written only with a rule Resource. stock_J is the food's previous row's plus
grown_J, less taken_J and destroyed_J.)");
  text += section<io::FieldRow>("field.csv",
                                "Every cell of each food at every tenth tick, or hundredth if there are more than 10,000. "
                                "Written only with a rule Resource.");
  text += section<gait_evolution::TaxonRow>("phylogeny.csv of a gait's evolution",
                                            "Every candidate in the ALife data standard, time in generations.");
  return text;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

TEST_CASE("docs/tables.md: columns of the code -> the page begins with them") {
  const std::string now = document();
  std::ofstream{WRITTEN_TABLES} << now;
  INFO("current page: " WRITTEN_TABLES "; cmake --build BUILD --target docs_tables_md copies it to docs/");
  const bool begins_with_it = content(TABLES_MD).starts_with(now);
  CHECK(begins_with_it);
}
