// SPDX-License-Identifier: MIT
// Definitions of run_with_nulls.hpp.
#include <tools/command/output.hpp>
#include <tools/replicates/run_with_nulls.hpp>

namespace trophic::replicates {

std::vector<std::string> run_with_nulls(std::span<const SetOfRuns> sets, double until_s, const Plan& plan,
                                        const io::Provenance& provenance, std::ostream& out) {
  for (const SetOfRuns& set : sets) {
    Plan own = plan;
    if (set.null != Null::none) own.out /= name_of(set.null);
    Outcome outcome = run(set.make, until_s, own, provenance, out);
    out << outcome.kept + outcome.complete << " of " << own.count << " replicates complete in " << command::shown(own.out)
        << std::endl;
    if (outcome.unfinished.empty()) continue;
    if (set.null != Null::none)
      for (std::string& sentence : outcome.unfinished) sentence.insert(0, name_of(set.null) + "/");
    return std::move(outcome.unfinished);
  }
  return {};
}

}  // namespace trophic::replicates
