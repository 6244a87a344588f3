// SPDX-License-Identifier: MIT
// Definitions of run.hpp.
#include <filesystem>
#include <tools/replicates/folder.hpp>
#include <tools/replicates/parallel.hpp>
#include <tools/replicates/run.hpp>
#include <trophic/observe/print_remarks.hpp>
#include <trophic/support/unreadable_file.hpp>

namespace trophic::replicates {

namespace detail {

/// The status of a run that has ended, or why it cannot be read.
[[nodiscard]] inline std::string status_or_why(const std::filesystem::path& folder) {
  try {
    return status_of(folder);
  } catch (const UnreadableFile& error) {
    return error.what();
  }
}

}  // namespace detail

Outcome run_pending(const Plan& plan, const observe::RunDescription& run, const io::Provenance& provenance, std::ostream& out,
                    const RunOne& run_one) {
  const Folder folder{plan, run, provenance};
  observe::print_remarks(run.remarks);
  for (const std::string& remark : folder.remarks()) out << remark << "\n";
  if (folder.kept() > 0) out << folder.kept() << " of " << plan.count << " are complete already and are kept" << std::endl;

  const auto& pending = folder.pending();
  const replicates::StopOnSignal stop;
  replicates::JointProgress progress{pending.size(), run.until_s, out};
  const auto work = [&](std::size_t i) {
    const Replicate& replicate = pending[i];
    CommonOptions common{provenance, plan.checkpoints, plan.output, plan.snapshot, plan.own_tables};
    common.provenance.emplace_back("master_seed", std::to_string(plan.master_seed));
    common.provenance.emplace_back("replicate", std::to_string(replicate.index));
    run_one(replicate, common, progress.watch(name_of(replicate.index)), stop);
  };
  const auto attempts = in_parallel(pending.size(), plan.jobs, work, [&] { return stop.keep_running(); });

  Outcome outcome{.kept = folder.kept(), .complete = 0, .unfinished = {}};
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const std::string name = name_of(pending[i].index);
    const std::string status = detail::status_or_why(pending[i].folder);
    if (!attempts[i].started) {
      outcome.unfinished.push_back(name + ": not started");
    } else if (!attempts[i].error.empty()) {
      outcome.unfinished.push_back(name + ": " + attempts[i].error);
    } else if (status != "complete") {
      outcome.unfinished.push_back(name + ": " + status);
    } else {
      ++outcome.complete;
    }
  }
  return outcome;
}

}  // namespace trophic::replicates
