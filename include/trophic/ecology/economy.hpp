// SPDX-License-Identifier: MIT
// Transfers energy between the resource, the individuals and the outside, and keeps the ledger.
#pragma once

#include <trophic/habitat/habitat.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/view.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// Whether individuals have energy under a table, and whether there is a field of food.
template <class Rules>
inline constexpr bool has_energy = !is_neutral<Rules, RuleSlot::metabolism>;
template <class Rules>
inline constexpr bool has_field = !is_neutral<Rules, RuleSlot::resource>;

/// The fields of food under the rule Resource of a table.
template <class Rules, bool = has_field<Rules>>
class FoodSupply {
 public:
  static constexpr std::span<const std::string_view> names = energy::food_names<PolicyIn<Rules, RuleSlot::resource>>;

  /// All arguments must outlive it.
  FoodSupply(const Policies<Rules>& rules, std::uint64_t seed, const Habitat* habitat) : rules_{rules}, seed_{seed} {
    if (habitat == nullptr) throw std::invalid_argument{"a rule Resource: needs an arena"};
    Rng rng{seed_, Stream::resource};
    fields_ = energy::ask::start(rules_.resource, habitat->arena, rng);
    if (fields_.size() != std::max<std::size_t>(names.size(), 1))
      throw RuleError{"resource", "start: " + std::to_string(fields_.size()) + " fields: must be " +
                                      std::to_string(names.size()) + ", one per food"};
    flows_.resize(fields_.size());
    for (std::size_t food = 0; food < fields_.size(); ++food) check_field("start", food);
  }

  [[nodiscard]] std::span<const ResourceField> fields() const { return fields_; }
  [[nodiscard]] std::span<const ResourceFlow> flows() const { return flows_; }  ///< one per food
  void open_ledger() { std::ranges::fill(flows_, ResourceFlow{}); }
  void grow(const View& view) {
    Rng rng{seed_, Stream::resource, 1, static_cast<std::uint64_t>(view.tick)};
    change("grow", [&] { energy::ask::grow(rules_.resource, fields_, view, rng); });
  }
  void take_death([[maybe_unused]] const Vacancy& death, [[maybe_unused]] double left_J, [[maybe_unused]] const View& view) {
    if constexpr (energy::detail::TakesDeaths<PolicyIn<Rules, RuleSlot::resource>>)  // else it would only visit every cell
      change("on_death", [&] { energy::ask::on_death(rules_.resource, fields_, death, left_J, view); });
  }

  void take_birth([[maybe_unused]] std::span<const BodyIndex> parents, [[maybe_unused]] const View& view,
                  [[maybe_unused]] Rng& rng) {
    if constexpr (energy::detail::TakesBirths<PolicyIn<Rules, RuleSlot::resource>>)
      energy::ask::on_birth(rules_.resource, fields_, parents, view, rng);
  }

  /// Lets an individual take `bite_J(there_J)` of a food at its position, and destroy `waste_J(that bite)`. Returns the bite.
  template <class Bite, class Waste>
  double bite(std::size_t food, BodyIndex body, const View& view, const Bite& bite_J, const Waste& waste_J) {
    const std::size_t cell = fields_[food].cell_at(view.poses[body]);
    double& there_J = fields_[food].food_J(cell);
    const double taken_J = bite_J(there_J);
    if (taken_J == 0.0) return 0.0;
    there_J -= taken_J;
    flows_[food].taken_J += taken_J;
    const double wasted_J = std::min(waste_J(taken_J), there_J);
    there_J -= wasted_J;
    flows_[food].destroyed_J += wasted_J;
    const double before_J = there_J;
    energy::ask::on_bite(rules_.resource, fields_, food, cell, taken_J, body, view);
    check_cell("on_bite", food, cell);
    flows_[food].note(there_J - before_J);
    return taken_J;
  }

  void persist(Archive& archive) {
    const std::size_t foods = fields_.size();
    std::size_t saved = foods;
    archive(saved);
    Archive::require(saved == foods, "a resource of a different number of foods");
    for (std::size_t food = 0; food < foods; ++food) archive(fields_[food], flows_[food]);
  }

 private:
  void check_field(const char* what, std::size_t food) const {
    for (std::size_t cell = 0; cell < fields_[food].cells(); ++cell) check_cell(what, food, cell);
  }
  void check_cell(const char* what, std::size_t food, std::size_t cell) const {
    const double there_J = fields_[food].food_J()[cell];
    if (there_J >= 0.0 && std::isfinite(there_J)) return;
    const std::string of = names.empty() ? "" : " of " + std::string{names[food]};
    throw RuleError{"resource", std::string{what} + ": " + number_text(there_J) + " J" + of + " in cell " + std::to_string(cell) +
                                    ": must be >= 0 and finite"};
  }
  template <class Change>
  void change(const char* what, const Change& change) {
    before_J_.clear();
    for (const ResourceField& field : fields_) before_J_.insert(before_J_.end(), field.food_J().begin(), field.food_J().end());
    change();
    const double* before_J = before_J_.data();
    for (std::size_t food = 0; food < fields_.size(); ++food) {
      const std::span<const double> now_J = fields_[food].food_J();
      if (static_cast<std::size_t>(before_J_.data() + before_J_.size() - before_J) < now_J.size())
        throw RuleError{"resource", std::string{what} + ": must keep the number of cells"};
      check_field(what, food);
      ResourceFlow sum;
      for (std::size_t cell = 0; cell < now_J.size(); ++cell) sum.note(now_J[cell] - before_J[cell]);
      flows_[food].grown_J += sum.grown_J;
      flows_[food].destroyed_J += sum.destroyed_J;
      before_J += now_J.size();
    }
  }

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
  std::vector<ResourceField> fields_;
  std::vector<ResourceFlow> flows_;
  std::vector<double> before_J_;  ///< of all cells, while a rule changes them
};

/// A table without that rule has no food.
template <class Rules>
class FoodSupply<Rules, false> {
 public:
  static constexpr std::span<const std::string_view> names{};
  FoodSupply(const Policies<Rules>&, std::uint64_t, const Habitat*) {}
  [[nodiscard]] std::span<const ResourceField> fields() const { return {}; }
  [[nodiscard]] std::span<const ResourceFlow> flows() const { return {}; }
  void open_ledger() {}
  void grow(const View&) {}
  void take_death(const Vacancy&, double, const View&) {}
  void take_birth(std::span<const BodyIndex>, const View&, Rng&) {}
  void persist(Archive&) {}
};

/// The energy of individuals and of the world under the rules Metabolism and Resource of a table. Each transfer removes as much
/// energy on one side as it adds on the other.
template <class Rules, bool = has_energy<Rules>>
class Economy {
 public:
  /// All arguments must outlive it.
  Economy(const Policies<Rules>& rules, std::uint64_t seed, std::size_t species, const Habitat* habitat)
      : rules_{rules}, seed_{seed}, food_{rules, seed, habitat}, flows_(species) {}

  [[nodiscard]] const FoodSupply<Rules>& food() const { return food_; }
  [[nodiscard]] std::span<const EnergyFlow> flows() const { return flows_; }  ///< one per species

  /// The initial energy of an individual that no parent endows.
  void endow_from_outside(Individual& newborn) {
    Rng rng{seed_, Stream::endowment, newborn.id};
    const double energy_J = rule_of(newborn).first_J(newborn, rng);
    check("first_J", energy_J, 0.0, std::numeric_limits<double>::max());
    newborn.energy_J = energy_J;
    flows_[newborn.species].outside_J += energy_J;
  }

  /// The energy of a newborn from its living parents, in equal parts, and what the rule grants on top. Throws RuleError if one
  /// has less than its part.
  void endow(Individual& newborn, double energy_J, std::span<Individual> robots, std::span<const BodyIndex> parents) {
    const double part_J = energy_J / static_cast<double>(parents.size());
    for (const BodyIndex body : parents) {
      Individual& parent = robots[body];
      if (!(part_J >= 0.0 && part_J <= std::max(parent.energy_J, 0.0))) {
        throw RuleError{"recruitment", "endowment_J = " + number_text(energy_J) + " from " + std::to_string(parents.size()) +
                                           " parents: must be >= 0, and individual " + std::to_string(parent.id) + " has " +
                                           number_text(parent.energy_J) + " J"};
      }
      parent.energy_J -= part_J;
      flows_[parent.species].given_J += part_J;
      newborn.energy_J += part_J;
    }
    flows_[newborn.species].received_J += newborn.energy_J;
    const double grant_J = energy::ask::grant_J(rule_of(newborn), newborn);
    check("grant_J", grant_J, 0.0, std::numeric_limits<double>::max());
    newborn.energy_J += grant_J;
    flows_[newborn.species].outside_J += grant_J;
  }

  /// Begins the ledger of a tick.
  void open_ledger() {
    std::ranges::fill(flows_, EnergyFlow{});
    food_.open_ledger();
  }

  /// The acting individuals spend energy for their walk from `before`.
  template <class Acting>
  void spend(std::span<Individual> robots, std::span<const GroundPose> before, const View& view, const Acting& acting) {
    for (BodyIndex body = 0; body < robots.size(); ++body) {
      Individual& self = robots[body];
      if (!acting(self)) continue;
      const double upkeep_J = rule_of(self).upkeep_J(body, view.distance_m(before[body], view.poses[body]), view);
      check("upkeep_J", upkeep_J, 0.0, std::numeric_limits<double>::max());
      self.energy_J -= upkeep_J;
      flows_[self.species].upkeep_J += upkeep_J;
    }
  }
  void grow(const View& view) { food_.grow(view); }

  /// The acting individuals bite each food in turn, in random order of individuals.
  template <class Acting>
  void bite(std::span<Individual> robots, const View& view, const Acting& acting) {
    if constexpr (has_field<Rules>) {
      std::vector<BodyIndex> order;
      for (BodyIndex body = 0; body < robots.size(); ++body) {
        if (acting(robots[body])) order.push_back(body);
      }
      Rng rng{seed_, Stream::bites, acting.turn, static_cast<std::uint64_t>(view.tick)};
      rng.shuffle(std::span{order});
      for (const BodyIndex body : order) {
        Individual& self = robots[body];
        for (std::size_t food = 0; food < food_.fields().size(); ++food) {
          const auto bite_J = [&](double there_J) {
            const double taken_J = rule_of(self).bite_J(body, food, there_J, view);
            check("bite_J", taken_J, 0.0, there_J);
            return taken_J;
          };
          const auto waste_J = [&](double taken_J) {
            const double wasted_J = energy::ask::waste_J(rule_of(self), body, food, taken_J, view);
            check("waste_J", wasted_J, 0.0, std::numeric_limits<double>::max());
            return wasted_J;
          };
          const double taken_J = food_.bite(food, body, view, bite_J, waste_J);
          self.energy_J += taken_J;
          flows_[self.species].field_J += taken_J;
        }
      }
    }
  }

  /// A hunter gets its part of its victim's energy.
  void eat(BodyIndex hunter, BodyIndex victim, std::span<Individual> robots, const View& view) {
    Individual& eater = robots[hunter];
    Individual& eaten = robots[victim];
    const double meal_J = rule_of(eater).meal_J(hunter, victim, view);
    check("meal_J", meal_J, 0.0, std::max(eaten.energy_J, 0.0));
    eaten.energy_J -= meal_J;
    eater.energy_J += meal_J;
    flows_[eater.species].victims_J += meal_J;
    flows_[eaten.species].eaten_J += meal_J;
    const double bonus_J = energy::ask::bonus_J(rule_of(eater), hunter, victim, view);
    check("bonus_J", bonus_J, 0.0, std::numeric_limits<double>::max());
    eater.energy_J += bonus_J;
    flows_[eater.species].outside_J += bonus_J;
  }

  [[nodiscard]] bool starves(const Individual& self, BodyIndex body, const View& view) const {
    return rule_of(self).starves(body, view);
  }

  /// The energy of a dying individual is lost.
  void lose(const Vacancy& death, Individual& dying, const View& view) {
    const double left_J = std::exchange(dying.energy_J, 0.0);
    flows_[dying.species].lost_J += left_J;
    food_.take_death(death, left_J, view);
  }

  /// The field changes by a birth of the rule Recruitment.
  void take_birth(std::span<const BodyIndex> parents, const View& view, Rng& rng) { food_.take_birth(parents, view, rng); }

  void persist(Archive& archive) {
    const std::size_t species = flows_.size();
    archive(flows_);
    Archive::require(flows_.size() == species, "energy of a different number of species");
    archive(food_);
  }

 private:
  [[nodiscard]] const auto& rule_of(const Individual& self) const { return for_species(rules_.metabolism, self.species); }

  static void check(const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw RuleError{"metabolism",
                    std::string{what} + " = " + number_text(value) + ": must be >= " + number_text(least) +
                        (most < std::numeric_limits<double>::max() ? " and <= " + number_text(most) : " and finite")};
  }

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
  FoodSupply<Rules> food_;
  std::vector<EnergyFlow> flows_;
};

/// In a table without a rule Metabolism individuals have no energy. A field grows, but it is not eaten.
template <class Rules>
class Economy<Rules, false> {
 public:
  Economy(const Policies<Rules>& rules, std::uint64_t seed, std::size_t, const Habitat* habitat) : food_{rules, seed, habitat} {}
  [[nodiscard]] const FoodSupply<Rules>& food() const { return food_; }
  [[nodiscard]] std::span<const EnergyFlow> flows() const { return {}; }
  void endow_from_outside(Individual&) {}
  void endow(Individual&, double energy_J, std::span<Individual>, std::span<const BodyIndex>) {
    throw RuleError{"recruitment", "endowment_J = " + number_text(energy_J) + ": must be 0 in a table without a rule Metabolism"};
  }
  void open_ledger() { food_.open_ledger(); }
  void spend(std::span<Individual>, std::span<const GroundPose>, const View&, const auto&) {}
  void grow(const View& view) { food_.grow(view); }
  void bite(std::span<Individual>, const View&, const auto&) {}
  void eat(BodyIndex, BodyIndex, std::span<Individual>, const View&) {}
  void lose(const Vacancy& death, Individual&, const View& view) { food_.take_death(death, 0.0, view); }
  void take_birth(std::span<const BodyIndex> parents, const View& view, Rng& rng) { food_.take_birth(parents, view, rng); }
  void persist(Archive& archive) { archive(food_); }

 private:
  FoodSupply<Rules> food_;
};

}  // namespace trophic
