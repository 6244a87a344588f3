// SPDX-License-Identifier: MIT
// Definitions of recorded_agents.hpp.
#include <tools/trophic/replay/recorded_agents.hpp>

#include <cmath>
#include <tools/reading/table_reader.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::command::replay {

RecordedAgents::RecordedAgents(const RecordedRun& run, double from_s, double to_s, double before_s)
    : tick_s_{run.recording.head().times.tick_s} {
  const std::size_t robots = run.recording.head().robots;
  const bool is_full = !run.manifest.value("rules", Json::object()).contains("recruitment");
  const FoodWeb web{run.recording.head().species, {}};
  const std::filesystem::path path = run.folder / "agents.csv";
  try {
    analysis::TableReader<io::AgentRow> reader{path, web};
    io::AgentRow row;
    while (reader.next(row)) {
      if (row.time_s < from_s - before_s - tick_s_ || row.time_s > to_s + 1e-9) continue;
      if (rows_.empty()) first_tick_ = row.tick;
      const auto tick = static_cast<std::size_t>(row.tick - first_tick_);
      const bool is_after = rows_.empty() || row.tick > rows_.back().tick || row.body > rows_.back().body;
      if (row.tick < first_tick_ || !is_after || row.body >= robots || (is_full && rows_.size() != tick * robots + row.body)) {
        throw std::invalid_argument{path.string() + ":" + std::to_string(reader.csv().line()) + ": must have a row for each of " +
                                    std::to_string(robots) + " bodies at every tick"};
      }
      begins_.resize(std::max(begins_.size(), tick + 1), rows_.size());
      rows_.push_back(row);
    }
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
  begins_.push_back(rows_.size());
  if (is_full && rows_.size() % robots != 0) begins_.pop_back();
  if (begins_.size() < 2) throw std::invalid_argument{path.string() + ": has no row in the time to be shown"};
}

std::span<const io::AgentRow> RecordedAgents::at(double time_s) const {
  const auto last = static_cast<std::int64_t>(begins_.size()) - 2;
  const auto tick = static_cast<std::int64_t>(std::floor(time_s / tick_s_ + 1e-9)) - first_tick_;
  const auto place = static_cast<std::size_t>(std::clamp<std::int64_t>(tick, 0, last));
  return std::span{rows_}.subspan(begins_[place], begins_[place + 1] - begins_[place]);
}

const io::AgentRow* RecordedAgents::find(double time_s, std::size_t body) const {
  const auto rows = at(time_s);
  const auto found = std::ranges::lower_bound(rows, body, {}, &io::AgentRow::body);
  return found != rows.end() && found->body == body ? &*found : nullptr;
}

Pose RecordedAgents::root(const io::RecordingReader& recording, std::size_t frame, const io::AgentRow& row) const {
  Pose pose = recording.root(frame, row.body);
  const io::AgentRow* before = find(row.time_s - tick_s_, row.body);
  const bool is_new = before == nullptr || before->id != row.id;
  if (is_new && recording.time_s(frame) <= row.time_s) pose.position_m.head<2>() << row.x_m, row.y_m;
  return pose;
}

RecordedFood::RecordedFood(const RecordedRun& run) : half_side_m_{run.recording.head().arena.half_side_m} {
  const std::filesystem::path path = run.folder / "field.csv";
  if (!std::filesystem::exists(path)) return;
  analysis::CsvReader cells{path, {"time_s", "food_J"}};
  const bool has_names = cells.has("food");
  if (has_names) cells.want("food");
  while (cells.next()) {
    const auto time_s = cells.get<double>(0);
    if (moments_.empty() || time_s > moments_.back().first) moments_.push_back({time_s, {}});
    const std::size_t food = place_of(has_names ? cells.text(2) : "food");
    auto& all = moments_.back().second;
    all.resize(std::max(all.size(), food + 1));
    most_[food] = std::max(most_[food], all[food].emplace_back(cells.get<float>(1)));
  }
  const auto as_first = [&](const auto& moment) {
    return std::ranges::equal(moment.second, moments_.front().second, {}, &Cells::size, &Cells::size);
  };
  if (!moments_.empty() && !as_first(moments_.back())) moments_.pop_back();  // killed
  for (const auto& moment : moments_)
    if (!as_first(moment)) throw std::runtime_error{path.string() + ": must have the same cells of each food at every moment"};
}

std::size_t RecordedFood::place_of(std::string_view name) {
  const auto found = std::ranges::find(names_, name);
  if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
  names_.emplace_back(name);
  most_.push_back(1e-30F);
  return names_.size() - 1;
}

std::vector<film::FoodTile> RecordedFood::at(double time_s) const {
  if (moments_.empty()) return {};
  const auto next = std::ranges::upper_bound(moments_, time_s, {}, &decltype(moments_)::value_type::first);
  const auto& from = next == moments_.begin() ? *next : *std::prev(next);
  const auto& to = next == moments_.end() ? from : *next;
  const double gap_s = to.first - from.first;
  const auto part = static_cast<float>(gap_s > 0.0 ? (time_s - from.first) / gap_s : 0.0);
  const auto side_of = [](const Cells& cells) {
    return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(cells.size()))));
  };
  const std::size_t row = std::min<std::size_t>(side_of(*std::ranges::max_element(from.second, {}, &Cells::size)), 100);
  const double half_m = half_side_m_ / static_cast<double>(row);
  const auto middle_m = [&](std::size_t at) { return static_cast<double>(2 * at + 1) * half_m - half_side_m_; };
  std::vector<film::FoodTile> tiles;
  for (std::size_t tile = 0; tile < row * row; ++tile) {
    tiles.push_back({middle_m(tile % row), middle_m(tile / row), half_m});
    for (std::size_t food = 0; food < names_.size(); ++food) {
      const std::size_t side = side_of(from.second[food]);
      const std::size_t cell = tile / row * side / row * side + tile % row * side / row;
      tiles.back().foods.push_back(std::lerp(from.second[food][cell], to.second[food][cell], part) / most_[food]);
    }
  }
  return tiles;
}

}  // namespace trophic::command::replay
