// SPDX-License-Identifier: MIT
// Prints a rule table for readers: the policy in each slot, with its numbers and source.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/physics.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/rules/table.hpp>
#include <variant>
#include <vector>

namespace trophic::rules {

/// A line of a printed table.
struct PrintedRule {
  std::string kind;  ///< perception, control, reproduction, death, ...
  std::string slot;
  std::string policy;
  std::string numbers;  ///< "cool_down_s = 50, ...", floating-point numbers to six digits; manifests have them exactly
  std::string source;   ///< the policy's own `source`, if any
};

namespace detail {

[[nodiscard]] inline std::string short_value(const NamedParam& param) {
  const double* number = std::get_if<double>(&param.value);
  if (number == nullptr) return value_text(param);
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *number, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

template <class Params>
[[nodiscard]] std::string numbers_text(const Params& params) {
  std::string text;
  for (const NamedParam& param : named_params_of(params)) {
    const std::string value = short_value(param);
    if (value.empty()) continue;
    text.append(text.empty() ? "" : ", ").append(param.path).append(" = ").append(value);
  }
  return text;
}

/// Returns `text` with each character of `special` replaced by `escape` of it.
template <class Escape>
[[nodiscard]] std::string escaped(std::string_view text, std::string_view special, Escape&& escape) {
  std::string result;
  for (const char letter : text) {
    if (special.find(letter) == std::string_view::npos) {
      result += letter;
    } else {
      result += escape(letter);
    }
  }
  return result;
}

/// Escapes a text for Markdown.
[[nodiscard]] inline std::string markdown_text(std::string_view text) {
  return escaped(text, "\\`*_<>[]|~", [](char letter) { return std::string{'\\', letter}; });
}

/// Escapes a text for LaTeX; quotation marks open and close.
[[nodiscard]] inline std::string latex_text(std::string_view text) {
  bool open = false;
  return escaped(text, "\\{}$&#%_^~<>|\"", [&](char letter) -> std::string {
    switch (letter) {
      case '\\':
        return "\\textbackslash{}";
      case '^':
        return "\\textasciicircum{}";
      case '~':
        return "\\textasciitilde{}";
      case '<':
        return "\\textless{}";
      case '>':
        return "\\textgreater{}";
      case '|':
        return "\\textbar{}";
      case '"':
        open = !open;
        return open ? "``" : "''";
      default:
        return {'\\', letter};
    }
  });
}

template <class Text>
[[nodiscard]] std::string joined(const PrintedRule& rule, std::string_view between, Text&& text) {
  std::string line = text(rule.kind);
  for (const std::string* cell : {&rule.slot, &rule.policy, &rule.numbers, &rule.source})
    line.append(between).append(text(*cell));
  return line;
}

}  // namespace detail

/// One line for each slot of a table with a policy other than its neutral one, then one for ecology and one for physics, with
/// the given numbers or the table's own.
template <class Rules>
[[nodiscard]] std::vector<PrintedRule> printed_rules(const RuleParams<Rules>& params = {},
                                                     const EcologyParams& ecology = Rules::ecology(),
                                                     const Physics& physics = Rules::physics()) {
  std::vector<PrintedRule> lines;
  for_each_slot([&]<RuleSlot slot>() {
    using Policy = PolicyIn<Rules, slot>;
    if constexpr (!is_neutral<Rules, slot>) {
      lines.push_back({std::string{slot_kind(slot)}, std::string{slot_name(slot)}, std::string{Policy::name},
                       detail::numbers_text(of_slot<slot>(params)), std::string{source_of<Policy>()}});
    }
  });
  lines.push_back({"ecology", "", "", detail::numbers_text(ecology), ""});
  lines.push_back({"physics", "", "", detail::numbers_text(physics), ""});
  return lines;
}

/// The table as Markdown.
template <class Rules>
[[nodiscard]] std::string markdown_table(const RuleParams<Rules>& params = {}, const EcologyParams& ecology = Rules::ecology(),
                                         const Physics& physics = Rules::physics()) {
  std::string text = "| kind | slot | policy | numbers | source |\n|---|---|---|---|---|\n";
  for (const PrintedRule& rule : printed_rules<Rules>(params, ecology, physics)) {
    text.append("| ").append(detail::joined(rule, " | ", detail::markdown_text)).append(" |\n");
  }
  return text;
}

/// The table as a LaTeX tabular that requires no package.
template <class Rules>
[[nodiscard]] std::string latex_table(const RuleParams<Rules>& params = {}, const EcologyParams& ecology = Rules::ecology(),
                                      const Physics& physics = Rules::physics()) {
  std::string text =
      "\\begin{tabular}{lllp{0.28\\linewidth}p{0.28\\linewidth}}\n\\hline\nkind & slot & policy & numbers & source "
      "\\\\\n\\hline\n";
  for (const PrintedRule& rule : printed_rules<Rules>(params, ecology, physics)) {
    text.append(detail::joined(rule, " & ", detail::latex_text)).append(" \\\\\n");
  }
  return text + "\\hline\n\\end{tabular}\n";
}

}  // namespace trophic::rules
