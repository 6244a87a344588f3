// SPDX-License-Identifier: MIT
// Contests that a program is to play: teams, who meets whom, and the experiment whose arena and brains they have.
#pragma once

#include <filesystem>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/ecology/lineup.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/support/json.hpp>

namespace trophic::contest {

/// Individuals of one species, by their genomes, whose ids have no meaning.
struct Team {
  Species species = 0;
  std::vector<Genome> genomes = {};
};

/// Two teams in an arena, at places drawn from a seed.
struct Match {
  std::size_t hunters = 0;  ///< a team of the plan
  std::size_t victims = 0;  ///< another one
  std::uint64_t places = 0;
};

struct Plan {
  std::string rule_table;
  std::string engine;
  std::string fingerprint;       ///< of the runs that the teams are from
  Json params = Json::object();  ///< of these runs, as in their manifests
  double duration_s = 0.0;       ///< of each contest, seconds of the ecology's clock
  double reach_m = 0.0;          ///< a hunter this close to a victim reaches it
  double record_hz = 0.0;        ///< frames per simulated second of each contest that is written as a run; 0: none is
  std::vector<Team> teams = {};
  std::vector<Match> matches = {};
};

/// The result of a match.
struct Outcome {
  double contact_s = 0.0;  ///< mean over victims of the time until a hunter first is within reach, at most the duration
  double contacted = 0.0;  ///< share of the victims that were reached
};

/// The individuals of a match, hunters first.
[[nodiscard]] Lineup lineup_of(const Plan& plan, const Match& match);

/// Lets two teams meet. Throws as the ecology does, and std::invalid_argument for genomes that the brain does not take.
/// `stop`: ends it early, if not null; the outcome is then none. `run`: a new folder for the contest as a run, or empty.
[[nodiscard]] Outcome play(const MakeContest& make, const Plan& plan, const Match& match,
                           const replicates::StopOnSignal* stop = nullptr, const std::filesystem::path& run = {});

/// Reads a plan as `trophic contest` writes it, in JSON. Throws std::invalid_argument naming the file and what is wrong.
[[nodiscard]] Plan read_plan(const std::filesystem::path& path);

/// Outcomes as JSON.
[[nodiscard]] std::string text_of(const std::vector<Outcome>& outcomes);

}  // namespace trophic::contest
