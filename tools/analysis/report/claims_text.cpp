// SPDX-License-Identifier: MIT
// Definitions of claims_text.hpp.
#include <tools/analysis/report/claims_text.hpp>

#include <tools/analysis/report/columns.hpp>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/report/text_table.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

std::vector<std::string> line_of(const ReadingConclusion& each) {
  const MetricName name = metric_of(each.reading);
  const Reading reading{name};
  const auto margin = margin_of(each.reading);
  std::string conclusion{enum_name(each.conclusion)};
  if (each.runs_needed) {
    conclusion += " (about " + std::to_string(*each.runs_needed) + " runs would decide)";
  } else if (each.conclusion == Reproduction::inconclusive) {
    conclusion += " (1000 runs would not decide)";
  }
  return {"  " + metric_title(name),
          reading(each.reading.value),
          std::string{enum_name(each.reading.source)},
          margin ? reading(*margin) : "-",
          margin ? std::string{enum_name(each.reading.spread->origin)} : "unknown",
          reading.of(each.ours),
          reading.with_interval(each.difference, each.interval, true),
          conclusion};
}

/// The published system, and how this set differs from it.
std::string what_was_published(const RunSet& set) {
  const RunManifest& manifest = set.manifests.front();
  const std::string published =
      "published: ten runs of `released` with bodies in MuJoCo, " + number_text(published_duration_s) + " s";
  const bool points = manifest.backend.starts_with("kinematic");
  if (points) return published + "; these are points without bodies, so velocities and walls compare the rules only";
  if (manifest.rules == "released" && manifest.backend.starts_with("mujoco")) return published + ", as here";
  return published + "; here: " + manifest.rules + " on " + manifest.backend;
}

}  // namespace

void print_claims(std::ostream& out, const RunSet& set, std::span<const ClaimConclusion> conclusions) {
  out << described(set) << ", fingerprint " << set.manifests.front().fingerprint << "\n" << what_was_published(set) << "\n";
  Columns columns{{"claim and its readings", "published", "", "margin", "margin from", "ours [95 %]", "ours - published [95 %]",
                   "conclusion"}};
  for (const ClaimConclusion& claim : conclusions) {
    columns.add({std::string{claim.claim.title} + ": " + summary_of(claim)});
    for (const ReadingConclusion& each : claim.readings) columns.add(line_of(each));
  }
  columns.print(out);
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
