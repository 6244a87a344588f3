// SPDX-License-Identifier: MIT
// Definitions of plan_file.hpp.
#include <algorithm>
#include <set>
#include <tools/plan/plan_file.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::plan {

namespace detail {

/// One line of a plan, field by field.
class PlanLine {
 public:
  PlanLine(std::string where, std::string_view text) : where_{std::move(where)}, json_(parse_json_or_null(text)) {
    if (!json_.is_object()) throw std::invalid_argument{where_ + "must be a JSON object on a line of its own"};
    constexpr std::array known{"rule_table", "engine", "settings", "seed", "null",        "folder", "replay_hz", "agents_every",
                               "senses",     "states", "until_s",  "work", "fingerprint", "cell",   "replicate", "species"};
    for (const auto& [field, value] : json_.items()) {
      if (std::ranges::find(known, std::string_view{field}) == known.end()) reject(field, "be omitted: there is no such field");
    }
  }

  [[noreturn]] void reject(std::string_view field, const std::string& must) const {
    throw std::invalid_argument{where_ + std::string{field} + " = " + json_text(json_.at(std::string{field})) + ": must " + must};
  }
  [[nodiscard]] bool has(std::string_view field) const { return json_.contains(std::string{field}); }
  [[nodiscard]] const Json& at(std::string_view field) const {
    const auto found = json_.find(std::string{field});
    if (found == json_.end()) throw std::invalid_argument{where_ + std::string{field} + ": is missing"};
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
    if (!at(field).is_string() || at(field).get_ref<const std::string&>().empty()) reject(field, "be a text, and not empty");
    if (!is_plain(at(field).get_ref<const std::string&>())) reject(field, "have no control characters");
    return at(field).get<std::string>();
  }
  [[nodiscard]] bool yes_or_no(std::string_view field) const {
    if (!at(field).is_boolean()) reject(field, "be true or false");
    return at(field).get<bool>();
  }
  [[nodiscard]] Json settings(std::string_view field) const {
    if (!at(field).is_object()) reject(field, "be an object with settings by their paths");
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

[[nodiscard]] inline PlannedRun planned_run(const PlanLine& line, Lines lines) {
  PlannedRun run;
  const bool is_draft = lines == Lines::drafts;
  if (!is_draft || line.has("rule_table")) run.rule_table = line.text("rule_table");
  if (!is_draft || line.has("engine")) run.engine = line.text("engine");
  run.settings = line.settings("settings");
  run.seed = line.whole("seed");
  const auto null = null_named(line.text("null"));
  if (!null) line.reject("null", "be none, shadow, neutral, clones or one_sided_SPECIES");
  run.null = *null;
  run.folder = line.folder("folder");
  run.output.replay_hz = line.number("replay_hz");
  if (!(run.output.replay_hz >= 0.0 && run.output.replay_hz <= 1000.0)) line.reject("replay_hz", "be >= 0 and <= 1000");
  run.output.agents_every_ticks = line.ticks("agents_every");
  run.output.senses = line.yes_or_no("senses");
  run.output.states = line.yes_or_no("states");
  if (is_draft) return run;
  run.until_s = line.number("until_s");
  if (!(run.until_s > 0.0 && run.until_s <= longest_run_s)) line.reject("until_s", "be > 0 and <= " + number_text(longest_run_s));
  run.work = line.number("work");
  if (!(run.work >= 0.0)) line.reject("work", "be >= 0");
  run.fingerprint = line.text("fingerprint");
  return run;
}

}  // namespace detail

std::string place_of(const std::filesystem::path& path, std::size_t index) {
  return path.string() + ":" + std::to_string(index + 1) + ": ";
}

std::vector<PlannedRun> read_plan(const std::filesystem::path& path, Lines lines) {
  const std::string text = read_whole_file(path);
  std::vector<PlannedRun> runs;
  std::set<std::string> folders;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const detail::PlanLine line{place_of(path, runs.size()), rest.substr(0, end)};
    runs.push_back(detail::planned_run(line, lines));
    if (!folders.insert(runs.back().folder.string()).second) line.reject("folder", "be unique among the runs");
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  if (runs.empty()) throw std::invalid_argument{path.string() + ": must list at least one run"};
  return runs;
}

}  // namespace trophic::plan
