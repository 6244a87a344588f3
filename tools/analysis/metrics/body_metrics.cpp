// SPDX-License-Identifier: MIT
// Definitions of body_metrics.hpp.
#include <tools/analysis/metrics/body_metrics.hpp>

#include <cmath>
#include <map>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <tools/reading/csv_reader.hpp>
#include <trophic/habitat/body/distance.hpp>
#include <trophic/habitat/body/plan.hpp>

namespace trophic::analysis {

namespace {

constexpr double longest_window_s = 200.0;
constexpr double windows_of_a_short_run = 20.0;

/// A column of bodies.csv that is a measure.
struct ShapeColumn {
  const char* column;
  const char* metric;
  const char* unit;
};
constexpr std::array shapes{
    ShapeColumn{"size", "body_size", "1"},         ShapeColumn{"proportion", "body_proportion", "1"},
    ShapeColumn{"coverage", "body_coverage", "1"}, ShapeColumn{"branching", "body_branching", "1"},
    ShapeColumn{"limbs", "body_limbs", "1"},       ShapeColumn{"length_of_limbs", "body_length_of_limbs", "1"},
    ShapeColumn{"symmetry", "body_symmetry", "1"}, ShapeColumn{"joints", "body_joints", "1"},
    ShapeColumn{"modules", "body_modules", "1"},   ShapeColumn{"hinges", "body_hinges", "1"},
    ShapeColumn{"mass_kg", "body_mass", "kg"}};

/// An individual with its life, and what tables have of it.
struct BodyLife {
  Species species = no_species;
  double birth_s = 0.0;
  double death_s = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> plan = {};
  std::optional<std::array<double, shapes.size()>> shape = {};
  double brain_genes = 0.0;
  double gait_genes = 0.0;
};
using BodyLives = std::map<IndividualId, BodyLife>;

BodyLives body_lives(const RunData& run) {
  BodyLives lives;
  if (!run.events) return lives;
  for (const EventRow& row : *run.events) {
    if (row.kind == observe::EventKind::birth) {
      lives[row.id] = {.species = row.species, .birth_s = row.time_s};
    } else if (row.kind == observe::EventKind::death) {
      if (const auto dead = lives.find(row.id); dead != lives.end()) dead->second.death_s = row.time_s;
    }
  }
  return lives;
}

/// Calls `visit(table)` for each row of a table, if the run has it. Throws std::invalid_argument if it cannot be read, was cut,
/// or is not what the run wrote.
template <class Visit>
bool read_body_table(const RunData& run, const char* name, std::span<const std::string_view> columns, const Visit& visit) {
  const std::filesystem::path path = run.manifest.folder / name;
  if (!std::filesystem::exists(path)) return false;
  try {
    CsvReader table{path, {}};
    for (const std::string_view column : columns) table.want(column);
    detail::check_sum(table, path, run.manifest.tables);
    while (table.next()) visit(table);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
  return true;
}

/// Throws std::invalid_argument, with the place, for a plan that cannot be read.
void check_plan(const std::string& text, const std::string& place) {
  try {
    static_cast<void>(body::read_plan(text));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{place + ": " + error.what()};
  }
}

/// Reads bodies.csv into `lives`; returns the text of each plan.
std::vector<std::string> read_bodies(const RunData& run, BodyLives& lives) {
  std::vector<std::string_view> columns{"id", "modules_text"};
  for (const ShapeColumn& shape : shapes) columns.emplace_back(shape.column);
  std::vector<std::string> texts;
  std::unordered_map<std::string, std::size_t> places;
  read_body_table(run, "bodies.csv", columns, [&](const CsvReader& table) {
    const auto found = lives.find(table.get<IndividualId>(0));
    if (found == lives.end()) return;  // born after the time up to which the run is measured
    const auto [place, is_new] = places.try_emplace(table.get<std::string>(1), texts.size());
    if (is_new) {
      check_plan(place->first, (run.manifest.folder / "bodies.csv").string() + ": id " + std::to_string(found->first));
      texts.push_back(place->first);
    }
    found->second.plan = place->second;
    std::array<double, shapes.size()> shape{};
    for (std::size_t i = 0; i < shapes.size(); ++i) shape[i] = table.get<double>(2 + i);
    found->second.shape = shape;
  });
  return texts;
}

bool read_genes(const RunData& run, BodyLives& lives) {
  constexpr std::array<std::string_view, 2> columns{"id", "part"};
  return read_body_table(run, "genes.csv", columns, [&](const CsvReader& table) {
    const auto found = lives.find(table.get<IndividualId>(0));
    if (found == lives.end()) return;
    if (table.text(1) == "brain") ++found->second.brain_genes;
    if (table.text(1) == "gait") ++found->second.gait_genes;
  });
}

/// The distance of each plan from the first one of a species.
class PlanChanges {
 public:
  explicit PlanChanges(const std::vector<std::string>& texts) : known_(texts.size()) {
    for (const std::string& text : texts) plans_.push_back(body::read_plan(text));
  }
  double operator()(std::size_t plan) {
    if (!first_) first_ = plan;
    if (!known_[plan]) known_[plan] = static_cast<double>(body::edit_distance(plans_[*first_], plans_[plan]));
    return *known_[plan];
  }

 private:
  std::vector<body::ModuleTree> plans_;
  std::vector<std::optional<double>> known_;
  std::optional<std::size_t> first_;
};

/// A measure over the windows of a run.
struct BodyTrack {
  MetricName name;
  Series points = {};
  void add(double time_s, std::optional<double> value) { points.push_back({time_s, value}); }
};

void add_body_tracks(std::vector<BodyTrack> tracks, double end_s, RunMetrics& result) {
  for (BodyTrack& track : tracks) {
    Mean early;
    Mean late;
    for (const Point& point : track.points) (2.0 * point.time_s <= end_s ? early : late).add(point.value);
    for (const auto& [group, mean] : {std::pair{"early", early}, std::pair{"late", late}}) {
      track.name.group = group;
      result.measurements.push_back({track.name, mean.value(), {}});
    }
    track.name.group = "all";
    result.curves.push_back({track.name, "", std::move(track.points)});
  }
}

/// Distance per second between consecutive rows of an individual, by the window in which the second one lies.
WindowMean walking_speed(Agents agents, Species species, double window_s) {
  WindowMean mean{window_s};
  std::unordered_map<IndividualId, const AgentRow*> before;
  for (const Agents& tick : by_tick(agents)) {
    Mean speed;
    std::unordered_map<IndividualId, const AgentRow*> now;
    for (const AgentRow& row : tick) {
      if (row.species != species) continue;
      now[row.id] = &row;
      const auto was = before.find(row.id);
      if (was == before.end()) continue;
      speed.add(std::hypot(row.x_m - was->second->x_m, row.y_m - was->second->y_m) / (row.time_s - was->second->time_s));
    }
    mean.add(tick.front().time_s, speed.value());
    before = std::move(now);
  }
  return mean;
}

/// The tracks of a species. `lives` and the flags that follow: what the run's tables have.
std::vector<BodyTrack> body_tracks(Species species, const std::string& name, const BodyLives& lives,
                                   const std::vector<std::string>& plans, bool has_genes, const std::vector<double>& times_s) {
  std::vector<BodyTrack> tracks;
  for (const ShapeColumn& shape : shapes) tracks.push_back({.name = {shape.metric, name, "all", shape.unit}});
  const auto plain = [&](const char* metric) { tracks.push_back({.name = {metric, name, "all", "1"}}); };
  for (const char* metric : {"body_plans", "body_plans_shannon", "body_change", "brain_genes", "gait_genes"}) plain(metric);
  PlanChanges changes{plans};
  for (const auto& [id, life] : lives) {
    if (life.species == species && life.plan) {
      static_cast<void>(changes(*life.plan));
      break;
    }
  }
  for (const double time_s : times_s) {
    std::array<Mean, shapes.size()> shape;
    Mean change;
    Mean brain;
    Mean gait;
    std::map<std::size_t, std::size_t> living;  // of each plan
    for (const auto& [id, life] : lives) {
      if (life.species != species || life.birth_s > time_s || life.death_s <= time_s) continue;
      if (has_genes) brain.add(life.brain_genes);
      if (has_genes) gait.add(life.gait_genes);
      if (!life.plan) continue;
      for (std::size_t i = 0; i < shapes.size(); ++i) shape[i].add((*life.shape)[i]);
      change.add(changes(*life.plan));
      ++living[*life.plan];
    }
    std::vector<std::size_t> counts;
    for (const auto& [plan, count] : living) counts.push_back(count);
    std::size_t next = 0;
    for (const Mean& mean : shape) tracks[next++].add(time_s, mean.value());
    const auto of_plans = [&](double value) { return counts.empty() ? std::nullopt : std::optional{value}; };
    tracks[next++].add(time_s, of_plans(static_cast<double>(counts.size())));
    tracks[next++].add(time_s, of_plans(body::shannon_number(counts)));
    tracks[next++].add(time_s, change.value());
    tracks[next++].add(time_s, brain.value());
    tracks[next++].add(time_s, gait.value());
  }
  return tracks;
}

}  // namespace

void check_bodies(const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder / "bodies.csv") || std::filesystem::exists(folder / "genes.csv")) return;
  throw std::invalid_argument{folder.string() +
                              ": has neither bodies.csv nor genes.csv: --bodies measures runs in which bodies, gaits or brains "
                              "differ"};
}

RunMetrics measure_bodies(const RunData& run) {
  const double end_s = run.manifest.until_s;
  const double window_s = std::min(longest_window_s, end_s / windows_of_a_short_run);
  std::vector<double> times_s;
  for (std::size_t i = 1; window_s > 0.0 && static_cast<double>(i) * window_s <= end_s * (1.0 + 1e-12); ++i) {
    times_s.push_back(std::min(static_cast<double>(i) * window_s, end_s));
  }
  BodyLives lives = body_lives(run);
  std::vector<std::string> plans;
  bool has_genes = false;
  if (!run.manifest.folder.empty()) {
    check_bodies(run.manifest.folder);
    plans = read_bodies(run, lives);
    has_genes = read_genes(run, lives);
  }
  RunMetrics result;
  for (Species species = 0; species < run.manifest.web.size(); ++species) {
    const std::string& name = run.manifest.web.name(species);
    std::vector<BodyTrack> tracks = body_tracks(species, name, lives, plans, has_genes, times_s);
    BodyTrack walk{.name = {"walked", name, "all", "m/s"}};
    if (run.agents && !times_s.empty()) walk.points = walking_speed(*run.agents, species, window_s).series();
    tracks.push_back(std::move(walk));
    add_body_tracks(std::move(tracks), end_s, result);
  }
  return result;
}

RunMetrics measure_shipped(const RunData& run, bool bodies) {
  return bodies ? measure_bodies(run) : measure_run(run);
}

}  // namespace trophic::analysis
