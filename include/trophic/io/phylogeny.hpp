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

/// Writes a TaxonRow per individual; if bodies differ, with one more column: the plan of its body.
class Phylogeny {
 public:
  static constexpr std::string_view file_name = "phylogeny.csv";

  explicit Phylogeny(const std::filesystem::path& path, Opening opening = Opening::created)
      : file_{path, {}, opening}, has_header_{opening == Opening::resumed} {}

  void on_start(const observe::RunDescription& run, const View&) {
    bodies_differ_ = run.bodies_differ;
    if (std::exchange(has_header_, true)) return;
    file_.buffer() = header_of<TaxonRow>();
    if (bodies_differ_) file_.buffer().replace(file_.buffer().size() - 1, 1, ",modules_text\n");
    file_.flush();
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
      write(row, view);
    }
  }
  void on_tick(const View&) { file_.flush(); }
  void on_end(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].lives()) write(row_of(view.robots[body], body), view);
    }
    file_.flush();
  }

  void persist(Archive& archive) { archive(file_, tag_at_birth_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(column_types<TaxonRow>({"string"})); }  // modules_text

 private:
  /// "[none]", "[7]" or "[7,9]".
  [[nodiscard]] static std::string list_of(std::span<const IndividualId> parents) {
    if (parents.empty()) return "[none]";
    std::string list;
    for (const IndividualId parent : parents) list += (list.empty() ? '[' : ',') + std::to_string(parent);
    return list + ']';
  }

  /// The row of an individual that lives.
  [[nodiscard]] TaxonRow row_of(const Individual& self, BodyIndex body) const {
    return {.id = self.id,
            .ancestor_list = list_of(self.parents),
            .ancestor = self.parent().value_or(self.id),
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

  void write(const TaxonRow& row, const View& view) {
    append_row(file_.buffer(), row, view.web);
    if (!bodies_differ_) return;
    file_.buffer().back() = ',';
    file_.buffer().append(body::text_of(view.phenotypes[row.body].design->modules)).push_back('\n');
  }

  LineFile file_;
  bool has_header_;
  bool bodies_differ_ = false;
  std::vector<int> tag_at_birth_;
};

}  // namespace trophic::io
