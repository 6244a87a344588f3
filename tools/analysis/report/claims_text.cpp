// SPDX-License-Identifier: MIT
// Definitions of claims_text.hpp.
#include <tools/analysis/report/claims_text.hpp>

#include <string>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/report/text_table.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

void print_reading(std::ostream& out, const ReadingConclusion& each) {
  const MetricName name = metric_of(each.reading);
  const Reading reading{name};
  const auto margin = margin_of(each.reading);
  out << padded("  " + metric_title(name), 48) << padded(reading(each.reading.value), 10)
      << padded(std::string{enum_name(each.reading.source)}, 6) << padded(margin ? reading(*margin) : "-", 8)
      << padded(margin ? std::string{enum_name(each.reading.spread->origin)} : "unknown", 27) << padded(reading.of(each.ours), 28)
      << padded(reading.with_interval(each.difference, each.interval, true), 28) << enum_name(each.conclusion);
  if (each.runs_needed) {
    out << " (about " << *each.runs_needed << " runs would decide)";
  } else if (each.conclusion == Reproduction::inconclusive) {
    out << " (1000 runs would not decide)";
  }
  out << "\n";
}

}  // namespace

void print_claims(std::ostream& out, const RunSet& set, std::span<const ClaimConclusion> conclusions) {
  out << described(set) << ", fingerprint " << set.manifests.front().fingerprint << "\n"
      << padded("claim and its readings", 48) << padded("published", 16) << padded("margin", 8) << padded("margin from", 27)
      << padded("ours [95 %]", 28) << padded("ours - published [95 %]", 28) << "conclusion\n";
  for (const ClaimConclusion& claim : conclusions) {
    out << claim.claim.title << ": " << summary_of(claim) << "\n";
    for (const ReadingConclusion& each : claim.readings) print_reading(out, each);
  }
  out << "reproduced: two one-sided tests at 5 % place ours within the margin of the published system\n"
         "not reproduced: they do not, and ours - published is not 0 at 5 %   inconclusive: neither\n"
         "margin: one standard deviation between runs. The published mean is one of ten runs; its error is in the interval\n"
         "published: text: in the paper; logs: counted in the event logs of its ten runs\n"
         "The paper does not say whether inactive prey count. Leaving them out (active) is an inference: the authors' log marks "
         "them.\n"
         "Each reading is tested alone: a claim with more readings is more easily reproduced under one of them.\n";
  if (set.manifests.front().until_s != published_duration_s) {
    out << "the claims are about runs of " << published_duration_s
        << " s: counts of deaths in other times do not compare (--until)\n";
  }
  print_too_few(out, set);
}

}  // namespace trophic::analysis
