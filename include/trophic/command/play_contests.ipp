// SPDX-License-Identifier: MIT
// Definitions of play_contests.hpp.
#pragma once

#include <atomic>
#include <stdexcept>
#include <trophic/command/backends.hpp>
#include <trophic/command/play_contests.hpp>
#include <trophic/command/toml_of_json.hpp>
#include <trophic/command/words.hpp>
#include <trophic/run/replicates/parallel.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command {

TROPHIC_INLINE std::unique_ptr<AnyExperiment> experiment_of(const contest::Plan& plan, const Offer& offer) {
  auto experiment = Selection{offer.table(plan.rule_table), offer.backend(plan.engine)}.experiment();
  experiment->read(toml_of(plan.params));
  if (std::size_t* threads = experiment->threads()) *threads = 1;
  experiment->check();
  return experiment;
}

TROPHIC_INLINE std::string why_not_played(const contest::Plan& plan, const Offer& offer, const std::string& otherwise) {
  if (offer.table(plan.rule_table) == nullptr) {
    return "rule table " + plan.rule_table + ": must be " + one_of(offer.table_names()) + ", those of this program; " + otherwise;
  }
  if (offer.backend(plan.engine) == nullptr) return about_missing_backend(plan.engine, offer.backend_names());
  const auto description = experiment_of(plan, offer)->simulations(false)(1)->describe(0.0);
  if (plan.fingerprint.empty() || description.fingerprint == plan.fingerprint) return "";
  return "fingerprint " + plan.fingerprint + ": must be " + description.fingerprint +
         ", what this program makes of the runs' numbers; rules, models or engine changed";
}

TROPHIC_INLINE std::vector<contest::Outcome> play(const contest::Plan& plan, const Offer& offer, std::size_t jobs,
                                                  const std::function<void()>& on_match) {
  if (const std::string why = why_not_played(plan, offer); !why.empty()) throw std::invalid_argument{why};
  const MakeContest make = experiment_of(plan, offer)->contests();
  std::vector<contest::Outcome> outcomes(plan.matches.size());
  std::atomic<bool> has_failed = false;
  const auto attempts = replicates::in_parallel(
      outcomes.size(), jobs,
      [&](std::size_t i) {
        try {
          outcomes[i] = contest::play(make, plan, plan.matches[i]);
        } catch (...) {
          has_failed = true;
          throw;
        }
        if (on_match) on_match();
      },
      [&] { return !has_failed; });
  for (const replicates::Attempt& attempt : attempts) {
    if (!attempt.error.empty()) throw std::invalid_argument{attempt.error};
  }
  return outcomes;
}

TROPHIC_INLINE std::filesystem::path outcomes_of(const std::filesystem::path& plan) {
  return plan.string() + ".outcomes";
}

TROPHIC_INLINE int play_contests(const std::filesystem::path& plan, std::size_t jobs, const Offer& offer) {
  check_new_file("--play", outcomes_of(plan).string());
  const auto outcomes = play(contest::read_plan(plan), offer, jobs);
  write_new_file(outcomes_of(plan).string(), contest::text_of(outcomes));
  return 0;
}

}  // namespace trophic::command
