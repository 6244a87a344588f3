// SPDX-License-Identifier: MIT
// Offspring of two parents.
#pragma once

#include <trophic/habitat/body/plan.hpp>
#include <trophic/reproduction/heredity/contract.hpp>

namespace trophic::reproduction::heredity {

/// Rule: one random parent is the template of the offspring; then the parts are mixed:
/// - weights, gait and traits: each number comes from a random parent (uniform crossover [syswerda1989]) if the structure of the
/// part, as its policy defines it (GenomeStructure), is equal in all parents. Otherwise the part is the template's.
/// - bodies of modules: the subtree at a face that both the template and another parent have comes from that parent [sims1994];
/// if modules would overlap, the body is the template's. Other bodies are the template's. With one parent, the offspring gets a
/// copy of its genome.   Reads: parents' genomes.   Random draws: with several parents one for the template, one per number of a
/// mixed part, and two for bodies of modules.
struct Crossover {
  static constexpr std::string_view name = "crossover";
  static constexpr std::string_view source = "not in the paper; [syswerda1989]";

  [[nodiscard]] std::shared_ptr<Genome> inherit(std::span<const Ancestor> parents, Rng& rng,
                                                const GenomeStructure& structure = {}) const {
    const Genome& pattern = *parents[parents.size() == 1 ? 0 : rng.index(parents.size())].genome;
    auto child = std::make_shared<Genome>(pattern);
    if (parents.size() == 1) return child;
    cross(parents, &Genome::weights, structure.weights, *child, rng);
    cross(parents, &Genome::gait_genes, structure.gait_genes, *child, rng);
    cross(parents, &Genome::traits, {}, *child, rng);
    if (!structure.has_modules || pattern.body_genes.empty()) return child;
    const Genome& other = *parents[rng.index(parents.size())].genome;
    try {
      child->body_genes = body::genes_of(crossed(body::tree_of(pattern.body_genes), body::tree_of(other.body_genes), rng));
    } catch (const std::invalid_argument&) {
      return child;  // modules overlap
    }
    return child;
  }

 private:
  /// Returns `tree` with a subtree of another tree at a random path that both have.
  [[nodiscard]] static body::ModuleTree crossed(const body::ModuleTree& tree, const body::ModuleTree& other, Rng& rng) {
    std::vector<std::pair<std::size_t, std::size_t>> shared{{0, 0}};  // the modules at one path of both
    for (std::size_t at = 0; at < shared.size(); ++at) {
      for (const body::Face face : body::all_faces) {
        const auto here = tree.child(shared[at].first, face);
        const auto there = other.child(shared[at].second, face);
        if (here && there) shared.emplace_back(*here, *there);
      }
    }
    if (shared.size() == 1) return tree;
    const auto graft = shared[1 + rng.index(shared.size() - 1)];
    body::ModuleTree result;
    const auto copy = [&](const auto& self, const body::ModuleTree& from, std::size_t module, std::size_t to) -> void {
      for (const body::Face face : body::all_faces) {
        auto child = from.child(module, face);
        if (!child) continue;
        const bool is_graft = &from == &tree && *child == graft.first;
        const body::ModuleTree& source = is_graft ? other : from;
        if (is_graft) child = graft.second;
        const body::Module& made = source.modules()[*child];
        self(self, source, *child, result.attach(to, face, made.type, made.quarter_turns));
      }
    };
    copy(copy, tree, 0, 0);
    return result;
  }
  static void cross(std::span<const Ancestor> parents, std::vector<double> Genome::*part, std::span<const std::size_t> structure,
                    Genome& child, Rng& rng) {
    std::vector<double>& genes = child.*part;
    for (const Ancestor& parent : parents) {
      const std::vector<double>& own = (*parent.genome).*part;
      const auto is_alike = [&](std::size_t gene) { return own.at(gene) == genes.at(gene); };
      if (own.size() != genes.size() || !std::ranges::all_of(structure, is_alike)) return;
    }
    for (std::size_t gene = 0; gene < genes.size(); ++gene)
      genes[gene] = ((*parents[rng.index(parents.size())].genome).*part)[gene];
  }
};
static_assert(Heredity<Crossover>);

}  // namespace trophic::reproduction::heredity
