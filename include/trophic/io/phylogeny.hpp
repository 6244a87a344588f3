// SPDX-License-Identifier: MIT
// phylogeny.csv: the descent of individuals, in the ALife data standard.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <utility>
#include <vector>

namespace trophic::io {

/// Writes a TaxonRow per individual; if bodies differ, with one more column: the plan of its body.
class Phylogeny {
 public:
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
      write(event.individual, event.body, view, view.time_s, event.individual.tag, event.cause, event.other);
    }
  }
  void on_tick(const View&) { file_.flush(); }
  void on_end(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (!view.robots[body].lives()) continue;
      write(view.robots[body], body, view, {}, {}, {}, {});
    }
    file_.finish();
  }

  void persist(Archive& archive) { archive(file_, tag_at_birth_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(); }

 private:
  void write(const Individual& self, BodyIndex body, const View& view, std::optional<double> died_s, std::optional<int> tag,
             std::optional<Cause> cause, std::optional<IndividualId> killer) {
    const TaxonRow row{.id = self.id,
                       .ancestor_list = self.parent ? "[" + std::to_string(*self.parent) + "]" : "[none]",
                       .ancestor = self.parent.value_or(self.id),
                       .origin_time = self.born_s,
                       .destruction_time = died_s,
                       .species = self.species,
                       .origin = self.origin,
                       .body = body,
                       .genome = self.genome->id,
                       .mutation_distance = self.mutation_distance,
                       .tag_at_birth = tag_at_birth_.at(body),
                       .tag_at_death = tag,
                       .cause_of_death = cause,
                       .killer = killer};
    append_row(file_.buffer(), row, view.web);
    if (!bodies_differ_) return;
    file_.buffer().back() = ',';
    file_.buffer().append(body::text_of(view.phenotypes[body].design->modules)).push_back('\n');
  }

  LineFile file_;
  bool has_header_;
  bool bodies_differ_ = false;
  std::vector<int> tag_at_birth_;
};

}  // namespace trophic::io
