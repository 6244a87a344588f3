// SPDX-License-Identifier: MIT
// Definitions of footage.hpp.
#include <tools/live/footage.hpp>
#include <trophic/io/recording_head.hpp>
#include <trophic/io/recording_planes.hpp>
#include <variant>

namespace trophic::live {

namespace {

namespace recording = io::recording;

/// A number with its meaning and bounds, null for none, and the rule table's own value.
Json json_of(const NamedParam& number, const std::string& table) {
  const auto finite = [](double bound) { return std::isfinite(bound) ? Json(bound) : Json(nullptr); };
  Json json{{"path", number.path},
            {"value", value_text(number)},
            {"table", table},
            {"help", number.help},
            {"acts_at_start", number.read == Read::at_start || !number.no_effect.empty()}};
  const bool is_whole = std::holds_alternative<std::int64_t>(number.value);
  if (std::holds_alternative<bool>(number.value)) {
    json["kind"] = "switch";
  } else if (is_whole || std::holds_alternative<double>(number.value)) {
    json["kind"] = is_whole ? "whole" : "number";
    json["lower"] = finite(number.bound.lower);
    json["upper"] = finite(number.bound.upper);
    json["lower_excluded"] = number.bound.lower_excluded;
  } else {
    json["kind"] = "text";
  }
  return json;
}

/// The head of a recording whose first frame is at time 0.
Json head_of(const RunFacts& facts) {
  return {{"version", facts.description.bodies_differ ? recording::version_of_bodies : recording::version},
          {"fingerprint", facts.description.fingerprint},
          {"seed", facts.description.seed},
          {"rule_table", facts.description.rules},
          {"backend", facts.description.backend},
          {"species", facts.species},
          {"first_time_s", 0.0},
          {"tick_s", facts.times.tick_s},
          {"clock_scale", facts.times.clock_scale},
          {"frames_per_tick", facts.times.per_tick(live_hz)},
          {"steps_per_tick", facts.times.steps},
          {"robots", facts.robots},
          {"joints", facts.joints},
          {"units", recording::json_of(recording::Units::for_extent(facts.arena.extent_m))},
          {"robot", recording::json_of(*facts.robot)},
          {"arena", recording::json_of(facts.arena)}};
}

std::uint32_t frame_of(double time_s, const RunFacts& facts) {
  const auto per_tick = static_cast<double>(facts.times.per_tick(live_hz));
  return static_cast<std::uint32_t>(std::floor(time_s / facts.times.tick_s * per_tick + 1e-6));
}

/// The frames of a tick as the block of a recording.
std::string poses_of(const TickSight& sight, const RunFacts& facts) {
  const recording::Units units = recording::Units::for_extent(facts.arena.extent_m);
  const std::size_t joints = std::ranges::max(sight.frames, {}, &TickSight::Moment::joints).joints;
  const std::size_t columns = facts.robots * (recording::pose_channels + joints);
  std::vector<std::int16_t> values(columns * sight.frames.size());
  for (std::size_t frame = 0; frame < sight.frames.size(); ++frame) {
    const TickSight::Moment& moment = sight.frames[frame];
    for (std::size_t robot = 0; robot < facts.robots; ++robot) {
      std::size_t at = frame * columns + robot;
      for (const std::int16_t value : recording::whole(moment.roots[robot], units)) {
        values[at] = value;
        at += facts.robots;
      }
      for (std::size_t joint = 0; joint < moment.joints; ++joint, at += facts.robots) {
        values[at] = recording::whole(moment.angles_rad[robot * moment.joints + joint], units.joint_rad);
      }
    }
  }
  std::string bytes;
  recording::append_u32(bytes, frame_of(sight.frames.front().time_s, facts));
  recording::append_u32(bytes, static_cast<std::uint32_t>(sight.frames.size()));
  if (facts.description.bodies_differ) {
    recording::append_u32(bytes, static_cast<std::uint32_t>(recording::pose_channels + joints));
  }
  return bytes + recording::packed(values, columns);
}

/// The robots that were set down since the frames before.
Json bodies_of(const TickSight& sight, const RunFacts& facts) {
  Json bodies = Json::array();
  for (const auto& robot : sight.set_down.bodies) bodies.push_back(recording::json_of(*robot));
  Json set_down = Json::array();
  for (const auto& [robot, body] : sight.set_down.of_robots) set_down.push_back({robot, body});
  return {{"kind", "bodies"},
          {"frame", frame_of(sight.set_down.time_s, facts)},
          {"bodies", std::move(bodies)},
          {"set_down", std::move(set_down)}};
}

template <class Number>
Json or_null(const std::optional<Number>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// time, kind, id, body, species, cause, other individual, x, y, parents, origin; a catch has its scene behind them.
Json json_of(const io::EventRow& event) {
  return {event.time_s,
          enum_name(event.kind),
          event.id,
          event.body,
          event.species,
          event.cause ? Json(enum_name(*event.cause)) : Json(""),
          or_null(event.victim ? event.victim : event.killer),
          event.x_m,
          event.y_m,
          event.ancestor_list.value(),
          enum_name(event.origin)};
}

/// A column of rows.
template <class Rows, class Cell>
Json column_of(const Rows& rows, Cell&& cell) {
  Json column = Json::array();
  for (const auto& row : rows) column.push_back(cell(row));
  return column;
}

Json robots_of(const TickSight& sight, const RunFacts& facts) {
  const auto or_none = [&](auto value, const io::AgentRow& row) { return sight.are_spare[row.body] ? Json(-1) : Json(value); };
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
  Json tick{{"kind", "tick"},
            {"tick", sight.tick},
            {"time_s", sight.time_s},
            {"id", column_of(sight.rows, [&](const io::AgentRow& row) { return or_none(row.id, row); })},
            {"species", column_of(sight.rows, [&](const io::AgentRow& row) { return or_none(row.species, row); })},
            {"active", column_of(sight.rows, [](const io::AgentRow& row) { return row.active ? 1 : 0; })},
            {"tag", column_of(sight.rows, [](const io::AgentRow& row) { return row.tag; })},
            {"x", column_of(sight.rows, [&](const io::AgentRow& row) { return rounded(row.x_m); })},
            {"y", column_of(sight.rows, [&](const io::AgentRow& row) { return rounded(row.y_m); })},
            {"angle", column_of(sight.rows, [&](const io::AgentRow& row) { return rounded(row.target_angle_rad); })},
            {"adversary", column_of(sight.rows, [](const io::AgentRow& row) { return or_null(row.adversary); })},
            {"hunger", column_of(sight.rows, [](const io::AgentRow& row) { return or_null(row.hunger_ticks); })}};
  for (const auto& [name, values_J] : {std::pair{"energy", &sight.energy_J}, {"stock", &sight.stock_J}})
    if (!values_J->empty()) tick[name] = column_of(*values_J, rounded);
  if (!sight.foods_J.empty()) tick["foods"] = Json::object();
  for (const auto& [name, cells_J] : sight.foods_J) tick["foods"][name] = column_of(cells_J, rounded);
  const std::vector<std::string> acts =
      facts.description.outputs.empty() ? std::vector<std::string>{"turn", "tag"} : facts.description.outputs;
  tick["outputs"] = Json::object();  // a null that becomes one crashes without memory
  for (std::size_t i = 0; i < acts.size(); ++i) {
    tick["outputs"][acts[i]] = column_of(sight.rows, [&](const io::AgentRow& row) {
      const bool is_known = row.body < sight.outputs.size() && sight.outputs[row.body].size() == acts.size();
      return is_known ? Json(rounded(sight.outputs[row.body][i])) : Json(nullptr);
    });
  }
  return tick;
}

}  // namespace

SharedMessage message_of(const Json& json, Message::Kind kind) {
  return std::make_shared<Message>(Message{.kind = kind, .text = json_text(json)});
}

SharedMessage facts_message(const RunFacts& facts) {
  Json numbers = Json::array();
  for (const NamedParam& number : facts.run.numbers) {
    const auto its = std::ranges::find(facts.run.table, number.path, &NamedParam::path);
    numbers.push_back(json_of(number, value_text(its == facts.run.table.end() ? number : *its)));
  }
  Json rules = Json::object();
  for (const auto& [slot, policy] : facts.description.slots) rules[slot] = policy;
  return message_of({{"kind", "run"},
                     {"label", facts.run.folder.filename().string()},
                     {"folder", facts.run.folder.string()},
                     {"rule_tables", facts.run.rule_tables},
                     {"species", facts.species},
                     {"tags", facts.description.tags},
                     {"rules", std::move(rules)},
                     {"numbers", std::move(numbers)},
                     {"head", head_of(facts)}},
                    Message::Kind::facts);
}

std::vector<SharedMessage> tick_messages(const TickSight& sight, const RunFacts& facts) {
  std::vector<SharedMessage> messages;
  if (!sight.set_down.of_robots.empty()) messages.push_back(message_of(bodies_of(sight, facts), Message::Kind::events));
  if (!sight.frames.empty()) {
    messages.push_back(std::make_shared<Message>(
        Message{.kind = Message::Kind::poses, .text = poses_of(sight, facts), .is_last = sight.is_last}));
  }
  if (!sight.events.empty()) {
    Json events = Json::array();
    auto scene = sight.scenes.begin();
    for (const io::EventRow& event : sight.events) {
      events.push_back(json_of(event));
      if (event.victim) events.back().push_back(json_of(*scene++));
    }
    messages.push_back(message_of({{"kind", "events"}, {"events", std::move(events)}}, Message::Kind::events));
  }
  if (sight.rows.empty()) return messages;
  messages.push_back(std::make_shared<Message>(
      Message{.kind = Message::Kind::tick, .text = json_text(robots_of(sight, facts)), .is_last = sight.is_last}));
  return messages;
}

}  // namespace trophic::live
