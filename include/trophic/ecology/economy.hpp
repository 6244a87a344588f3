// SPDX-License-Identifier: MIT
// Moves energy between the resource, the individuals and the outside, and keeps the ledger.
#pragma once

#include <trophic/habitat/habitat.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/view.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// The energy of individuals and of the world under the rules Metabolism and Resource of a table. Each transfer takes from one
/// what it gives to the other. In a table without these rules all functions do nothing.
template <class Rules>
class Economy {
 public:
  static constexpr bool has_energy = !is_neutral<Rules, RuleSlot::metabolism>;
  static constexpr bool has_field = !is_neutral<Rules, RuleSlot::resource>;

  /// All arguments outlive it.
  Economy(const Policies<Rules>& rules, std::uint64_t seed, std::size_t species, const Habitat* habitat)
      : rules_{rules}, seed_{seed}, flows_(has_energy ? species : 0) {
    if constexpr (has_field) {
      if (habitat == nullptr) throw std::invalid_argument{"a rule Resource: needs an arena"};
      Rng rng{seed_, Stream::resource};
      field_ = rules_.resource.start(habitat->arena, rng);
      check_field("start");
    }
  }

  [[nodiscard]] const ResourceField* field() const { return has_field ? &field_ : nullptr; }
  /// One for each species; empty without a rule Metabolism.
  [[nodiscard]] std::span<const EnergyFlow> flows() const { return flows_; }
  [[nodiscard]] const ResourceFlow& resource_flow() const { return resource_flow_; }

  /// The energy of an individual that no parent endows.
  void endow_from_outside(Individual& newborn) {
    if constexpr (has_energy) {
      Rng rng{seed_, Stream::endowment, newborn.id};
      const double energy_J = rule_of(newborn).first_J(newborn, rng);
      check("first_J", energy_J, 0.0, std::numeric_limits<double>::max());
      newborn.energy_J = energy_J;
      flows_[newborn.species].outside_J += energy_J;
    }
  }

  /// The energy of a newborn from its living parents, in equal parts. Throws RuleError if one has less than its part.
  void endow(Individual& newborn, double energy_J, std::span<Individual> robots, std::span<const BodyIndex> parents) {
    if constexpr (has_energy) {
      const double part_J = energy_J / static_cast<double>(parents.size());
      for (const BodyIndex body : parents) {
        Individual* const parent = &robots[body];
        if (!(part_J >= 0.0 && part_J <= std::max(parent->energy_J, 0.0))) {
          throw RuleError{"recruitment", "endowment_J = " + number_text(energy_J) + " from " + std::to_string(parents.size()) +
                                             " parents: must be >= 0, and individual " + std::to_string(parent->id) + " has " +
                                             number_text(parent->energy_J) + " J"};
        }
        parent->energy_J -= part_J;
        flows_[parent->species].given_J += part_J;
        newborn.energy_J += part_J;
      }
      flows_[newborn.species].received_J += newborn.energy_J;
    } else if (energy_J != 0.0) {
      throw RuleError{"recruitment",
                      "endowment_J = " + number_text(energy_J) + ": must be 0 in a table without a rule Metabolism"};
    }
  }

  /// Begins the ledger of a tick.
  void open_ledger() {
    std::ranges::fill(flows_, EnergyFlow{});
    resource_flow_ = {};
  }

  /// All individuals spend, having walked from `before`, the resource grows, and all bite.
  void spend_and_bite(std::span<Individual> robots, std::span<const GroundPose> before, const View& view) {
    if constexpr (has_energy) {
      for (BodyIndex body = 0; body < robots.size(); ++body) {
        Individual& self = robots[body];
        if (!self.lives()) continue;
        const double upkeep_J = rule_of(self).upkeep_J(body, view.distance_m(before[body], view.poses[body]), view);
        check("upkeep_J", upkeep_J, 0.0, std::numeric_limits<double>::max());
        self.energy_J -= upkeep_J;
        flows_[self.species].upkeep_J += upkeep_J;
      }
    }
    if constexpr (has_field) {
      Rng rng{seed_, Stream::resource, 1, static_cast<std::uint64_t>(view.tick)};
      change_field("grow", [&] { rules_.resource.grow(field_, view, rng); });
    }
    if constexpr (has_energy && has_field) bite(robots, view);
  }

  /// A hunter gets its part of what its victim has.
  void eat(BodyIndex hunter, BodyIndex victim, std::span<Individual> robots, const View& view) {
    if constexpr (has_energy) {
      Individual& eater = robots[hunter];
      Individual& eaten = robots[victim];
      const double meal_J = rule_of(eater).meal_J(hunter, victim, view);
      check("meal_J", meal_J, 0.0, std::max(eaten.energy_J, 0.0));
      eaten.energy_J -= meal_J;
      eater.energy_J += meal_J;
      flows_[eater.species].victims_J += meal_J;
      flows_[eaten.species].eaten_J += meal_J;
      if constexpr (requires { rule_of(eater).bonus_J(hunter, victim, view); }) {
        const double bonus_J = rule_of(eater).bonus_J(hunter, victim, view);
        check("bonus_J", bonus_J, 0.0, std::numeric_limits<double>::max());
        eater.energy_J += bonus_J;
        flows_[eater.species].outside_J += bonus_J;
      }
    }
  }

  [[nodiscard]] bool starves(const Individual& self, BodyIndex body, const View& view) const {
    if constexpr (has_energy) return rule_of(self).starves(body, view);
    return false;
  }

  /// The energy of one who dies is lost.
  void lose(const Vacancy& death, Individual& dying, const View& view) {
    [[maybe_unused]] const double left_J = std::exchange(dying.energy_J, 0.0);
    if constexpr (has_energy) flows_[dying.species].lost_J += left_J;
    if constexpr (requires { rules_.resource.on_death(field_, death, left_J, view); }) {
      change_field("on_death", [&] { rules_.resource.on_death(field_, death, left_J, view); });
    }
  }

  void persist(Archive& archive) {
    if constexpr (has_energy) {
      const std::size_t species = flows_.size();
      archive(flows_);
      Archive::require(flows_.size() == species, "energy of another number of species");
    }
    if constexpr (has_field) archive(field_, resource_flow_);
  }

 private:
  [[nodiscard]] const auto& rule_of(const Individual& self) const { return for_species(rules_.metabolism, self.species); }

  static void check(const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw RuleError{"metabolism",
                    std::string{what} + " = " + number_text(value) + ": must be >= " + number_text(least) +
                        (most < std::numeric_limits<double>::max() ? " and <= " + number_text(most) : " and finite")};
  }
  void check_field(const char* what) const {
    for (std::size_t cell = 0; cell < field_.cells(); ++cell) check_cell(what, cell);
  }
  void check_cell(const char* what, std::size_t cell) const {
    const double there_J = field_.food_J(cell);
    if (there_J >= 0.0 && std::isfinite(there_J)) return;
    throw RuleError{"resource", std::string{what} + ": " + number_text(there_J) + " J in cell " + std::to_string(cell) +
                                    ": must be >= 0 and finite"};
  }
  template <class Change>
  void change_field(const char* what, const Change& change) {
    const double before_J = field_.total_J();
    change();
    check_field(what);
    resource_flow_.grown_J += field_.total_J() - before_J;
  }

  /// All bite, in random order.
  void bite(std::span<Individual> robots, const View& view) {
    std::vector<BodyIndex> order;
    for (BodyIndex body = 0; body < robots.size(); ++body) {
      if (robots[body].lives()) order.push_back(body);
    }
    Rng rng{seed_, Stream::bites, 0, static_cast<std::uint64_t>(view.tick)};
    rng.shuffle(std::span{order});
    for (const BodyIndex body : order) {
      Individual& self = robots[body];
      const std::size_t cell = field_.cell_at(view.poses[body]);
      double& there_J = field_.food_J(cell);
      const double bite_J = rule_of(self).bite_J(body, there_J, view);
      check("bite_J", bite_J, 0.0, there_J);
      if (bite_J == 0.0) continue;
      there_J -= bite_J;
      self.energy_J += bite_J;
      flows_[self.species].field_J += bite_J;
      resource_flow_.taken_J += bite_J;
      if constexpr (requires { rules_.resource.on_bite(field_, cell, bite_J, body, view); }) {
        const double before_J = there_J;
        rules_.resource.on_bite(field_, cell, bite_J, body, view);
        check_cell("on_bite", cell);
        resource_flow_.grown_J += there_J - before_J;
      }
    }
  }

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
  ResourceField field_;
  std::vector<EnergyFlow> flows_;
  ResourceFlow resource_flow_;
};

}  // namespace trophic
