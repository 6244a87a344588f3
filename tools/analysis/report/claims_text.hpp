// SPDX-License-Identifier: MIT
// Claims for people: each under all of its readings, on the terminal.
#pragma once

#include <ostream>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/claim_conclusion.hpp>

namespace trophic::analysis {

/// For each claim one line that says under which readings it is reproduced, then one line per reading: the published value, the
/// margin and its origin, ours and the difference with 95 % intervals, the conclusion.
void print_claims(std::ostream& out, const RunSet& set, std::span<const ClaimConclusion> conclusions);

}  // namespace trophic::analysis
