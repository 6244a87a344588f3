// SPDX-License-Identifier: MIT
// Everything that a rule may read: a read-only snapshot of the population and its positions, independent of the engine.
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
/// ecology's own data, so a view shows each birth and death in a tick immediately. Only a table with a Recruitment rule has
/// bodies without an individual: `robots[body].lives()` is false, they are not in the world, and no search finds them.
struct View {
  double time_s = 0.0;          ///< the ecology's clock
  std::int64_t tick = 0;        ///< index of this decision step; 0 at the start
  double tick_s = 2.0;          ///< length of a tick
  double robot_radius_m = 0.0;  ///< radius of the circle around a standing robot
  const FoodWeb& web;
  const Arena& arena;
  std::span<const Individual> robots;
  std::span<const GroundPose> poses;
  const SearchTree* tree = nullptr;                   ///< tree over the poses; without one, searches visit every robot
  std::span<const std::size_t> members = {};          ///< number per species; if empty, they are counted
  std::uint64_t refused_bodies = 0;                   ///< number of body mutations refused by the rules so far
  std::span<const Phenotype> phenotypes = {};         ///< one per body; empty if all have the habitat's robot and gait
  std::span<const ResourceField> foods = {};          ///< the resource, a field for each food; empty without a rule Resource
  std::span<const std::string_view> food_names = {};  ///< of foods in a table with several; empty for the only one
  std::span<const EnergyFlow> energy = {};            ///< one per species, since the last tick; empty without a rule Metabolism
  std::span<const ResourceFlow> resource = {};        ///< one per food, since the last tick
  std::uint64_t refused_births = 0;                   ///< number of births so far without a free body or free space
  const BodyReading* bodies = nullptr;  ///< readings from an engine with joints (population/body_reading.hpp); else null
  ActValues acts = {};                  ///< values of acts at the last decisions
  std::span<const std::string_view> traits = {};  ///< names of the heritable traits of the rule Traits
  bool is_over = false;                           ///< whether the run ends now by EcologyParams::ends_when
  Space space = {};                               ///< whether distances cross the edges of the arena

  /// The value of an act (control/acts/) at the last decision, or its default in a table without it.
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
  /// The distance between two positions, across the edges on a torus.
  [[nodiscard]] double distance_m(const GroundPose& a, const GroundPose& b) const { return space.distance_m(a, b); }
  /// The marks of all individuals whose species `accepts`, of those with one tag, or of the active ones.
  template <std::predicate<Species> Accepts>
  [[nodiscard]] Marks marks(Accepts&& accepts, std::optional<int> tag = {}, bool only_active = false) const {
    Marks all = 0;
    for (Species species = 0; species < web.size(); ++species) all |= accepts(species) ? marks_of(species, tag, only_active) : 0;
    return all;
  }
  /// An individual's trait, by its type in the table's list: `view.trait<Sight>(body)`. Throws std::invalid_argument for a trait
  /// that is not in the list.
  template <class Trait>
  [[nodiscard]] double trait(BodyIndex body) const {
    const auto place = static_cast<std::size_t>(std::ranges::find(traits, std::string_view{Trait::name}) - traits.begin());
    if (place < traits.size()) return robots[body].genome->traits.at(place);
    throw std::invalid_argument{"trait " + std::string{Trait::name} + ": must be in the list Traits of the rule table"};
  }
  [[nodiscard]] double age_s(const Individual& individual) const { return time_s - individual.age_from_s; }
  /// Whether `wait_s` have passed since a moment, with a tolerance for floating-point times, so that rules do not act a tick
  /// late.
  [[nodiscard]] bool passed(double since_s, double wait_s) const { return has_passed(time_s - since_s, wait_s, tick_s); }
  /// Ticks since birth or last catch (Sec. "Predator Death").
  [[nodiscard]] std::int64_t hunger_ticks(const Individual& individual) const { return tick - individual.fed_tick; }

  /// The body closest to `self` for which `accepts(individual)` or `accepts(body)` holds, excluding itself; at equal distances,
  /// the one with the lower index. Empty if no body within the bounds of the search is accepted. With bounds, a search in a large
  /// ecology visits few robots; without them it visits all before it returns an empty result.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, Accepts&& accepts, const Search& search = {}) const {
    if constexpr (std::predicate<Accepts&, const Individual&>) {
      return closest_body(
          self, [&](BodyIndex other) { return accepts(robots[other]); }, search);
    } else {
      return closest_body(self, accepts, search);
    }
  }

  /// Calls `visit(body)` for every body within `radius_m` of a point and for some others, including spare ones; on a torus for
  /// some twice.
  template <class Visit>
  void for_each_near(const GroundPose& point, double radius_m, Visit&& visit) const {
    if (tree != nullptr) return tree->for_each_near(point, radius_m, visit, space);
    for (BodyIndex body = 0; body < poses.size(); ++body) visit(body);
  }

  /// Returns all bodies with an individual whose centres are at most `radius_m` from a point on the floor, in ascending order.
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
