// SPDX-License-Identifier: MIT
// Inherited bodies: a tree of modules that mutates at birth.
#pragma once

#include <trophic/habitat/body/plan.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <trophic/params/params.hpp>
#include <trophic/reproduction/body_plan/contract.hpp>

namespace trophic::reproduction::body_plan {

/// Rule: the genes are a plan with four numbers per module (habitat/body/plan.hpp). An individual without a parent has the plan
/// of `first_robot` (`first_modules` 0) or a random tree of `first_modules` modules; an inherited plan is changed by each
/// operator with its probability times `rate` (habitat/body/variation.hpp, [sims1994]), unless only the core would remain.
/// Masses, servos, friction and forward axis are those of `first_robot`; any other plan is named "modules" and has no measured
/// walk. Reads: nothing.   Random draws: 0 for a first plan, or 3 per module except the core; 8 for a mutation, plus those of the
/// operators that act.
struct InheritedModules {
  static constexpr std::string_view name = "inherited_modules";
  static constexpr std::string_view source = "not in the paper; operators of [sims1994]";
  static constexpr bool genes_are_modules = true;

  struct Params {
    std::size_t first_modules = 0;
    body::TreeMutation mutation;
    double rate = 1.0;
    std::string first_robot = {};
    static constexpr auto fields() {
      return std::tuple{
          field("first_modules", &Params::first_modules, between(0.0, 50.0),
                "number of modules in a random first body (1 counts as 2); 0: the body of first_robot")
              .read_for_newcomers(),
          field("mutation", &Params::mutation),
          field("rate", &Params::rate, between(0.0, 1.0), "factor applied to all these probabilities; 0: bodies never change"),
          field("first_robot", &Params::first_robot, "name or path of a robot file; empty: that of ecology.robot")};
    }
  };
  Params params;

  /// The models to load before the run.
  [[nodiscard]] std::vector<std::string> robots() const {
    return params.first_robot.empty() ? std::vector<std::string>{} : std::vector{params.first_robot};
  }

  [[nodiscard]] body::Design grow(std::span<const double> genes, Species, const Habitat& habitat) const {
    body::Design design = base(habitat);
    body::ModuleTree tree = body::tree_of(genes);
    if (body::genes_of(tree) == body::genes_of(design.modules)) return design;
    design.modules = std::move(tree);
    design.name = "modules";
    design.gait.clear();
    design.walk = {};
    return design;
  }

  [[nodiscard]] std::vector<double> draw(Species, const Habitat& habitat, Rng& rng) const {
    if (params.first_modules == 0) return body::genes_of(base(habitat).modules);
    return body::genes_of(body::random_tree(std::max<std::size_t>(params.first_modules, 2), rng));
  }

  void mutate(std::vector<double>& genes, const Individual&, const Habitat& habitat, Rng& rng) const {
    const body::ModuleTree tree =
        body::mutated(body::tree_of(genes), params.mutation.times(params.rate), base(habitat).forward_deg, rng);
    if (tree.modules().size() > 1) genes = body::genes_of(tree);
  }

 private:
  [[nodiscard]] const body::Design& base(const Habitat& habitat) const {
    if (!params.first_robot.empty()) {
      if (const NamedRobot* named = habitat.robot_named(params.first_robot)) return named->design;
      throw std::invalid_argument{"rules.body_plan.first_robot = \"" + params.first_robot + "\": must be a model of the habitat"};
    }
    if (habitat.design) return *habitat.design;
    throw std::invalid_argument{"rules.body_plan = inherited_modules: the habitat must have the design of its robot"};
  }
};
static_assert(InheritedBody<InheritedModules>);

}  // namespace trophic::reproduction::body_plan
