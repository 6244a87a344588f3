// SPDX-License-Identifier: MIT
// Definitions of printed_rules.hpp.
#include <tools/experiment/printed_rules.hpp>

#include <algorithm>
#include <tools/experiment/escaped.hpp>

namespace trophic::command {

namespace {

std::string short_value(const NamedParam& param) {
  const double* number = std::get_if<double>(&param.value);
  if (number == nullptr) return value_text(param);
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *number, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

/// The parameters whose paths begin with `root`, without it.
PrintedParams params_in(const NamedParams& params, const std::string& root) {
  PrintedParams printed;
  for (const NamedParam& param : params) {
    if (!param.path.starts_with(root)) continue;
    if (const std::string value = short_value(param); !value.empty()) printed.emplace_back(param.path.substr(root.size()), value);
  }
  return printed;
}

}  // namespace

std::vector<PrintedRule> printed_rules(std::span<const rules::SlotRule> rules, const NamedParams& params) {
  std::vector<PrintedRule> lines;
  for (const rules::SlotRule& rule : rules) {
    const std::string slot{rule.slot};
    lines.push_back({std::string{rule.kind}, slot, std::string{rule.policy}, params_in(params, "rules." + slot + "."),
                     std::string{rule.source}});
  }
  for (const std::string part : {"ecology", "physics"}) lines.push_back({part, "", "", params_in(params, part + "."), ""});
  return lines;
}

std::string params_text(const PrintedParams& params) {
  std::string text;
  for (const auto& [name, value] : params) text.append(text.empty() ? "" : ", ").append(name).append(" = ").append(value);
  return text;
}

std::vector<PrintedRule> unlike(std::span<const PrintedRule> rules, std::span<const PrintedRule> other) {
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
    std::erase_if(line.params, [&](const auto& param) { return std::ranges::find(found->params, param) != found->params.end(); });
    if (!line.params.empty()) lines.push_back(std::move(line));
  }
  for (const PrintedRule& rule : other) {
    if (std::ranges::none_of(rules, same_slot(rule))) lines.push_back({rule.kind, rule.slot, "none", {}, ""});
  }
  return lines;
}

std::string markdown_table(std::span<const PrintedRule> rules) {
  std::string text = "| kind | slot | policy | parameters | source |\n|---|---|---|---|---|\n";
  for (const PrintedRule& rule : rules) {
    std::string line = "|";
    for (const std::string& cell : {rule.kind, rule.slot, rule.policy, params_text(rule.params), rule.source}) {
      line += " " + markdown_text(cell) + " |";
    }
    text += line + "\n";
  }
  return text;
}

std::string latex_table(std::span<const PrintedRule> rules) {
  std::string text =
      "% \\usepackage{booktabs,tabularx}; \\input{} this file in a table, or in a table* of two columns.\n"
      "{\\scriptsize\\setlength{\\tabcolsep}{3pt}\\newcolumntype{L}[1]{>{\\hsize=#1\\hsize\\raggedright\\arraybackslash\\hspace{"
      "0pt}}X}%\n"
      "\\begin{tabularx}{\\linewidth}{@{}L{0.75}L{0.95}L{1.2}L{1.1}@{}}\n\\toprule\nslot & policy & parameters & source \\\\\n";
  std::string kind;
  for (const PrintedRule& rule : rules) {
    if (rule.kind != kind) text += "\\midrule\n\\multicolumn{4}{@{}l}{\\itshape " + latex_text(rule.kind) + "} \\\\\n";
    kind = rule.kind;
    text += latex_text(rule.slot) + " & " + latex_text(rule.policy) + " & " + latex_text(params_text(rule.params)) + " & " +
            latex_text(rule.source) + " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabularx}}\n";
}

}  // namespace trophic::command
