// SPDX-License-Identifier: MIT
// Definitions of play_contests.hpp.
#include <algorithm>
#include <atomic>
#include <tools/command/backends.hpp>
#include <tools/command/output.hpp>
#include <tools/command/read_parameters.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/toml_of_json.hpp>
#include <tools/command/words.hpp>
#include <tools/contest/play_contests.hpp>
#include <tools/replicates/parallel.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command {

std::unique_ptr<AnyExperiment> experiment_of(const contest::Plan& plan, const Offer& offer) {
  auto experiment = find_experiment(offer, plan.rule_table, plan.engine);
  read_parameters(experiment->params(), toml_of(plan.params));
  if (std::size_t* threads = experiment->backend().threads()) *threads = 1;
  validate(experiment->params());
  return experiment;
}

std::string why_not_played(const contest::Plan& plan, const Offer& offer, const std::string& otherwise) {
  const std::vector<std::string> tables = table_names(offer);
  if (std::ranges::find(tables, plan.rule_table) == tables.end()) {
    return "rule table " + plan.rule_table + ": must be " + one_of(tables) + ", those of this program; " + otherwise;
  }
  if (find_backend(offer, plan.engine) == nullptr) return about_missing_backend(plan.engine, backend_names(offer.backends));
  const auto fingerprint_of = [&](const Null& null) {
    return experiment_of(plan, offer)->simulations(null)(1)->describe(0.0).fingerprint;
  };
  if (plan.fingerprint.empty() || plan.fingerprint == fingerprint_of(Null::none)) return "";
  if (plan.fingerprint == fingerprint_of(Null::shadow)) return "";
  const FoodWeb web = experiment_of(plan, offer)->simulations(Null::none)(1)->view().web;
  for (Species species = 0; web.size() > 1 && species < web.size(); ++species)
    if (plan.fingerprint == fingerprint_of({Null::one_sided, web.name(species)})) return "";
  return "fingerprint " + plan.fingerprint + ": must be " + fingerprint_of(Null::none) +
         ", which this program computes from the runs' parameters; rules, models or engine changed";
}

int play_contests(const std::filesystem::path& path, std::size_t jobs, const Offer& offer) {
  const std::string out = path.string() + ".outcomes";
  check_new_file("--play", out);
  if (jobs == 0) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  const contest::Plan plan = contest::read_plan(path);
  if (const std::string why = why_not_played(plan, offer); !why.empty()) throw std::invalid_argument{why};
  const MakeContest make = experiment_of(plan, offer)->contests();
  std::vector<contest::Outcome> outcomes(plan.matches.size());
  const std::filesystem::path runs = plan.record_hz > 0.0 ? path.string() + ".runs" : "";
  if (!runs.empty()) static_cast<void>(io::make_new_folder(runs));
  const replicates::StopOnSignal stop;
  std::atomic<bool> has_failed = false;
  const auto attempts = replicates::in_parallel(
      outcomes.size(), jobs,
      [&](std::size_t i) {
        try {
          outcomes[i] = contest::play(make, plan, plan.matches[i], &stop, runs.empty() ? runs : runs / std::to_string(i));
        } catch (...) {
          has_failed = true;
          throw;
        }
      },
      [&] { return !has_failed && stop.keep_running(); });
  for (const replicates::Attempt& attempt : attempts) {
    if (!attempt.error.empty()) throw std::invalid_argument{attempt.error};
  }
  if (!stop.keep_running()) return stopped;
  write_new_file(out, contest::text_of(outcomes));
  return 0;
}

}  // namespace trophic::command
