// SPDX-License-Identifier: MIT
// A run's folder, read into tables.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <trophic/analysis/data/csv_reader.hpp>
#include <trophic/analysis/data/tables.hpp>
#include <trophic/population/food_web.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

/// What a run's manifest says that metrics need.
struct RunFacts {
  std::filesystem::path folder;
  std::string fingerprint;
  std::string rules;
  std::string backend;
  std::string status;  ///< running (or killed), complete, stopped, failed
  std::uint64_t seed = 0;
  double until_s = 0.0;             ///< planned; after cut_to, what is left
  std::optional<double> reached_s;  ///< none for a run that was killed or is still running
  double half_side_m = 0.0;
  nlohmann::json policies;  ///< by slot
  nlohmann::json numbers;
  FoodWeb web{{}, {}};
};

/// A run's facts and tables. A table that could not be read is missing; `remarks` say what was wrong, and where.
struct RunData {
  RunFacts facts;
  std::optional<std::vector<EventRow>> events;
  std::optional<std::vector<AgentRow>> agents;
  std::vector<std::string> remarks;
};

/// Reads FOLDER/manifest.json. Throws std::runtime_error naming file and field.
[[nodiscard]] inline RunFacts read_facts(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "manifest.json";
  std::ifstream file{path};
  if (!file) throw std::runtime_error{path.string() + ": cannot be read; is " + folder.string() + " a run's folder?"};
  try {
    const auto json = nlohmann::json::parse(file);
    RunFacts facts;
    facts.folder = folder;
    facts.fingerprint = json.at("fingerprint").get<std::string>();
    facts.rules = json.at("rule_table").get<std::string>();
    facts.backend = json.at("backend").get<std::string>();
    facts.status = json.at("status").get<std::string>();
    facts.seed = json.at("seed").get<std::uint64_t>();
    facts.until_s = json.at("clock").at("until_s").get<double>();
    facts.half_side_m = json.at("arena").at("half_side_m").get<double>();
    if (json.contains("result")) facts.reached_s = json["result"].at("reached_s").get<double>();
    facts.policies = json.value("rules", nlohmann::json::object());
    facts.numbers = json.value("numbers", nlohmann::json::object());
    const auto names = json.at("species").get<std::vector<std::string>>();
    std::vector<Feeding> links;
    const auto number = [&](const std::string& name) {
      return static_cast<Species>(std::ranges::find(names, name) - names.begin());
    };
    for (const auto& link : json.at("food_web")) {
      links.push_back({number(link.at("hunter").get<std::string>()), number(link.at("victim").get<std::string>())});
    }
    facts.web = FoodWeb{names, links};
    return facts;
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error{path.string() + ": " + error.what()};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error{path.string() + ": " + error.what()};
  }
}

namespace detail {

[[nodiscard]] inline Species read_species(const CsvReader& csv, std::size_t column, const FoodWeb& web) {
  for (Species species = 0; species < web.size(); ++species) {
    if (web.name(species) == csv.text(column)) return species;
  }
  csv.reject(column, "a species of the run's manifest");
}

inline void remark_truncated(const CsvReader& csv, const std::filesystem::path& path, std::vector<std::string>& remarks) {
  if (!csv.truncated()) return;
  remarks.push_back(path.string() + ":" + std::to_string(csv.line() + 1) +
                    ": cut off in the middle of a line (killed run?); everything before it is used");
}

}  // namespace detail

/// Reads an events.csv. Throws std::runtime_error "FILE:LINE: ..."; a truncated last line goes to `remarks`.
[[nodiscard]] inline std::vector<EventRow> read_events(const std::filesystem::path& path, const FoodWeb& web,
                                                       std::vector<std::string>& remarks) {
  CsvReader csv{path,
                {"time_s", "tick", "event", "id", "species", "body", "active", "origin", "cause", "victim_id", "x_m", "y_m"}};
  std::vector<EventRow> rows;
  while (csv.next()) {
    rows.push_back({.time_s = csv.get<double>(0),
                    .tick = csv.get<std::int64_t>(1),
                    .kind = csv.get<observe::EventKind>(2),
                    .id = csv.get<IndividualId>(3),
                    .species = detail::read_species(csv, 4, web),
                    .body = csv.get<BodyIndex>(5),
                    .active = csv.get<bool>(6),
                    .origin = csv.get<Origin>(7),
                    .cause = csv.get_optional<Cause>(8),
                    .victim = csv.get_optional<IndividualId>(9),
                    .x_m = csv.get<double>(10),
                    .y_m = csv.get<double>(11)});
  }
  detail::remark_truncated(csv, path, remarks);
  return rows;
}

/// Reads an agents.csv. Throws std::runtime_error "FILE:LINE: ..."; of a file that was cut off the last tick is left out, and
/// `remarks` say so.
[[nodiscard]] inline std::vector<AgentRow> read_agents(const std::filesystem::path& path, const FoodWeb& web,
                                                       std::vector<std::string>& remarks) {
  CsvReader csv{path, {"time_s", "tick", "body", "id", "species", "origin", "tag", "x_m", "y_m", "adversary_id", "hunger_ticks"}};
  std::vector<AgentRow> rows;
  while (csv.next()) {
    rows.push_back({.time_s = csv.get<double>(0),
                    .tick = csv.get<std::int64_t>(1),
                    .body = csv.get<BodyIndex>(2),
                    .id = csv.get<IndividualId>(3),
                    .species = detail::read_species(csv, 4, web),
                    .origin = csv.get<Origin>(5),
                    .tag = csv.get<int>(6),
                    .x_m = csv.get<double>(7),
                    .y_m = csv.get<double>(8),
                    .adversary = csv.get_optional<IndividualId>(9),
                    .hunger_ticks = csv.get_optional<std::int64_t>(10)});
    if (rows.size() > 1 && rows.back().tick < rows[rows.size() - 2].tick) csv.reject(1, ">= that of the row before");
  }
  detail::remark_truncated(csv, path, remarks);
  if (csv.truncated() && !rows.empty()) {
    const std::int64_t last = rows.back().tick;
    std::erase_if(rows, [&](const AgentRow& row) { return row.tick == last; });
  }
  return rows;
}

/// Leaves of a run its first `until_s` seconds. Throws std::invalid_argument if it did not last that long.
inline void cut_to(RunData& run, double until_s) {
  const double last_s = run.agents && !run.agents->empty() ? run.agents->back().time_s : 0.0;
  const double reached_s = run.facts.reached_s.value_or(last_s);
  if (reached_s < until_s) {
    throw std::invalid_argument{run.facts.folder.string() + ": reached " + number_text(reached_s) + " s (status " +
                                run.facts.status + "): must be >= " + number_text(until_s) + " s, as --until asks"};
  }
  const auto is_later = [&](const auto& row) { return row.time_s > until_s; };
  if (run.events) std::erase_if(*run.events, is_later);
  if (run.agents) std::erase_if(*run.agents, is_later);
  run.facts.until_s = until_s;
}

/// Reads a run's folder. Throws std::runtime_error only for the manifest: without it nothing can be understood. What else is
/// missing or broken is left out and remarked on.
[[nodiscard]] inline RunData read_run(const std::filesystem::path& folder) {
  RunData run{.facts = read_facts(folder), .events = {}, .agents = {}, .remarks = {}};
  if (run.facts.status != "complete") {
    run.remarks.push_back((folder / "manifest.json").string() + ": status \"" + run.facts.status +
                          "\": the run did not reach its end");
  }
  const auto attempt = [&](auto&& read) {
    try {
      read();
    } catch (const std::runtime_error& error) {
      run.remarks.push_back(error.what());
    }
  };
  attempt([&] { run.events = read_events(folder / "events.csv", run.facts.web, run.remarks); });
  attempt([&] { run.agents = read_agents(folder / "agents.csv", run.facts.web, run.remarks); });
  return run;
}

}  // namespace trophic::analysis
