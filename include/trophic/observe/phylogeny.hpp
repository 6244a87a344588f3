// SPDX-License-Identifier: MIT
// phylogeny.csv: who descends from whom, in the ALife data standard.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <trophic/observe/csv.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>
#include <vector>

namespace trophic::observe {

/// One row per individual (taxon), written when it dies; those alive at the end follow with destruction_time inf.
/// Standard columns: id, ancestor_list ("[none]" or "[parent]"), origin_time, destruction_time (ecology seconds); ancestor_id is
/// the plain-number form (a root's is its own id). Ours: species, origin, body, genome_id, mutation_distance, tag_at_birth,
/// tag_at_death, cause_of_death, killer_id.
class Phylogeny {
 public:
  explicit Phylogeny(const std::filesystem::path& path)
      : file_{path,
              "id,ancestor_list,ancestor_id,origin_time,destruction_time,species,origin,body,genome_id,mutation_distance,"
              "tag_at_birth,tag_at_death,cause_of_death,killer_id"} {}

  void on_event(const Event& event, const View& view) {
    if (event.kind == EventKind::birth) {
      tag_at_birth_.resize(view.robots.size());
      tag_at_birth_[event.body] = event.individual.tag;
    } else if (event.kind == EventKind::death) {
      write(event.individual, event.body, view, view.time_s, event.individual.tag, event.cause, event.other);
    }
  }
  void on_tick(const View&) { file_.flush(); }
  void on_end(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      write(view.robots[body], body, view, std::numeric_limits<double>::infinity(), {}, {}, {});
    }
    file_.flush();
  }

 private:
  void write(const Individual& self, BodyIndex body, const View& view, double destruction_time, std::optional<int> tag_at_death,
             std::optional<Cause> cause, std::optional<IndividualId> killer) {
    const std::string ancestors = self.parent ? "[" + std::to_string(*self.parent) + "]" : "[none]";
    file_.row(self.id, ancestors, self.parent.value_or(self.id), self.born_s, destruction_time, view.web.name(self.species),
              self.origin, body, self.genome->id, self.mutation_distance, tag_at_birth_.at(body), tag_at_death, cause, killer);
  }

  CsvFile file_;
  std::vector<int> tag_at_birth_;
};

}  // namespace trophic::observe
