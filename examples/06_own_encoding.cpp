// SPDX-License-Identifier: MIT
// An encoding of bodies of one's own: an L-system, whose rules of growth are inherited, with the command line of every
// experiment.
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/experiment.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/with_part.hpp>

using namespace trophic;

/// Rule: a body grows from the core, module by module. Each module has one of four symbols; a symbol's genes are its type, its
/// quarter turns, and the symbols of the modules that grow at its front, left and right, or none. The core has a symbol for each
/// face. So one gene can change every leg. A hinge bears a brick, as hinges on hinges often diverge.   Reads: nothing.   Random
/// draws: 24 of a first body; at a mutation 24, and 1 for each gene that changes.
struct LSystem {
  static constexpr std::string_view name = "l_system";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double rate = 0.05;
    std::size_t most_modules = 15;
    static constexpr auto fields() {
      return std::tuple{
          field("rate", &Params::rate, between(0.0, 1.0), "probability that a gene is redrawn"),
          field("most_modules", &Params::most_modules, between(2.0, 50.0), "number of modules at which growth ends")};
    }
  };
  Params params;

  /// Genes are numbers in [0, 1): the core's four faces, then type, turns, front, left and right of each symbol.
  [[nodiscard]] std::vector<double> draw(Species, const Habitat&, Rng& rng) const {
    std::vector<double> genes(faces + symbols * per_symbol);
    for (double& gene : genes) gene = rng.uniform();
    return genes;
  }

  void mutate(std::vector<double>& genes, const Individual&, const Habitat&, Rng& rng) const {
    for (double& gene : genes) {
      if (rng.chance(params.rate)) gene = rng.uniform();
    }
  }

  [[nodiscard]] body::Design grow(std::span<const double> genes, Species, const Habitat& habitat) const {
    if (genes.size() != faces + symbols * per_symbol || !std::ranges::all_of(genes, [](double g) { return g >= 0.0 && g < 1.0; }))
      throw std::invalid_argument{"genes of an L-system: must be 24 numbers in [0, 1)"};
    body::Design design = *habitat.design;  // masses, servos and friction
    design.modules = {};
    design.name = "l_system";
    design.gait.clear();
    design.walk = {};
    std::vector<std::size_t> symbol_of{symbols};  // of each module; the core has none of its own
    for (std::size_t module = 0; module < design.modules.modules().size(); ++module) {
      for (const body::Face face : body::all_faces) {
        const auto next = symbol_at(genes, symbol_of[module], face);
        if (next && attach(design.modules, module, face, genes.subspan(faces + *next * per_symbol, per_symbol))) {
          symbol_of.push_back(*next);
        }
      }
    }
    return design;
  }

 private:
  static constexpr std::size_t faces = 4;
  static constexpr std::size_t symbols = 4;
  static constexpr std::size_t per_symbol = 5;

  /// The symbol that grows at this face of a module with this symbol.
  [[nodiscard]] static std::optional<std::size_t> symbol_at(std::span<const double> genes, std::size_t symbol, body::Face face) {
    const auto place = static_cast<std::size_t>(face);  // front, back, left, right
    if (symbol < symbols && face == body::Face::back) return std::nullopt;
    const double gene = symbol == symbols ? genes[place] : genes[faces + symbol * per_symbol + (place == 0 ? 2 : place + 1)];
    const auto next = static_cast<std::size_t>(gene * (symbols + 2));  // a third of all places stays empty
    return next < symbols ? std::optional{next} : std::nullopt;
  }

  /// Adds a module if there is room for it.
  [[nodiscard]] bool attach(body::ModuleTree& tree, std::size_t parent, body::Face face, std::span<const double> symbol) const {
    if (tree.modules().size() >= params.most_modules || !body::has_face(tree.modules()[parent].type, face)) return false;
    try {
      const bool bends = symbol[0] < 0.5 && tree.modules()[parent].type != body::ModuleType::hinge;
      tree.attach(parent, face, bends ? body::ModuleType::hinge : body::ModuleType::brick, static_cast<int>(4.0 * symbol[1]));
      return true;
    } catch (const std::invalid_argument&) {  // the cell is taken
      return false;
    }
  }
};
static_assert(reproduction::InheritedBody<LSystem>);

using Inherits = with_parent_after<with_genome_source<rules::Paper, reproduction::genome_source::AlwaysInherited>,
                                   Cause::sacrificed, reproduction::parent::NearestConspecific>;
using Evolving = with_viability<
    with_body_plan<with_gait<with_embodiment<Inherits, initialization::embodiment::StandsUp>, control::gait::InheritedCppn>,
                   LSystem>,
    reproduction::viability::SurvivesTrial<reproduction::viability::ModuleLimits>>;
using Rules =
    named<with_params<Evolving, [](auto& params) { params.gait.first = control::gait::FirstGait::random; }>, "l_systems">;

int main(int argc, char** argv) {
  return experiment<Rules>(argc, argv);
}
