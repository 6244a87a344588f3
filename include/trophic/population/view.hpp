// SPDX-License-Identifier: MIT
// All that a rule may read: a snapshot of the population and its positions. Read-only, engine-free.
#pragma once

#include <concepts>
#include <span>
#include <stdexcept>
#include <trophic/habitat/arena.hpp>
#include <trophic/population/act_values.hpp>
#include <trophic/population/energy_flow.hpp>
#include <trophic/population/phenotype.hpp>
#include <trophic/population/resource_field.hpp>
#include <trophic/population/search_tree.hpp>
#include <trophic/support/clock.hpp>

namespace trophic {

class BodyReading;

/// The world as rules see it at one tick. `robots` and `poses` have one element per body, in the same order. Spans refer to the
/// ecology's own data: within a tick a view shows each birth and death at once. Only a table with a Recruitment rule has bodies
/// without an individual: `robots[body].lives()` is false, they are not in the world, and no search finds them.
struct View {
  double time_s = 0.0;          ///< the ecology's clock
  std::int64_t tick = 0;        ///< number of this decision step; 0 at the start
  double tick_s = 2.0;          ///< length of a tick
  double robot_radius_m = 0.0;  ///< of the circle around a standing robot
  const FoodWeb& web;
  const Arena& arena;
  std::span<const Individual> robots;
  std::span<const GroundPose> poses;
  const SearchTree* tree = nullptr;               ///< over the poses; without one, searches visit every robot
  std::span<const std::size_t> members = {};      ///< of each species; if empty, they are counted
  std::uint64_t refused_bodies = 0;               ///< mutations of bodies so far that the rules refused
  std::span<const Phenotype> phenotypes = {};     ///< of each body; empty if all have the habitat's robot and gait
  const ResourceField* field = nullptr;           ///< the resource; null in a table without a rule Resource
  std::span<const EnergyFlow> energy = {};        ///< of each species since the last tick; empty without a rule Metabolism
  ResourceFlow resource = {};                     ///< since the last tick
  std::uint64_t refused_births = 0;               ///< for which no body or no room was free, so far
  const BodyReading* bodies = nullptr;            ///< of an engine with joints (population/body_reading.hpp); null without
  ActValues acts = {};                            ///< of the last decisions
  std::span<const std::string_view> traits = {};  ///< names of the heritable traits of the rule Traits
  bool is_over = false;                           ///< whether the run ends now by EcologyParams::ends_when
  Space space = {};                               ///< whether distances go over the edges of the arena

  /// The value of an act (control/acts/) at the last decision; its default in a table without it.
  template <class Act>
  [[nodiscard]] auto act(BodyIndex body) const {
    if constexpr (detail::KeptByIndividual<Act>) {
      return Act::of(robots[body]);
    } else {
      return acts.of<Act>(body);
    }
  }
  [[nodiscard]] std::size_t count(Species species) const {
    if (!members.empty()) return species < members.size() ? members[species] : 0;
    return static_cast<std::size_t>(std::ranges::count(robots, species, &Individual::species));
  }
  /// Number of individuals whose species hunts (the paper's p, the number of predators), or of one species.
  [[nodiscard]] std::size_t count_hunters(OneSpecies only = {}) const {
    if (only) return count(*only);
    std::size_t hunters = 0;
    for (Species species = 0; species < web.size(); ++species) hunters += web.hunts(species) ? count(species) : 0;
    return hunters;
  }
  [[nodiscard]] double distance_m(BodyIndex a, BodyIndex b) const { return distance_m(poses[a], poses[b]); }
  /// Between two places, over the edges of a torus too.
  [[nodiscard]] double distance_m(const GroundPose& a, const GroundPose& b) const { return space.distance_m(a, b); }
  /// The marks of all whose species `accepts`: of all of them, of those with one tag, or of the active ones.
  template <std::predicate<Species> Accepts>
  [[nodiscard]] Marks marks(Accepts&& accepts, std::optional<int> tag = {}, bool only_active = false) const {
    Marks all = 0;
    for (Species species = 0; species < web.size(); ++species) all |= accepts(species) ? marks_of(species, tag, only_active) : 0;
    return all;
  }
  /// An individual's trait, of the type in the table's list: `view.trait<Sight>(body)`. Throws std::invalid_argument for a trait
  /// that is not in it.
  template <class Trait>
  [[nodiscard]] double trait(BodyIndex body) const {
    const auto place = static_cast<std::size_t>(std::ranges::find(traits, std::string_view{Trait::name}) - traits.begin());
    if (place < traits.size()) return robots[body].genome->traits.at(place);
    throw std::invalid_argument{"trait " + std::string{Trait::name} + ": must be in the list Traits of the rule table"};
  }
  [[nodiscard]] double age_s(const Individual& individual) const { return time_s - individual.age_from_s; }
  /// Whether `wait_s` have passed since a moment: times are floating point, and a rule must not come a tick late for it.
  [[nodiscard]] bool passed(double since_s, double wait_s) const { return has_passed(time_s - since_s, wait_s, tick_s); }
  /// Ticks since birth or last catch (Sec. "Predator Death").
  [[nodiscard]] std::int64_t hunger_ticks(const Individual& individual) const { return tick - individual.fed_tick; }

  /// The body closest to `self` for which `accepts(individual)` or `accepts(body)` holds, excluding itself; on equal distance
  /// the lower index. None if no body within the bounds of the search is accepted. With bounds a search in a large ecology
  /// visits few robots; without them it visits all before it returns none.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, Accepts&& accepts, const Search& search = {}) const {
    if constexpr (std::predicate<Accepts&, const Individual&>) {
      return closest_body(
          self, [&](BodyIndex other) { return accepts(robots[other]); }, search);
    } else {
      return closest_body(self, accepts, search);
    }
  }

  /// Calls `visit(body)` for every body within `radius_m` of a point and others, also spare ones; some on a torus twice.
  template <class Visit>
  void for_each_near(const GroundPose& point, double radius_m, Visit&& visit) const {
    if (tree != nullptr) return tree->for_each_near(point, radius_m, visit, space);
    for (BodyIndex body = 0; body < poses.size(); ++body) visit(body);
  }

  /// All bodies with an individual whose centres are at most `radius_m` from a point on the floor, ascending.
  [[nodiscard]] std::vector<BodyIndex> within(const GroundPose& point, double radius_m) const {
    std::vector<BodyIndex> found;
    const auto take = [&](BodyIndex body) {
      if (distance_m(point, poses[body]) <= radius_m && robots[body].lives()) found.push_back(body);
    };
    for_each_near(point, radius_m, take);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest_body(BodyIndex self, Accepts&& accepts, const Search& search) const {
    if (tree != nullptr) return tree->closest(self, poses[self], accepts, search, space);
    std::optional<BodyIndex> best;
    double best_m = search.within_m;
    for (BodyIndex other = 0; other < robots.size(); ++other) {
      if (other == self || !robots[other].lives() || !accepts(other)) continue;
      const double d = distance_m(self, other);
      if (d < best_m || (d == best_m && !best)) {
        best_m = d;
        best = other;
      }
    }
    return best;
  }
};

}  // namespace trophic
