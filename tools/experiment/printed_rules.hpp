// SPDX-License-Identifier: MIT
// A rule table for readers: the policy in each slot, with its parameters and source.
#pragma once

#include <trophic/params/named_params.hpp>
#include <trophic/rules/slot_rule.hpp>

namespace trophic::command {

/// Names of parameters and their values, floating-point numbers to six digits; manifests have them exactly.
using PrintedParams = std::vector<std::pair<std::string, std::string>>;

/// A line of a printed table.
struct PrintedRule {
  std::string kind;  ///< perception, control, reproduction, death, ...
  std::string slot;
  std::string policy;
  PrintedParams params;
  std::string source;  ///< the policy's own `source`; empty if it names none
};

/// One line for each rule, then one for ecology and one for physics. `params`: all parameters of an experiment.
[[nodiscard]] std::vector<PrintedRule> printed_rules(std::span<const rules::SlotRule> rules, const NamedParams& params);

/// "cool_down_s = 50, ...".
[[nodiscard]] std::string params_text(const PrintedParams& params);

[[nodiscard]] std::string markdown_table(std::span<const PrintedRule> rules);

}  // namespace trophic::command
