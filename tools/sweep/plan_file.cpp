// SPDX-License-Identifier: MIT
// Definitions of plan_file.hpp.
#include <map>
#include <set>
#include <tools/sweep/plan_file.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::sweep {

namespace detail {

/// One line of a plan, field by field.
class PlanLine {
 public:
  PlanLine(const std::filesystem::path& path, std::size_t line, std::string_view text)
      : where_{path.string() + ":" + std::to_string(line)}, json_(parse_json_or_null(text)) {
    if (!json_.is_object()) throw std::invalid_argument{where_ + ": must be a JSON object on a line of its own"};
  }

  [[noreturn]] void reject(std::string_view field, const std::string& must) const {
    throw std::invalid_argument{where_ + ": " + std::string{field} + " = " + json_text(json_.at(std::string{field})) + ": must " +
                                must};
  }
  [[nodiscard]] const Json& at(std::string_view field) const {
    const auto found = json_.find(std::string{field});
    if (found == json_.end()) throw std::invalid_argument{where_ + ": " + std::string{field} + ": must be there"};
    return *found;
  }
  [[nodiscard]] std::uint64_t whole(std::string_view field) const {
    if (!at(field).is_number_unsigned()) reject(field, "be a whole number >= 0");
    return at(field).get<std::uint64_t>();
  }
  [[nodiscard]] std::int64_t ticks(std::string_view field) const {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (whole(field) < 1 || whole(field) > most) reject(field, "be >= 1 and <= " + std::to_string(most));
    return static_cast<std::int64_t>(whole(field));
  }
  [[nodiscard]] double number(std::string_view field) const {
    if (!at(field).is_number()) reject(field, "be a number");
    const auto value = at(field).get<double>();
    if (!std::isfinite(value)) reject(field, "be finite");
    return value;
  }
  [[nodiscard]] std::string text(std::string_view field) const {
    if (!at(field).is_string() || at(field).get_ref<const std::string&>().empty()) reject(field, "be a text that is not empty");
    if (!is_plain(at(field).get_ref<const std::string&>())) reject(field, "have no control characters");
    return at(field).get<std::string>();
  }
  [[nodiscard]] bool yes_or_no(std::string_view field) const {
    if (!at(field).is_boolean()) reject(field, "be true or false");
    return at(field).get<bool>();
  }
  [[nodiscard]] Json settings(std::string_view field) const {
    if (!at(field).is_object()) reject(field, "be an object of settings by their paths");
    for (const auto& [path, value] : at(field).items()) {
      if (!path.empty() && (value.is_number() || value.is_string() || value.is_boolean())) continue;
      reject(field, "have a number, a text, true or false at each path");
    }
    return at(field);
  }
  [[nodiscard]] std::filesystem::path folder(std::string_view field) const {
    const std::filesystem::path folder = text(field);
    const bool plain = folder.is_relative() && folder.has_filename() && folder.lexically_normal() == folder;
    if (!plain || *folder.begin() == ".." || folder == ".")
      reject(field, "be a folder within that of the plan, without . and ..");
    return folder;
  }

 private:
  std::string where_;
  Json json_;
};

[[nodiscard]] inline PlannedRun planned_run(const PlanLine& line) {
  PlannedRun run;
  run.index = line.whole("index");
  run.cell = line.whole("cell");
  run.replicate = line.whole("replicate");
  run.shadow = line.yes_or_no("shadow");
  run.rule_table = line.text("rule_table");
  run.engine = line.text("engine");
  run.settings = line.settings("settings");
  run.seed = line.whole("seed");
  run.until_s = line.number("until_s");
  if (!(run.until_s > 0.0 && run.until_s <= longest_run_s)) line.reject("until_s", "be > 0 and <= " + number_text(longest_run_s));
  run.output.replay_hz = line.number("replay_hz");
  if (!(run.output.replay_hz >= 0.0 && run.output.replay_hz <= 1000.0)) line.reject("replay_hz", "be >= 0 and <= 1000");
  run.output.agents_every_ticks = line.ticks("agents_every");
  run.output.senses = line.yes_or_no("senses");
  run.output.states = line.yes_or_no("states");
  run.work = line.number("work");
  if (!(run.work >= 0.0)) line.reject("work", "be >= 0");
  run.folder = line.folder("folder");
  run.fingerprint = line.text("fingerprint");
  return run;
}

/// Checks each run of a plan against those before it.
class RunsSoFar {
 public:
  /// `runs`: those so far, and this line's at their end.
  void check(const PlanLine& line, std::span<const PlannedRun> runs) {
    const PlannedRun& run = runs.back();
    if (run.index != runs.size() - 1) {
      line.reject("index", "be " + std::to_string(runs.size() - 1) + ", as lines stand in the order of their index");
    }
    if (!folders_.insert(run.folder.string()).second) line.reject("folder", "be another for each run");
    const std::string cell = " cell " + std::to_string(run.cell);
    if (!seeds_.emplace(std::tuple{run.cell, run.shadow, run.replicate}, run.seed).second) {
      line.reject("replicate", "be another for each run of" + cell);
    }
    if (!known_.emplace(run.cell, run.shadow, run.seed).second) line.reject("seed", "be another for each replicate of" + cell);
    const auto beside = seeds_.find({run.cell, !run.shadow, run.replicate});
    if (beside != seeds_.end() && beside->second != run.seed) {
      line.reject("seed", "be " + std::to_string(beside->second) + ", as a replicate and its shadow have one");
    }
    const auto same = [&](std::string_view field, const auto& ours, const auto& there) {
      if (ours != there) line.reject(field, "be " + json_text(Json(there)) + ", as in the other runs of" + cell);
    };
    const PlannedRun& first = runs[first_of_.emplace(run.cell, run.index).first->second];
    same("rule_table", run.rule_table, first.rule_table);
    same("engine", run.engine, first.engine);
    same("settings", run.settings, first.settings);
    same("until_s", run.until_s, first.until_s);
    same("replay_hz", run.output.replay_hz, first.output.replay_hz);
    same("agents_every", run.output.agents_every_ticks, first.output.agents_every_ticks);
    same("senses", run.output.senses, first.output.senses);
    same("states", run.output.states, first.output.states);
    same("fingerprint", run.fingerprint, fingerprints_.emplace(std::pair{run.cell, run.shadow}, run.fingerprint).first->second);
  }

 private:
  std::set<std::string> folders_;
  std::map<std::tuple<std::size_t, bool, std::size_t>, std::uint64_t> seeds_;  ///< by cell, shadow and replicate
  std::set<std::tuple<std::size_t, bool, std::uint64_t>> known_;               ///< cell, shadow and seed
  std::map<std::size_t, std::size_t> first_of_;                                ///< a cell's first run
  std::map<std::pair<std::size_t, bool>, std::string> fingerprints_;           ///< by cell and shadow
};

}  // namespace detail

std::vector<PlannedRun> read_plan(const std::filesystem::path& path) {
  const std::string text = read_whole_file(path);
  std::vector<PlannedRun> runs;
  detail::RunsSoFar so_far;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const detail::PlanLine line{path, runs.size() + 1, rest.substr(0, end)};
    runs.push_back(detail::planned_run(line));
    so_far.check(line, runs);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  if (runs.empty()) throw std::invalid_argument{path.string() + ": must list a run"};
  return runs;
}

std::string plan_text(std::span<const PlannedRun> runs) {
  std::string text;
  for (const PlannedRun& run : runs) {
    const Json line{{"index", run.index},
                    {"cell", run.cell},
                    {"replicate", run.replicate},
                    {"shadow", run.shadow},
                    {"rule_table", run.rule_table},
                    {"engine", run.engine},
                    {"settings", run.settings},
                    {"seed", run.seed},
                    {"until_s", run.until_s},
                    {"replay_hz", run.output.replay_hz},
                    {"agents_every", run.output.agents_every_ticks},
                    {"senses", run.output.senses},
                    {"states", run.output.states},
                    {"work", run.work},
                    {"folder", run.folder.string()},
                    {"fingerprint", run.fingerprint}};
    text += json_text(line) + '\n';
  }
  return text;
}

}  // namespace trophic::sweep
