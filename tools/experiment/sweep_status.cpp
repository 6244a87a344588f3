// SPDX-License-Identifier: MIT
// Definitions of sweep_status.hpp.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <span>
#include <tools/command/check_folder.hpp>
#include <tools/command/output.hpp>
#include <tools/experiment/sweep_status.hpp>
#include <tools/sweep/make_run.hpp>
#include <tools/sweep/plan_file.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>
#include <vector>

namespace trophic::command {

namespace detail::sweeps {

/// The wall time in a run's manifest; empty if there is none.
[[nodiscard]] inline std::string wall_s_text(const std::filesystem::path& run) {
  try {
    const Json json = parse_json_or_null(read_whole_file(run / "manifest.json"));
    return json.is_object() && json.contains("wall_s") && json["wall_s"].is_string() ? json["wall_s"].get<std::string>() : "";
  } catch (const std::invalid_argument&) {
    return "";
  }
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
  std::map<sweep::Stage, std::vector<std::string>> runs;
  for (const sweep::PlannedRun& run : plan) {
    const Kind kind{run.rule_table, run.engine};
    const sweep::Stage stage = sweep::stage_of(out, run, !options.no_verify);
    runs[stage].push_back(run.folder.string());
    if (stage != sweep::Stage::complete) {
      work_left[kind] += run.work;
      continue;
    }
    const double seconds = std::strtod(detail::sweeps::wall_s_text(out / run.folder).c_str(), nullptr);
    if (seconds > 0.0) {
      wall_s[kind] += seconds;
      work_done[kind] += run.work;
    }
  }
  const std::array stages{std::pair{sweep::Stage::complete, "done"}, std::pair{sweep::Stage::running, "running"},
                          std::pair{sweep::Stage::failed, "failed"}, std::pair{sweep::Stage::interrupted, "interrupted"},
                          std::pair{sweep::Stage::missing, "missing"}};
  std::cout << options.out << ": " << plan.size() << " runs";
  for (const auto& [stage, name] : stages) {
    std::cout << (stage == sweep::Stage::complete ? ": " : ", ") << runs[stage].size() << " " << name;
  }
  std::cout << "\n";
  for (const auto& [stage, name] : std::span{stages}.subspan(1, 3)) {
    if (!runs[stage].empty()) std::cout << detail::sweeps::names_line(name, runs[stage]);
  }
  if (runs[sweep::Stage::complete].size() < plan.size()) {
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
