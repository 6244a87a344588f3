// SPDX-License-Identifier: MIT
// Definitions of planned_contests.hpp.
#include "planned_contests.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tools/contest/contest_design.hpp>
#include <tools/reading/epoch_genomes.hpp>
#include <tools/reading/pooled_runs.hpp>
#include <tools/reading/shadow.hpp>
#include <trophic/params/params.hpp>

namespace trophic::command::contests {

using analysis::LivingGenome;
using analysis::RunManifest;
using contest::Against;

namespace {

constexpr std::size_t default_epochs = 4;

/// Teams of one set of runs, each drawn when first asked for.
class Teams {
 public:
  Teams(std::span<const RunManifest> runs, const Size& size, bool is_shadow, const contest::ContestDesign& design,
        contest::Plan& plan)
      : runs_{runs}, size_{size}, is_shadow_{is_shadow}, design_{design}, plan_{plan} {
    for (const RunManifest& run : runs) living_.push_back(analysis::living_genomes(run, size.epochs_s));
  }

  /// The number of the team in the plan.
  std::size_t operator()(const contest::TeamName& name) {
    const auto [found, is_new] = places_.try_emplace({name.replicate, name.epoch, name.species, name.team}, plan_.teams.size());
    if (is_new) plan_.teams.push_back(drawn(name));
    return found->second;
  }

 private:
  [[nodiscard]] contest::Team drawn(const contest::TeamName& name) const {
    std::vector<const LivingGenome*> members;
    for (const LivingGenome& one : living_[name.replicate][name.epoch])
      if (one.species == name.species) members.push_back(&one);
    if (members.empty()) {
      const RunManifest& run = runs_[name.replicate];
      throw std::invalid_argument{run.folder.string() + ": no " + run.web.name(name.species) + " is alive at " +
                                  number_text(size_.epochs_s[name.epoch]) + " s, an epoch"};
    }
    contest::Team team{.species = name.species};
    for (const std::size_t i : design_.members(name, is_shadow_, members.size(), size_.team_size))
      team.genomes.push_back(members[i]->genome);
    return team;
  }

  std::span<const RunManifest> runs_;
  const Size& size_;
  bool is_shadow_;
  const contest::ContestDesign& design_;
  contest::Plan& plan_;
  std::vector<std::vector<std::vector<LivingGenome>>> living_;  ///< by run and epoch
  std::map<std::tuple<std::size_t, std::size_t, Species, std::size_t>, std::size_t> places_;
};

/// The shadow's teams meet in the arena of the table that it is the shadow of.
std::string table_of(const RunManifest& run) {
  return run.rules.substr(0, run.rules.find(" with heredity = nothing_inherited"));
}

/// The table, and whether the runs were only screened.
std::string kind_of(const RunManifest& run) {
  const std::string stepping = run.params.value(Json::json_pointer{"/backend/stepping"}, std::string{});
  return table_of(run) + (stepping == "screening" ? " with backend.stepping = screening" : "");
}

/// Each team meets the last living of one run of the panel, the same in all epochs, sets and studies.
void add_panel_matches(std::span<const RunManifest> runs, const Size& size, std::span<const RunManifest> panel, Teams& teams,
                       const contest::ContestDesign& design, bool is_shadow, Planned& planned) {
  const Size last{.epochs_s = {panel.front().reached_s.value_or(0.0)}, .against = {}, .team_size = size.team_size};
  const contest::ContestDesign of_panel{size.seed, panel.size(), size.teams};
  Teams opponents{panel, last, false, of_panel, planned.plan};
  const FoodWeb& web = runs.front().web;
  for (const Feeding& link : web.links()) {
    for (std::size_t cell = 0; cell < runs.size() * size.teams * size.epochs_s.size() * 2; ++cell) {
      const bool hunts = cell % 2 == 0;
      const std::size_t epoch = cell / 2 % size.epochs_s.size();
      const std::size_t team = cell / 2 / size.epochs_s.size() % size.teams;
      const std::size_t replicate = cell / 2 / size.epochs_s.size() / size.teams;
      const std::size_t other = (replicate + team) % panel.size();
      const std::size_t own =
          teams({.replicate = replicate, .epoch = epoch, .species = hunts ? link.hunter : link.victim, .team = team});
      const std::size_t theirs = opponents({.replicate = other, .species = hunts ? link.victim : link.hunter, .team = team});
      planned.plan.matches.push_back(
          {.hunters = hunts ? own : theirs, .victims = hunts ? theirs : own, .places = design.places(replicate, team)});
      const auto folder = [&](bool ours) { return (ours ? runs[replicate] : panel[other]).folder.string(); };
      const auto epoch_s = [&](bool ours) { return ours ? size.epochs_s[epoch] : last.epochs_s.front(); };
      planned.rows.push_back({.shadow = is_shadow,
                              .against = hunts ? Against::panel_victims : Against::panel_hunters,
                              .hunters_run = folder(hunts),
                              .victims_run = folder(!hunts),
                              .team = team,
                              .hunter = web.name(link.hunter),
                              .victim = web.name(link.victim),
                              .hunter_epoch_s = epoch_s(hunts),
                              .victim_epoch_s = epoch_s(!hunts)});
    }
  }
}

void add_matches(const Sets& sets, const Size& size, bool is_shadow, Planned& planned) {
  const std::span<const RunManifest> runs = is_shadow ? sets.shadow : sets.ours;
  if (runs.empty()) return;
  const contest::ContestDesign design{size.seed, runs.size(), size.teams};
  Teams teams{runs, size, is_shadow, design, planned.plan};
  if (!sets.panel.empty()) return add_panel_matches(runs, size, sets.panel, teams, design, is_shadow, planned);
  const FoodWeb& web = runs.front().web;
  const std::size_t epochs = size.epochs_s.size();
  for (const Feeding& link : web.links()) {
    for (const Against against : size.against) {
      for (std::size_t replicate = 0; replicate < runs.size(); ++replicate) {
        for (std::size_t team = 0; team < size.teams; ++team) {
          const std::size_t other = against == Against::own ? replicate : design.partner(replicate, team);
          for (std::size_t cell = 0; cell < epochs * epochs; ++cell) {
            const std::size_t p = cell / epochs;
            const std::size_t q = cell % epochs;
            planned.plan.matches.push_back(
                {.hunters = teams({.replicate = replicate, .epoch = p, .species = link.hunter, .team = team}),
                 .victims = teams({.replicate = other, .epoch = q, .species = link.victim, .team = team}),
                 .places = design.places(replicate, team)});
            planned.rows.push_back({.shadow = is_shadow,
                                    .against = against,
                                    .hunters_run = runs[replicate].folder.string(),
                                    .victims_run = runs[other].folder.string(),
                                    .team = team,
                                    .hunter = web.name(link.hunter),
                                    .victim = web.name(link.victim),
                                    .hunter_epoch_s = size.epochs_s[p],
                                    .victim_epoch_s = size.epochs_s[q]});
          }
        }
      }
    }
  }
}

std::vector<double> even_epochs(const RunManifest& run) {
  std::vector<double> epochs_s;
  const double last_s = run.reached_s.value_or(0.0);
  for (std::size_t i = 0; i < default_epochs; ++i) {
    epochs_s.push_back(last_s * static_cast<double>(i) / static_cast<double>(default_epochs - 1));
  }
  return epochs_s;
}

void check_epochs(std::span<const double> epochs_s) {
  if (epochs_s.size() < 2)
    throw std::invalid_argument{"--epochs: " + std::to_string(epochs_s.size()) + " epochs: must be at least 2"};
  for (std::size_t i = 0; i < epochs_s.size(); ++i) {
    if (!(epochs_s[i] >= 0.0)) throw std::invalid_argument{"--epochs " + number_text(epochs_s[i]) + ": must be >= 0"};
    if (i > 0 && !(epochs_s[i] > epochs_s[i - 1])) {
      throw std::invalid_argument{"--epochs " + number_text(epochs_s[i]) + ": must be > " + number_text(epochs_s[i - 1]) +
                                  ", the epoch before it"};
    }
  }
}

}  // namespace

Sets read_sets(std::span<const std::filesystem::path> runs, const std::optional<std::filesystem::path>& shadow, bool any_build) {
  for (const std::filesystem::path& path : runs) {
    if (analysis::is_sweep(path)) throw std::invalid_argument{path.string() + ": is a sweep: name one of its cells"};
  }
  auto pooled = analysis::pooled_runs(runs, false, any_build);
  Sets sets{.ours = std::move(pooled.manifests), .shadow = {}, .panel = {}, .remarks = std::move(pooled.remarks)};
  const RunManifest& first = sets.ours.front();
  if (first.web.links().empty())
    throw std::invalid_argument{first.folder.string() +
                                ": no species of this food web hunts: a contest needs hunters and victims"};
  const auto folders = shadow ? std::vector{*shadow} : analysis::null_folders(runs, Null::shadow);
  if (folders.empty()) return sets;
  sets.shadow = analysis::pooled_runs(folders, false, any_build).manifests;
  analysis::check_shadow(first, sets.shadow.front(), true);
  return sets;
}

void add_panel(Sets& sets, const std::filesystem::path& panel, bool any_build) {
  sets.panel = analysis::pooled_runs(std::vector{panel}, false, any_build).manifests;
  const RunManifest& first = sets.panel.front();
  const std::string ours = kind_of(sets.ours.front());
  if (kind_of(first) != ours)
    throw std::invalid_argument{"--panel " + panel.string() + ": has runs of " + kind_of(first) + ": must be of " + ours};
  for (const RunManifest& run : sets.panel) analysis::check_epoch(run, first.reached_s.value_or(0.0));
}

Planned planned_contests(const Sets& sets, Size size) {
  const RunManifest& first = sets.ours.front();
  for (const RunManifest& run : sets.ours) analysis::check_epoch(run, 0.0);
  if (size.epochs_s.empty()) size.epochs_s = even_epochs(first);
  check_epochs(size.epochs_s);
  if (size.team_size == 0) {
    size.team_size = std::max<std::size_t>(1, whole_number<std::size_t>(first.params.at("ecology"), "robots", 1) / 2);
  }
  if (sets.ours.size() < 2 && std::ranges::find(size.against, Against::others) != size.against.end())
    throw std::invalid_argument{"--against others: needs at least two replicates; " + first.folder.string() + " is one"};
  Planned planned{.plan = {.rule_table = table_of(first),
                           .engine = first.backend.substr(0, first.backend.find(' ')),
                           .fingerprint = first.fingerprint,
                           .params = first.params,
                           .duration_s = size.duration_s,
                           .reach_m = size.reach_m},
                  .rows = {}};
  add_matches(sets, size, false, planned);
  add_matches(sets, size, true, planned);
  return planned;
}

}  // namespace trophic::command::contests
