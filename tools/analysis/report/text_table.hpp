// SPDX-License-Identifier: MIT
// Results for people: tables on the terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/summary.hpp>

namespace trophic::analysis {

/// With spaces up to `width`, one at least.
[[nodiscard]] std::string padded(std::string text, std::size_t width);

/// "LABEL on BACKEND, N runs of T s".
[[nodiscard]] std::string described(const RunSet& set);

/// Says what is missing for verdicts where there are too few runs; nothing where there are enough.
void print_too_few(std::ostream& out, const RunSet& set);

/// One line per metric: ours with its 95 % interval over runs (or its spread, where runs are too few) and the paper's value.
/// Below it one line per null with the difference to it, and one per reference without; causes of which nobody died are left out.
void print_table(std::ostream& out, const ShadowedSet& set, std::span<const SummaryRow> rows);

/// One line per metric: a, b, b - a with its 95 % interval and its p value, and the same of what each has over its shadow.
void print_differences(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b, std::span<const SetDifference> differences);

}  // namespace trophic::analysis
