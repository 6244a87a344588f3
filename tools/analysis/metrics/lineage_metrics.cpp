// SPDX-License-Identifier: MIT
// Definitions of lineage_metrics.hpp.
#include <tools/analysis/metrics/lineage_metrics.hpp>

#include <cmath>
#include <map>
#include <tools/analysis/metrics/activity.hpp>
#include <tools/analysis/metrics/descent.hpp>
#include <tools/analysis/metrics/modes.hpp>
#include <tools/reading/drift.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

/// Forests of drift. The activity of a type is compared with that in the first ones, so that the run and the others are compared
/// with the same.
constexpr std::size_t drifts = 4;
constexpr std::size_t nulls_of_activity = 2;

/// Presence is counted so many times in a window.
constexpr std::size_t counts_in_window = 10;

/// A measure over the windows of a run.
struct Track {
  const char* metric;
  const char* unit;
  bool has_halves;  ///< measured as means over the early and the late half of the run, else as one mean
  Series points = {};
};

struct Times {
  std::vector<double> windows_s;  ///< the ends of windows, 0 first
  std::vector<double> counts_s;   ///< at which presence is counted
};

Times times_of(double window_s, double end_s) {
  Times times;
  const auto windows = static_cast<std::size_t>(std::floor(end_s / window_s * (1.0 + 1e-12)));
  for (std::size_t i = 0; i <= windows; ++i) times.windows_s.push_back(window_s * static_cast<double>(i));
  for (std::size_t i = 0; i <= windows * counts_in_window; ++i) {
    times.counts_s.push_back(window_s * static_cast<double>(i) / static_cast<double>(counts_in_window));
  }
  return times;
}

/// A forest with the type of each individual.
struct Typed {
  Forest forest;
  std::vector<Type> types;
};

Typed typed(Forest forest, Signatures& signatures) {
  std::vector<Type> types;
  types.reserve(forest.size());
  for (const Taxon& taxon : forest) types.push_back(signatures.type_of(taxon.species, taxon.weights));
  return {std::move(forest), std::move(types)};
}

std::array<Track, 4> modes_tracks(const Typed& of, Species species, const Signatures& signatures, const Times& times) {
  std::map<std::size_t, double> known;
  const auto complexity = [&](std::size_t place) {
    const auto [found, is_new] = known.try_emplace(place, 0.0);
    if (is_new) found->second = static_cast<double>(signatures.complexity(species, of.forest[place].weights));
    return found->second;
  };
  std::array<Track, 4> tracks{{{"modes_change", "types", true},
                               {"modes_novelty", "types", true},
                               {"modes_ecology", "bits", true},
                               {"modes_complexity", "1", true}}};
  for (const Modes& window : modes_of(of.forest, species, of.types, times.windows_s, complexity)) {
    tracks[0].points.push_back({window.time_s, window.change});
    tracks[1].points.push_back({window.time_s, window.novelty});
    tracks[2].points.push_back({window.time_s, window.ecology});
    tracks[3].points.push_back({window.time_s, window.complexity});
  }
  return tracks;
}

std::array<Track, 4> activity_tracks(const Presence& presence, std::span<const Presence> nulls, const Times& times) {
  const double step_s = times.counts_s[1];
  std::array<Track, 4> tracks{{{"activity_diversity", "types", true},
                               {"activity_mean", "s", true},
                               {"activity_excess", "s", true},
                               {"activity_new", "types", true}}};
  double fresh = 0.0;
  const std::vector<Activity> all = activity_of(presence, nulls);
  for (std::size_t i = 1; i < all.size(); ++i) {
    fresh += all[i].fresh;
    if (i % counts_in_window != 0) continue;
    const double time_s = times.windows_s[i / counts_in_window];
    tracks[0].points.push_back({time_s, all[i].diversity});
    tracks[1].points.push_back({time_s, step_s * all[i].mean});
    tracks[2].points.push_back({time_s, step_s * all[i].excess});
    tracks[3].points.push_back({time_s, fresh});
    fresh = 0.0;
  }
  return tracks;
}

std::array<Track, 7> descent_tracks(const Forest& forest, Species species, const Times& times) {
  std::array<Track, 7> tracks{{{"descent_roots", "1", false},
                               {"descent_largest_clade", "1", false},
                               {"descent_mean_depth", "births", false},
                               {"descent_greatest_depth", "births", false},
                               {"descent_related_pairs", "1", false},
                               {"descent_common_ancestor", "s", false},
                               {"descent_diversity", "s", false}}};
  for (std::size_t i = 1; i < times.windows_s.size(); ++i) {
    const double time_s = times.windows_s[i];
    const std::optional<Descent> descent = descent_of(forest, species, time_s);
    const auto add = [&](std::size_t track, std::optional<double> value) { tracks[track].points.push_back({time_s, value}); };
    const auto add_plain = [&](std::size_t track, double Descent::*value) {
      add(track, descent ? std::optional{(*descent).*value} : std::nullopt);
    };
    add_plain(0, &Descent::roots);
    add_plain(1, &Descent::largest_clade);
    add_plain(2, &Descent::mean_depth);
    add_plain(3, &Descent::greatest_depth);
    add(4, descent ? descent->related_pairs : std::nullopt);
    add(5, descent ? descent->common_ancestor_s : std::nullopt);
    add_plain(6, &Descent::diversity_s);
  }
  return tracks;
}

/// The mean of a series after `from_s` and up to `to_s`.
std::optional<double> mean_between(const Series& series, double from_s, double to_s) {
  Mean mean;
  for (const Point& point : series) {
    if (point.time_s > from_s && point.time_s <= to_s) mean.add(point.value);
  }
  return mean.value();
}

/// The pointwise mean of series of the same times.
Series mean_of_series(std::span<const Track* const> tracks) {
  Series points;
  for (std::size_t i = 0; i < tracks.front()->points.size(); ++i) {
    Mean mean;
    for (const Track* track : tracks) mean.add(track->points[i].value);
    points.push_back({tracks.front()->points[i].time_s, mean.value()});
  }
  return points;
}

struct Half {
  const char* group;
  double from_s;
  double to_s;
};

std::vector<Half> halves_of(const Track& track, double end_s) {
  if (!track.has_halves) return {{"all", 0.0, end_s}};
  return {{"early", 0.0, 0.5 * end_s}, {"late", 0.5 * end_s, end_s}};
}

/// Adds a measure with the same measure in forests of drift.
void add_measure(const Track& ours, std::span<const Track* const> drifted, const std::string& species, double end_s,
                 RunMetrics& result) {
  for (const auto& [group, from_s, to_s] : halves_of(ours, end_s)) {
    Mean drift;
    for (const Track* track : drifted) drift.add(mean_between(track->points, from_s, to_s));
    result.measurements.push_back({{ours.metric, species, group, ours.unit},
                                   mean_between(ours.points, from_s, to_s),
                                   {{drift_name, Role::null, drift.value()}}});
  }
  const MetricName curve{ours.metric, species, "all", ours.unit};
  result.curves.push_back({curve, "", ours.points});
  result.curves.push_back({curve, drift_name, mean_of_series(drifted)});
}

/// Adds all tracks of an array, given those of each forest of drift.
template <std::size_t size>
void add_all(const std::array<Track, size>& ours, const std::vector<std::array<Track, size>>& drifted, const std::string& species,
             double end_s, RunMetrics& result) {
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<const Track*> others;
    for (const std::array<Track, size>& tracks : drifted) others.push_back(&tracks[i]);
    add_measure(ours[i], others, species, end_s, result);
  }
}

}  // namespace

double default_window_s(double run_s) {
  return std::min(500.0, 0.25 * run_s);
}

void check_window(double window_s, double run_s) {
  if (window_s > 0.0 && 4.0 * window_s <= run_s) return;
  throw std::invalid_argument{"--window " + number_text(window_s) + ": must be > 0 and <= " + number_text(0.25 * run_s) +
                              ", a quarter of the runs"};
}

RunMetrics lineage_metrics(const Forest& forest, const FoodWeb& web, Signatures& signatures, double window_s, double end_s,
                           std::uint64_t seed) {
  const Times times = times_of(window_s, end_s);
  const Typed ours = typed(forest, signatures);
  std::vector<Typed> drifted;
  for (std::size_t k = 0; k < drifts; ++k) {
    Rng rng{seed, Stream::null_model, k};
    drifted.push_back(typed(drift_of(forest, rng), signatures));
  }
  RunMetrics result;
  for (Species species = 0; species < web.size(); ++species) {
    std::vector<Presence> presence;
    std::vector<std::array<Track, 4>> modes;
    std::vector<std::array<Track, 4>> activity;
    std::vector<std::array<Track, 7>> descent;
    for (const Typed& one : drifted) {
      presence.push_back(presence_of(one.forest, species, one.types, times.counts_s));
      modes.push_back(modes_tracks(one, species, signatures, times));
      descent.push_back(descent_tracks(one.forest, species, times));
    }
    const auto nulls = std::span{presence}.first(nulls_of_activity);
    for (const Presence& one : std::span{presence}.subspan(nulls_of_activity)) {
      activity.push_back(activity_tracks(one, nulls, times));
    }
    const Presence own = presence_of(ours.forest, species, ours.types, times.counts_s);
    const std::string& name = web.name(species);
    add_all(modes_tracks(ours, species, signatures, times), modes, name, end_s, result);
    add_all(activity_tracks(own, nulls, times), activity, name, end_s, result);
    add_all(descent_tracks(ours.forest, species, times), descent, name, end_s, result);
  }
  return result;
}

RunMetrics measure_lineages(const RunManifest& run, const LineageMeasuring& how) {
  const Forest forest = read_lineages(run);
  const Decide decide = how.decide(run);
  const auto named = [&](std::span<const double> inputs, std::span<const double> weights) {
    try {
      return decide(inputs, weights);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{(run.folder / "genomes.csv").string() + ": " + error.what()};
    }
  };
  Signatures signatures{named, how.inputs};
  return lineage_metrics(forest, run.web, signatures, how.window_s, run.reached_s.value_or(0.0), run.seed);
}

std::vector<MetricName> lineage_metric_names(const FoodWeb& web) {
  Signatures none{[](auto, auto) { return control::Decision{}; }, std::vector<std::vector<Inputs>>(web.size())};
  std::vector<MetricName> names;
  for (const Measurement& measurement : lineage_metrics({}, web, none, 1.0, 4.0, 0).measurements) {
    names.push_back(measurement.name);
  }
  return names;
}

}  // namespace trophic::analysis
