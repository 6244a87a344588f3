// SPDX-License-Identifier: MIT
// Definitions of contest_plan.hpp.
#include <tools/contest/contest_plan.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::contest {

namespace detail {

/// Notes when a hunter first is within reach of each victim. Hunters have the first bodies.
class ContactWatch {
 public:
  ContactWatch(const Plan& plan, const Match& match)
      : reach_m_{plan.reach_m},
        hunters_{plan.teams.at(match.hunters).genomes.size()},
        contact_s_(plan.teams.at(match.victims).genomes.size()) {}

  void on_tick(const View& view) {
    for (std::size_t victim = 0; victim < contact_s_.size(); ++victim) {
      if (contact_s_[victim]) continue;
      for (BodyIndex hunter = 0; hunter < hunters_; ++hunter) {
        if (view.distance_m(hunter, hunters_ + victim) > reach_m_) continue;
        contact_s_[victim] = view.time_s;
        break;
      }
    }
  }
  [[nodiscard]] bool keep_running() const {
    return !std::ranges::all_of(contact_s_, [](const auto& contact) { return contact.has_value(); });
  }

  [[nodiscard]] Outcome outcome(double duration_s) const {
    Outcome outcome;
    for (const std::optional<double>& contact_s : contact_s_) {
      outcome.contact_s += std::min(contact_s.value_or(duration_s), duration_s);
      outcome.contacted += contact_s ? 1.0 : 0.0;
    }
    const auto victims = static_cast<double>(contact_s_.size());
    return {.contact_s = outcome.contact_s / victims, .contacted = outcome.contacted / victims};
  }

 private:
  double reach_m_;
  std::size_t hunters_;
  std::vector<std::optional<double>> contact_s_;
};

}  // namespace detail

Lineup lineup_of(const Plan& plan, const Match& match) {
  Lineup lineup;
  for (const std::size_t number : {match.hunters, match.victims}) {
    const Team& team = plan.teams.at(number);
    for (const Genome& genome : team.genomes) lineup.push_back({.species = team.species, .genome = genome});
  }
  return lineup;
}

Outcome play(const MakeContest& make, const Plan& plan, const Match& match, const replicates::StopOnSignal* stop,
             const std::filesystem::path& run) {
  const std::unique_ptr<Simulation> arena = make(match.places, lineup_of(plan, match));
  detail::ContactWatch watch{plan, match};
  const auto meet = [&](auto&... observers) {
    if (stop == nullptr) {
      arena->run_until(plan.duration_s, watch, observers...);
    } else {
      arena->run_until(plan.duration_s, watch, *stop, observers...);
    }
  };
  if (run.empty()) {
    meet();
  } else {
    io::RunFolder folder{run, {}, {.replay_hz = plan.record_hz}};
    meet(folder);
  }
  return watch.outcome(plan.duration_s);
}

Plan read_plan(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& what) { throw std::invalid_argument{path.string() + ": " + what}; };
  const auto read = [&](const Json& json) {
    if (json.value("format", "") != "trophic contests") refuse("is not a plan of contests, which trophic contest writes");
    if (const auto version = whole_number<std::int64_t>(json, "version"); version != 1) {
      refuse("version = " + std::to_string(version) + ": must be 1, which this program writes");
    }
    Plan plan{.rule_table = json.at("rule_table").get<std::string>(),
              .engine = json.at("engine").get<std::string>(),
              .fingerprint = json.at("fingerprint").get<std::string>(),
              .params = json.at("params"),
              .duration_s = json.at("duration_s").get<double>(),
              .reach_m = json.at("reach_m").get<double>(),
              .record_hz = json.value("record_hz", 0.0)};
    for (const Json& team : json.at("teams")) {
      plan.teams.push_back({.species = whole_number<Species>(team, "species")});
      for (const auto& [weights, gait, body, traits] : team.at("genomes").get<std::vector<std::array<std::vector<double>, 4>>>())
        plan.teams.back().genomes.push_back({.weights = weights, .gait_genes = gait, .body_genes = body, .traits = traits});
    }
    for (const Json& match : json.at("matches")) {
      plan.matches.push_back({.hunters = match.at(0).get<std::size_t>(),
                              .victims = match.at(1).get<std::size_t>(),
                              .places = match.at(2).get<std::uint64_t>()});
    }
    return plan;
  };
  const Plan plan = [&] {
    try {
      return read(parse_json(read_whole_file(path)));
    } catch (const Json::exception& error) {
      throw std::invalid_argument{path.string() + ": " + reason_of(error)};
    }
  }();
  if (!(plan.duration_s > 0.0 && plan.duration_s <= longest_run_s))
    refuse("duration_s: must be > 0 and <= " + number_text(longest_run_s));
  if (!(plan.reach_m > 0.0)) refuse("reach_m: must be > 0");
  for (const Match& match : plan.matches) {
    if (std::max(match.hunters, match.victims) >= plan.teams.size()) refuse("matches: a team does not exist");
  }
  for (const Team& team : plan.teams) {
    if (team.genomes.empty()) refuse("teams: each must have individuals");
  }
  return plan;
}

std::string text_of(const std::vector<Outcome>& outcomes) {
  Json json = Json::array();
  for (const Outcome& one : outcomes) json.push_back({one.contact_s, one.contacted});
  return json_text(json) + "\n";
}

}  // namespace trophic::contest
