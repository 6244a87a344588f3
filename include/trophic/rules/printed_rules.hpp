// SPDX-License-Identifier: MIT
// Lines of a printed rule table, as Markdown and LaTeX.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trophic::rules {

/// Names of parameters and their values, floating-point numbers to six digits; manifests have them exactly.
using PrintedNumbers = std::vector<std::pair<std::string, std::string>>;

/// A line of a printed table.
struct PrintedRule {
  std::string kind;  ///< perception, control, reproduction, death, ...
  std::string slot;
  std::string policy;
  PrintedNumbers numbers;
  std::string source;  ///< the policy's own `source`; empty if it names none
};

/// "cool_down_s = 50, ...".
[[nodiscard]] inline std::string numbers_text(const PrintedNumbers& numbers) {
  std::string text;
  for (const auto& [name, value] : numbers) text.append(text.empty() ? "" : ", ").append(name).append(" = ").append(value);
  return text;
}

/// The lines in which a table differs from another one: those with another policy, and of those with the same policy the
/// parameters that differ. A rule that only the other table has stands there without parameters, with the policy "none".
[[nodiscard]] inline std::vector<PrintedRule> unlike(std::span<const PrintedRule> rules, std::span<const PrintedRule> other) {
  std::vector<PrintedRule> lines;
  const auto same_slot = [](const PrintedRule& rule) {
    return [&rule](const PrintedRule& each) { return each.kind == rule.kind && each.slot == rule.slot; };
  };
  for (const PrintedRule& rule : rules) {
    const auto found = std::ranges::find_if(other, same_slot(rule));
    if (found == other.end() || found->policy != rule.policy) {
      lines.push_back(rule);
      continue;
    }
    PrintedRule line = rule;
    std::erase_if(line.numbers,
                  [&](const auto& number) { return std::ranges::find(found->numbers, number) != found->numbers.end(); });
    if (!line.numbers.empty()) lines.push_back(std::move(line));
  }
  for (const PrintedRule& rule : other) {
    if (std::ranges::none_of(rules, same_slot(rule))) lines.push_back({rule.kind, rule.slot, "none", {}, ""});
  }
  return lines;
}

namespace detail {

/// `text` with each character of `special` replaced by what `escape` gives for it.
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

/// Text as Markdown shows it letter by letter.
[[nodiscard]] inline std::string markdown_text(std::string_view text) {
  return escaped(text, "\\`*_<>[]|~", [](char letter) { return std::string{'\\', letter}; });
}

/// Text as LaTeX shows it letter by letter; quotation marks open and close, and a line may break after _ and /.
[[nodiscard]] inline std::string latex_text(std::string_view text) {
  bool open = false;
  return escaped(text, "\\{}$&#%_^~<>|\"/", [&](char letter) -> std::string {
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
      case '_':
      case '/':
        return (letter == '_' ? "\\_" : "/") + std::string{"\\allowbreak{}"};
      default:
        return {'\\', letter};
    }
  });
}

}  // namespace detail

using detail::latex_text;

/// Text as Markdown and LaTeX tables have it.
[[nodiscard]] inline std::string markdown_table(std::span<const PrintedRule> rules) {
  std::string text = "| kind | slot | policy | parameters | source |\n|---|---|---|---|---|\n";
  for (const PrintedRule& rule : rules) {
    std::string line = "|";
    for (const std::string& cell : {rule.kind, rule.slot, rule.policy, numbers_text(rule.numbers), rule.source}) {
      line += " " + detail::markdown_text(cell) + " |";
    }
    text += line + "\n";
  }
  return text;
}

/// For the packages booktabs, tabularx and array. As wide as the line that it is put into: a column or a page.
[[nodiscard]] inline std::string latex_table(std::span<const PrintedRule> rules) {
  std::string text =
      "% \\usepackage{booktabs,tabularx}; \\input{} this file in a table, or in a table* of two columns.\n"
      "{\\scriptsize\\setlength{\\tabcolsep}{3pt}\\newcolumntype{L}[1]{>{\\hsize=#1\\hsize\\raggedright\\arraybackslash\\hspace{"
      "0pt}}X}%\n"
      "\\begin{tabularx}{\\linewidth}{@{}L{0.75}L{0.95}L{1.2}L{1.1}@{}}\n\\toprule\nslot & policy & parameters & source \\\\\n";
  std::string kind;
  for (const PrintedRule& rule : rules) {
    if (rule.kind != kind) text += "\\midrule\n\\multicolumn{4}{@{}l}{\\itshape " + latex_text(rule.kind) + "} \\\\\n";
    kind = rule.kind;
    text += latex_text(rule.slot) + " & " + latex_text(rule.policy) + " & " + latex_text(numbers_text(rule.numbers)) + " & " +
            latex_text(rule.source) + " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabularx}}\n";
}

}  // namespace trophic::rules
