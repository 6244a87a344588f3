// SPDX-License-Identifier: MIT
// Definitions of sweep_status.hpp.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tools/command/check_folder.hpp>
#include <tools/command/output.hpp>
#include <tools/experiment/sweep_status.hpp>
#include <tools/sweep/attempt.hpp>
#include <tools/sweep/claim.hpp>
#include <tools/sweep/plan_file.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>
#include <utility>
#include <vector>

namespace trophic::command {

namespace detail::sweeps {

/// A text of a run's manifest; empty if there is none.
[[nodiscard]] inline std::string manifest_text(const std::filesystem::path& run, const char* key) {
  try {
    const Json json = parse_json_or_null(read_whole_file(run / "manifest.json"));
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
  } catch (const std::invalid_argument&) {
    return "";
  }
}

/// The status of the last attempt at a run that is not complete, as its manifest has it; empty if there was none.
[[nodiscard]] inline std::string last_attempt(const std::filesystem::path& run) {
  const std::string beginning = run.filename().string() + ".attempt-";
  std::string status;
  std::size_t last = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{run.parent_path(), ignored}) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(beginning)) continue;
    const auto number = static_cast<std::size_t>(std::strtoul(name.c_str() + beginning.size(), nullptr, 10));
    if (number < last) continue;
    last = number;
    status = manifest_text(entry.path(), "status");
    if (status.empty()) status = "running";
  }
  return status;
}

/// A line of the first few names.
[[nodiscard]] inline std::string names_line(const std::string& title, const std::vector<std::string>& names) {
  constexpr std::size_t shown = 5;
  std::string line = "  " + title + ": ";
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) line += (i > 0 ? ", " : "") + names[i];
  return line + (names.size() > shown ? ", and " + std::to_string(names.size() - shown) + " more" : "") + "\n";
}

}  // namespace detail::sweeps

int sweep_status(const ExperimentOptions& options) {
  if (options.out.empty()) throw std::invalid_argument{"--status: needs --out, the folder of a sweep"};
  const std::filesystem::path out = options.out;
  check_folder(out);
  if (!std::filesystem::exists(out / sweep::plan_name)) {
    throw std::invalid_argument{options.out + ": is not a sweep's folder: it has no " + std::string{sweep::plan_name}};
  }
  const std::vector<sweep::PlannedRun> plan = sweep::read_plan(out / sweep::plan_name);
  using Kind = std::pair<std::string, std::string>;
  std::map<Kind, double> wall_s;
  std::map<Kind, double> work_done;
  std::map<Kind, double> work_left;
  std::map<std::string, std::vector<std::string>> running;
  std::vector<std::string> failed;
  std::vector<std::string> interrupted;
  std::size_t done = 0;
  std::size_t busy = 0;
  std::size_t missing = 0;
  for (const sweep::PlannedRun& run : plan) {
    const Kind kind{run.rule_table, run.engine};
    if (sweep::is_complete(out, run)) {
      ++done;
      const std::string taken = detail::sweeps::manifest_text(out / run.folder, "wall_s");
      const double seconds = taken.empty() ? 0.0 : std::strtod(taken.c_str(), nullptr);
      if (seconds > 0.0) {
        wall_s[kind] += seconds;
        work_done[kind] += run.work;
      }
      continue;
    }
    work_left[kind] += run.work;
    const std::string who =
        sweep::claimant_of(out / sweep::claims_name, run.index, options.lease_s.value_or(sweep::default_lease_s));
    if (!who.empty()) {
      ++busy;
      running[who].push_back(run.folder.string());
      continue;
    }
    const std::string status = detail::sweeps::last_attempt(out / run.folder);
    if (status.empty()) {
      ++missing;
    } else {
      (status == "failed" ? failed : interrupted).push_back(run.folder.string());
    }
  }
  std::cout << options.out << ": " << plan.size() << " runs: " << done << " done, " << busy << " running, " << failed.size()
            << " failed, " << interrupted.size() << " interrupted, " << missing << " missing\n";
  for (const auto& [who, runs] : running) std::cout << detail::sweeps::names_line("running on " + who, runs);
  if (!failed.empty()) std::cout << detail::sweeps::names_line("failed", failed);
  if (!interrupted.empty()) std::cout << detail::sweeps::names_line("interrupted", interrupted);
  if (done < plan.size()) {
    double left_s = 0.0;
    bool is_known = true;
    for (const auto& [kind, work] : work_left) {
      if (work_done[kind] > 0.0) {
        left_s += work * wall_s[kind] / work_done[kind];
      } else {
        is_known = false;
      }
    }
    std::cout << "left: ";
    if (is_known) {
      std::cout << "about " << observe::duration_text(left_s) << " of one core (" << number_text(std::ceil(left_s / 36.0) / 100.0)
                << " core-hours) by the runs that are done\n";
    } else {
      std::cout << "unknown, as no run of some rule table and engine is done; --dry-run estimates it\n";
    }
  }
  flush_output();
  return 0;
}

}  // namespace trophic::command
