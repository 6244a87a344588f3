// SPDX-License-Identifier: MIT
// Definitions of run_metrics.hpp.
#include <tools/analysis/metrics/run_metrics.hpp>

#include <tools/analysis/metrics/attribution.hpp>
#include <tools/analysis/metrics/demography.hpp>
#include <tools/analysis/metrics/stuck.hpp>
#include <tools/analysis/metrics/tag_symmetry.hpp>
#include <tools/analysis/metrics/velocity.hpp>
#include <tools/analysis/metrics/wall_sticking.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::analysis {

namespace {

constexpr std::array<Group, 3> groups{Group::all, Group::random, Group::inherited};
constexpr std::array<Group, 4> groups_with_active{Group::all, Group::random, Group::inherited, Group::active};

void measure_attribution(Events events, const FoodWeb& web, RunMetrics& result) {
  const Baseline two_thirds{"two_thirds", Role::paper, attribution_paper_baseline};
  for (Species species = 0; species < web.size(); ++species) {
    const auto add = [&](const char* metric, std::optional<double> value) {
      result.measurements.push_back({{metric, web.name(species), "all", "1"}, value, {two_thirds}});
    };
    if (web.is_hunted(species)) {
      add("attribution_caught", attribution_caught(events, species));
      add("attribution_died", attribution_died(events, species));
    }
    if (web.hunts(species)) {
      add("attribution_catches", attribution_catches(events, species));
      add("attribution_catchers", attribution_catchers(events, species));
      add("attribution_credited", attribution_credited(events, web, species));
    }
  }
}

void measure_deaths(Events events, const FoodWeb& web, double until_s, RunMetrics& result) {
  for (Species species = 0; species < web.size(); ++species) {
    const auto add = [&](std::string_view group, std::optional<Cause> cause) {
      const MetricName metric{"deaths", web.name(species), std::string{group}, "1"};
      const std::optional<double> count =
          events.empty() ? std::nullopt : std::optional{static_cast<double>(deaths(events, species, cause))};
      result.measurements.push_back({metric, count, {}});
      result.curves.push_back({metric, "", events.empty() ? Series{} : deaths_per_window(events, species, cause, until_s)});
    };
    add("all", std::nullopt);
    for (std::size_t cause = 0; cause < static_cast<std::size_t>(Cause::diverged); ++cause) {  // those of rules
      add(enum_names(Cause{})[cause], static_cast<Cause>(cause));
    }
  }
}

void measure_velocity(const std::string& metric, const std::vector<VelocitySample>& samples, const FoodWeb& web,
                      RunMetrics& result) {
  for (Species species = 0; species < web.size(); ++species) {
    for (const Group group : groups_with_active) {
      const MetricName name{metric, web.name(species), std::string{enum_name(group)}, "m/s"};
      const WindowMean observed = velocity(samples, species, group);
      result.measurements.push_back({name, observed.mean_of_points(), {{"zero", Role::paper, 0.0}}});
      result.curves.push_back({name, "", observed.series()});
    }
  }
}

void measure_walls(Agents agents, const FoodWeb& web, double half_side_m, RunMetrics& result) {
  std::vector<std::optional<double>> of_all;
  std::vector<std::optional<double>> of_active;
  for (Species species = 0; species < web.size(); ++species) {
    for (const Group group : groups_with_active) {
      const MetricName metric{"wall_sticking", web.name(species), std::string{enum_name(group)}, "1"};
      const WindowMean sticking = wall_sticking(agents, species, group, half_side_m);
      result.measurements.push_back(
          {metric, sticking.mean(), {{"uniform_density", Role::reference, wall_share_of_floor(half_side_m)}}});
      result.curves.push_back({metric, "", sticking.series()});
      if (group == Group::all) of_all.push_back(sticking.mean());
      if (group == Group::active) of_active.push_back(sticking.mean());
    }
  }
  for (const auto& [hunter, victim] : web.links()) {
    for (const auto& [group, shares] : {std::pair{Group::all, &of_all}, std::pair{Group::active, &of_active}}) {
      const MetricName metric{"wall_sticking_gap", web.name(victim) + "-" + web.name(hunter), std::string{enum_name(group)}, "1"};
      std::optional<double> gap;
      if ((*shares)[victim] && (*shares)[hunter]) gap = *(*shares)[victim] - *(*shares)[hunter];
      result.measurements.push_back({metric, gap, {{"zero", Role::reference, 0.0}}});
    }
  }
}

void measure_tags(Agents agents, const FoodWeb& web, RunMetrics& result) {
  Rng rng{0, Stream::null_model};
  const double uniform_pairs = uniform_pair_symmetry(rng);
  for (const auto& [hunter, victim] : web.links()) {
    for (const Group group : {Group::inherited, Group::inherited_active}) {
      const MetricName metric{"tag_symmetry", web.name(victim) + "+" + web.name(hunter), std::string{enum_name(group)}, "1"};
      const TagSymmetry symmetry = tag_symmetry(agents, victim, hunter, group);
      result.measurements.push_back({metric,
                                     symmetry.observed.mean(),
                                     {{"permuted_tags", Role::null, symmetry.permuted.mean()},
                                      {"uniform_pairs", Role::paper, uniform_pairs},
                                      {"bernoulli_tags", Role::reference, symmetry.bernoulli_tags.mean()}}});
      result.curves.push_back({metric, "", symmetry.observed.series()});
      result.curves.push_back({metric, "permuted_tags", symmetry.permuted.series()});
      result.curves.push_back({metric, "bernoulli_tags", symmetry.bernoulli_tags.series()});
    }
  }
}

void measure_populations(Agents agents, const FoodWeb& web, RunMetrics& result) {
  const auto add = [&](MetricName metric, const WindowMean& mean) {
    result.measurements.push_back({metric, mean.mean(), {}});
    result.curves.push_back({std::move(metric), "", mean.series()});
  };
  for (Species species = 0; species < web.size(); ++species) {
    for (const Group group : groups) {
      add({"population", web.name(species), std::string{enum_name(group)}, "1"}, population_size(agents, species, group));
    }
    if (!web.hunts(species)) continue;
    add({"hunger", web.name(species), "all", "ticks"}, hunger(agents, species));
    add({"ticks_at", web.name(species), std::to_string(crowd_at_floor), "1"}, ticks_at(agents, species, crowd_at_floor));
  }
}

void measure_stuck(Agents agents, const FoodWeb& web, RunMetrics& result) {
  const auto add = [&](const std::string& of, const WindowMean& mean) {
    const MetricName metric{"stuck", of, "all", "1"};
    result.measurements.push_back({metric, mean.mean(), {}});
    result.curves.push_back({metric, "", mean.series()});
  };
  for (Species species = 0; species < web.size(); ++species) add(web.name(species), stuck(agents, species));
  add("all", stuck(agents, std::nullopt));
}

}  // namespace

std::string lost_to_thinning(std::int64_t every) {
  if (every == 1) return {};
  std::string lost = "no velocity_stored, which needs every tick";
  const auto add = [&](const std::string& metric, std::int64_t apart) {
    if (apart % every != 0) lost += ", no " + metric + ", which needs rows " + std::to_string(apart) + " ticks apart";
  };
  add("velocity", velocity_ticks);
  add("velocity_points", velocity_ticks);
  add("stuck", stuck_ticks);
  return "agents.csv: has the ticks that are multiples of " + std::to_string(every) + ": " + lost;
}

RunMetrics measure_run(const RunData& run) {
  RunMetrics result;
  const Events events = run.events ? Events{*run.events} : Events{};
  const Agents agents = run.agents ? Agents{*run.agents} : Agents{};
  const FoodWeb& web = run.manifest.web;
  measure_attribution(events, web, result);
  measure_deaths(events, web, run.manifest.until_s, result);
  const std::vector<VelocitySample> samples = velocity_samples(agents);
  measure_velocity("velocity", samples, web, result);
  measure_velocity("velocity_points", samples_at_marks(samples, agents), web, result);
  const Agents every_tick = run.manifest.agents_every_ticks == 1 ? agents : Agents{};
  measure_velocity("velocity_stored", stored_velocity_samples(every_tick), web, result);
  measure_walls(agents, web, run.manifest.half_side_m, result);
  measure_tags(agents, web, result);
  measure_populations(agents, web, result);
  measure_stuck(agents, web, result);
  return result;
}

}  // namespace trophic::analysis
