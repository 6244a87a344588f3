// SPDX-License-Identifier: MIT
// phylogeny.csv: the descent of individuals, in the ALife data standard.
#pragma once

#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// Writes a TaxonRow per individual.
class Phylogeny : public CsvFile<TaxonRow> {
 public:
  static constexpr std::string_view file_name = "phylogeny.csv";

  explicit Phylogeny(const std::filesystem::path& path, Opening opening = Opening::created) : CsvFile{path, {}, opening} {}

  void on_start(const observe::RunDescription& run, const View&) {
    bodies_differ_ = run.bodies_differ;
    several_parents_ = run.several_parents;
    begin({.ancestor = several_parents_ ? std::nullopt : std::optional{IndividualId{}},
           .modules_text = bodies_differ_ ? std::optional{""} : std::nullopt});
  }
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::birth) {
      tag_at_birth_.resize(view.robots.size());
      tag_at_birth_[event.body] = event.individual.tag;
    } else if (event.kind == observe::EventKind::death) {
      TaxonRow row = row_of(event.individual, event.body);
      row.destruction_time = view.time_s;
      row.tag_at_death = event.individual.tag;
      row.cause_of_death = event.cause;
      row.killer = event.other;
      write_with_body(row, view);
    }
  }
  void on_tick(const View&) { flush(); }
  void on_end(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].lives()) write_with_body(row_of(view.robots[body], body), view);
    }
    flush();
  }

  void persist(Archive& archive) {
    CsvFile::persist(archive);
    archive(tag_at_birth_);
  }

 private:
  /// The row of a living individual.
  [[nodiscard]] TaxonRow row_of(const Individual& self, BodyIndex body) const {
    return {.id = self.id,
            .ancestor_list = ancestor_list_of(self),
            .ancestor = several_parents_ ? std::nullopt : std::optional{self.parent().value_or(self.id)},
            .origin_time = self.born_s,
            .destruction_time = {},
            .species = self.species,
            .origin = self.origin,
            .body = body,
            .genome = self.genome->id,
            .mutation_distance = self.mutation_distance,
            .tag_at_birth = tag_at_birth_.at(body),
            .tag_at_death = {},
            .cause_of_death = {},
            .killer = {}};
  }

  void write_with_body(TaxonRow row, const View& view) {
    if (bodies_differ_) row.modules_text = body::text_of(view.phenotypes[row.body].design->modules);
    write(row, view.web);
  }

  bool bodies_differ_ = false;
  bool several_parents_ = false;  ///< the ALife standard then allows no ancestor_id
  std::vector<int> tag_at_birth_;
};

}  // namespace trophic::io
