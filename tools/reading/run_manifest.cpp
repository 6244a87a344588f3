// SPDX-License-Identifier: MIT
// Definitions of run_manifest.hpp.
#include <tools/reading/run_manifest.hpp>

#include <set>
#include <tools/changes/change.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/unreadable_file.hpp>

namespace trophic::analysis {

std::optional<double> end_s(const RunManifest& run) {
  return run.status == "complete" ? std::optional{run.reached_s.value_or(run.until_s)} : run.reached_s;
}

std::string lasted_text(const RunManifest& run) {
  const auto end = end_s(run);
  return "status \"" + run.status + "\" at " + (end ? number_text(*end) : "an unknown time") + " of " + number_text(run.until_s) +
         " s";
}

bool lasted_alike(const RunManifest& a, const RunManifest& b) {
  const bool are_complete = a.status == "complete" && b.status == "complete";  // one may have ended early, by ends_when
  return a.until_s == b.until_s && end_s(a) && (are_complete || end_s(a) == end_s(b));
}

std::string first_difference(const Json& a, const Json& b) {
  const Json flat_a = a.flatten();
  const Json flat_b = b.flatten();
  const auto text = [](const Json& of, const std::string& key) {
    return of.contains(key) ? json_text(of[key]) : std::string{"missing"};
  };
  for (const Json& one : {flat_a, flat_b}) {
    for (const auto& [key, value] : one.items()) {
      const std::string here = text(flat_a, key);
      const std::string there = text(flat_b, key);
      if (here != there) return key.substr(1) + " = " + there + ": must be " + here;
    }
  }
  return "";
}

namespace {

/// The codes that a manifest lists: of the program that began the run, of those that resumed it, and of its origin.
std::vector<std::string> builds_in(const Json& manifest) {
  std::set<std::string> builds;
  const auto add = [&](const Json& of) {
    if (of.contains("code")) builds.insert(plain_text(of, "code"));
  };
  add(manifest);
  if (manifest.contains("origin")) add(manifest["origin"]);
  if (manifest.contains("continued")) {
    for (const Json& one : manifest["continued"]) add(one);
  }
  return {builds.begin(), builds.end()};
}

}  // namespace

std::string builds_text(const std::vector<std::string>& builds) {
  if (builds.empty()) return "an unknown build";
  std::string text = builds.front();
  for (std::size_t i = 1; i < builds.size(); ++i) text += (i + 1 < builds.size() ? ", " : " and ") + builds[i];
  return text;
}

RunManifest manifest_of(std::string_view text, const std::filesystem::path& path) {
  try {
    auto json = parse_sealed(text);
    if (!json.is_object()) throw std::invalid_argument{"is not a JSON object, or was modified after trophic wrote it"};
    for (const char* unprinted : {"command_line", "error"}) json.erase(unprinted);  // may quote what was typed
    check_plain(json);
    RunManifest manifest;
    manifest.folder = path.parent_path();
    manifest.fingerprint = plain_text(json, "fingerprint");
    manifest.rules = plain_text(json, "rule_table");
    manifest.backend = plain_text(json, "backend");
    manifest.status = plain_text(json, "status");
    manifest.seed = whole_number<std::uint64_t>(json, "seed");
    if (json.contains("origin")) {
      const auto said = [&](const char* key) { return plain_text(json["origin"], key); };
      manifest.begins = "at " + said("at_s") + " s of " + said("run") + " (seed " + said("seed") + ")";
    }
    manifest.until_s = json.at("clock").at("until_s").get<double>();
    if (!(manifest.until_s >= 0.0 && manifest.until_s <= longest_run_s)) {
      throw std::invalid_argument{"clock.until_s = " + number_text(manifest.until_s) +
                                  ": must be >= 0 and <= " + number_text(longest_run_s)};
    }
    manifest.half_side_m = json.at("arena").at("half_side_m").get<double>();
    if (json.contains("agents_every_ticks")) {
      manifest.agents_every_ticks = whole_number<std::int64_t>(json, "agents_every_ticks", 1);
    }
    if (json.contains("result")) manifest.reached_s = json["result"].at("reached_s").get<double>();
    manifest.policies = json.value("rules", Json::object());
    manifest.params = json.value("params", Json::object());
    const auto names = json.at("species").get<std::vector<std::string>>();
    constexpr std::size_t most_species = 1000;
    if (names.size() > most_species || !std::ranges::all_of(names, is_plain)) {
      throw std::invalid_argument{"species: must be <= " + std::to_string(most_species) + " names without control characters"};
    }
    std::vector<Feeding> links;
    const auto number = [&](const std::string& name) {
      return static_cast<Species>(std::ranges::find(names, name) - names.begin());
    };
    for (const auto& link : json.at("food_web")) {
      links.push_back({number(link.at("hunter").get<std::string>()), number(link.at("victim").get<std::string>())});
    }
    manifest.web = FoodWeb{names, links};
    if (json.contains("tables")) {
      for (const auto& [file, sum] : json["tables"].items()) {
        manifest.tables[file] = {.rows = whole_number<std::uint64_t>(sum, "rows"),
                                 .crc32 = whole_number<std::uint32_t>(sum, "crc32")};
      }
    }
    if (json.contains("description")) {
      const Json& changes = json["description"].at("changes");
      manifest.changes = {changes.size(), json_text(changes)};
    } else if (const auto table = manifest.tables.find(std::string{changes::file_name});
               table != manifest.tables.end() && table->second.rows > 0) {  // of an older program
      manifest.changes = {table->second.rows, std::to_string(table->second.crc32)};
    } else {
      manifest.changes = {0, json_text(Json::array())};
    }
    manifest.builds = builds_in(json);
    return manifest;
  } catch (const Json::exception& error) {
    throw std::runtime_error{path.string() + ": " + reason_of(error)};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error{path.string() + ": " + error.what()};
  }
}

RunManifest read_manifest(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "manifest.json";
  std::string text;
  try {
    text = read_whole_file(path, checkpoint::largest_manifest);
  } catch (const UnreadableFile& error) {
    throw std::runtime_error{error.what()};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error{std::string{error.what()} + "; is " + folder.string() + " a run's folder?"};
  }
  RunManifest manifest = manifest_of(text, path);
  if (const std::string damage = checkpoint::damage_in(folder); !damage.empty()) throw std::runtime_error{damage};
  manifest.folder = folder;
  return manifest;
}

}  // namespace trophic::analysis
