// SPDX-License-Identifier: MIT
// Definitions of printed_rules.hpp.
#include <tools/experiment/printed_rules.hpp>

#include <algorithm>

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

/// A text as Markdown shows it letter by letter.
std::string markdown_text(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (std::string_view{"\\`*_<>[]|~"}.find(letter) != std::string_view::npos) escaped += '\\';
    escaped += letter;
  }
  return escaped;
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

}  // namespace trophic::command
