// SPDX-License-Identifier: MIT
// Prints a rule table for readers: the policy in each slot, with its parameters and source.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/physics.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/rules/printed_rules.hpp>
#include <trophic/rules/table.hpp>
#include <variant>
#include <vector>

namespace trophic::rules {

namespace detail {

[[nodiscard]] inline std::string short_value(const NamedParam& param) {
  const double* number = std::get_if<double>(&param.value);
  if (number == nullptr) return value_text(param);
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *number, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

template <class Params>
[[nodiscard]] PrintedNumbers printed_numbers(const Params& params) {
  PrintedNumbers numbers;
  for (const NamedParam& param : named_params_of(params)) {
    if (const std::string value = short_value(param); !value.empty()) numbers.emplace_back(param.path, value);
  }
  return numbers;
}

}  // namespace detail

/// One line for each slot of a table with a policy other than its neutral one, then one for ecology and one for physics, with
/// the given parameters or the table's own.
template <class Rules>
[[nodiscard]] std::vector<PrintedRule> printed_rules(const RuleParams<Rules>& params = {},
                                                     const EcologyParams& ecology = Rules::ecology(),
                                                     const Physics& physics = Rules::physics()) {
  std::vector<PrintedRule> lines;
  for_each_slot([&]<RuleSlot slot>() {
    using Policy = PolicyIn<Rules, slot>;
    if constexpr (!is_neutral<Rules, slot>) {
      lines.push_back({std::string{slot_kind(slot)}, std::string{slot_name(slot)}, std::string{Policy::name},
                       detail::printed_numbers(of_slot<slot>(params)), std::string{source_of<Policy>()}});
    }
  });
  lines.push_back({"ecology", "", "", detail::printed_numbers(ecology), ""});
  lines.push_back({"physics", "", "", detail::printed_numbers(physics), ""});
  return lines;
}

/// The table as Markdown.
template <class Rules>
[[nodiscard]] std::string markdown_table(const RuleParams<Rules>& params = {}, const EcologyParams& ecology = Rules::ecology(),
                                         const Physics& physics = Rules::physics()) {
  return markdown_table(printed_rules<Rules>(params, ecology, physics));
}

/// The table as LaTeX.
template <class Rules>
[[nodiscard]] std::string latex_table(const RuleParams<Rules>& params = {}, const EcologyParams& ecology = Rules::ecology(),
                                      const Physics& physics = Rules::physics()) {
  return latex_table(printed_rules<Rules>(params, ecology, physics));
}

}  // namespace trophic::rules
