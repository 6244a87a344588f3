// SPDX-License-Identifier: MIT
// Definitions of plan.hpp.
#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/params/params.hpp>

namespace trophic::body {

namespace detail {

inline void attach_children(const ModuleTree& from, std::size_t module, ModuleTree& to, std::size_t parent) {
  for (const Face face : all_faces) {
    const std::optional<std::size_t> child = from.child(module, face);
    if (!child) continue;
    const Module& made = from.modules()[*child];
    attach_children(from, *child, to, to.attach(parent, face, made.type, made.quarter_turns));
  }
}

inline void append_text(const ModuleTree& tree, std::size_t module, std::string& text) {
  bool first = true;
  for (const Face face : all_faces) {
    const std::optional<std::size_t> child = tree.child(module, face);
    if (!child) continue;
    const Module& made = tree.modules()[*child];
    text.append(first ? "[" : " ").append(enum_name(face)).append(":").append(enum_name(made.type));
    text.append(std::to_string(made.quarter_turns));
    first = false;
    append_text(tree, *child, text);
  }
  if (!first) text += ']';
}

/// A whole number of 0 to `end` - 1 among the genes.
inline std::size_t body_gene(std::span<const double> genes, std::size_t index, std::size_t first, std::size_t end) {
  const double gene = genes[index];
  if (gene >= static_cast<double>(first) && gene < static_cast<double>(end) && gene == std::floor(gene)) {
    return static_cast<std::size_t>(gene);
  }
  throw std::invalid_argument{"body gene " + std::to_string(index) + " = " + number_text(gene) +
                              ": must be a whole number >= " + std::to_string(first) + " and < " + std::to_string(end)};
}

/// Reads a plan's text from left to right.
class PlanReader {
 public:
  explicit PlanReader(std::string_view text) : text_{text} {
    if (!takes("core")) fail("core");
    children(0);
    if (at_ != text_.size()) fail("[ or the end");
  }
  [[nodiscard]] const ModuleTree& tree() const { return tree_; }

 private:
  void children(std::size_t parent) {
    if (!takes("[")) return;
    do {
      if (tree_.modules().size() == most_modules_of_a_plan) {
        fail("no more than " + std::to_string(most_modules_of_a_plan) + " modules");
      }
      const std::size_t began = at_;
      const Face face = one_of(all_faces, "a face");
      if (!takes(":")) fail(":");
      const ModuleType type = one_of(std::array{ModuleType::hinge, ModuleType::brick}, "hinge or brick");
      if (at_ == text_.size() || text_[at_] < '0' || text_[at_] > '3') fail("quarter turns of 0 to 3");
      const int quarter_turns = text_[at_++] - '0';
      std::size_t added = 0;
      try {
        added = tree_.attach(parent, face, type, quarter_turns);
      } catch (const std::invalid_argument& error) {
        at_ = began;
        fail("a module that fits (" + std::string{error.what()} + ")");
      }
      children(added);
    } while (takes(" "));
    if (!takes("]")) fail("] or a space");
  }

  template <class Names>
  [[nodiscard]] typename Names::value_type one_of(const Names& values, std::string_view what) {
    for (const auto value : values) {
      if (takes(enum_name(value))) return value;
    }
    fail(what);
  }

  [[nodiscard]] bool takes(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  [[noreturn]] void fail(std::string_view expected) const {
    const std::string shown{text_.substr(0, 60)};
    throw std::invalid_argument{"body plan \"" + shown + (text_.size() > 60 ? "..." : "") + "\", character " +
                                std::to_string(at_ + 1) + ": must be " + std::string{expected}};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  ModuleTree tree_;
};

}  // namespace detail

TROPHIC_INLINE ModuleTree in_canonical_order(const ModuleTree& tree) {
  ModuleTree ordered;
  detail::attach_children(tree, 0, ordered, 0);
  return ordered;
}

TROPHIC_INLINE std::vector<double> genes_of(const ModuleTree& tree) {
  const ModuleTree ordered = in_canonical_order(tree);
  std::vector<double> genes;
  for (const Module& module : ordered.modules()) {
    if (!module.parent) continue;
    genes.push_back(static_cast<double>(*module.parent));
    genes.push_back(static_cast<double>(module.face));
    genes.push_back(static_cast<double>(module.type));
    genes.push_back(module.quarter_turns);
  }
  return genes;
}

TROPHIC_INLINE ModuleTree tree_of(std::span<const double> genes) {
  if (genes.size() % genes_per_module != 0 || genes.size() >= genes_per_module * most_modules_of_a_plan) {
    throw std::invalid_argument{std::to_string(genes.size()) + " body genes: must be a multiple of " +
                                std::to_string(genes_per_module) + " and < " +
                                std::to_string(genes_per_module * most_modules_of_a_plan)};
  }
  ModuleTree tree;
  for (std::size_t at = 0; at < genes.size(); at += genes_per_module) {
    const std::size_t parent = detail::body_gene(genes, at, 0, tree.modules().size());
    const auto face = all_faces.at(detail::body_gene(genes, at + 1, 0, all_faces.size()));
    const auto type = static_cast<ModuleType>(detail::body_gene(genes, at + 2, 1, 3));
    const auto quarter_turns = static_cast<int>(detail::body_gene(genes, at + 3, 0, 4));
    try {
      (void)tree.attach(parent, face, type, quarter_turns);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{"body genes " + std::to_string(at) + " to " + std::to_string(at + genes_per_module - 1) + ": " +
                                  error.what()};
    }
  }
  return tree;
}

TROPHIC_INLINE std::string text_of(const ModuleTree& tree) {
  std::string text{"core"};
  detail::append_text(tree, 0, text);
  return text;
}

TROPHIC_INLINE ModuleTree read_plan(std::string_view text) {
  return detail::PlanReader{text}.tree();
}

}  // namespace trophic::body
