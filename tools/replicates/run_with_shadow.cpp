// SPDX-License-Identifier: MIT
// Definitions of run_with_shadow.hpp.
#include <tools/replicates/run_with_shadow.hpp>

namespace trophic::replicates {

namespace detail {

[[nodiscard]] inline std::vector<std::string> run_and_report(const MakeSimulation& make, double until_s, const Plan& plan,
                                                             const io::Provenance& provenance, std::ostream& out) {
  Outcome outcome = run(make, until_s, plan, provenance, out);
  out << outcome.kept + outcome.complete << " of " << plan.count << " replicates complete in " << plan.out.string() << std::endl;
  return std::move(outcome.unfinished);
}

}  // namespace detail

std::vector<std::string> run_with_shadow(const MakeSimulation& make, const MakeSimulation& shadow, double until_s,
                                         const Plan& plan, const io::Provenance& provenance, std::ostream& out) {
  auto unfinished = detail::run_and_report(make, until_s, plan, provenance, out);
  if (!shadow || !unfinished.empty()) return unfinished;
  Plan beside = plan;
  beside.out /= "shadow";
  unfinished = detail::run_and_report(shadow, until_s, beside, provenance, out);
  for (std::string& sentence : unfinished) sentence.insert(0, "shadow/");
  return unfinished;
}

}  // namespace trophic::replicates
