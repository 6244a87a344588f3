// SPDX-License-Identifier: MIT
// Results for people: tables on the terminal.
#pragma once

#include <ostream>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/summary.hpp>

namespace trophic::analysis {

/// "LABEL on BACKEND, N runs of T s".
[[nodiscard]] std::string described(const RunSet& set);

/// Says how many runs a test needs if there are too few; nothing otherwise.
void print_too_few(std::ostream& out, const RunSet& set);

/// The findings: the five clearest differences between ours and a null, then the three inconclusive ones that would need the
/// fewest runs. Prints the whole table if no null was given or nothing can be tested.
void print_findings(std::ostream& out, const ShadowedSet& set, std::span<const SummaryRow> rows);

/// The whole table. One line per metric: ours with its 95 % interval over runs (or its spread, if runs are too few) and the
/// paper's value. Below it one line per null with the difference and its test, and one per reference without; causes from which
/// no individual died are left out.
void print_table(std::ostream& out, const ShadowedSet& set, std::span<const SummaryRow> rows);

/// The findings of a comparison: the column that answers, its five clearest differences and the three inconclusive ones that
/// would need the fewest runs.
void print_difference_findings(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b,
                               std::span<const SetDifference> differences);

/// The whole comparison. One line per metric: a, b, b - a with its 95 % interval and test, and the same of what each has over its
/// shadow.
void print_differences(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b, std::span<const SetDifference> differences);

}  // namespace trophic::analysis
