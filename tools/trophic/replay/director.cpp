// SPDX-License-Identifier: MIT
// Definitions of director.hpp.
#include <tools/trophic/replay/director.hpp>

#include <cstdio>
#include <map>
#include <tools/reading/csv_reader.hpp>
#include <tools/trophic/replay/recorded_run.hpp>

namespace trophic::command::replay {

Scene scene_of(double time_s, const Partner& hunter, const Partner& victim) {
  std::array<char, 40> lived{};
  std::snprintf(lived.data(), lived.size(), "%.0f", time_s - victim.born_s);
  return {.time_s = time_s,
          .hunter = hunter.id,
          .victim = victim.id,
          .hunter_body = hunter.body,
          .victim_body = victim.body,
          .sentence = hunter.species + " " + std::to_string(hunter.id) + " catches " + victim.species + " " +
                      std::to_string(victim.id) + ": " + victim.origin + ", lived " + lived.data() + " s",
          .hunter_is_inherited = hunter.origin == "inherited"};
}

std::vector<Scene> scenes_of(const RecordedRun& run) {
  analysis::CsvReader events{run.folder / "events.csv", {"time_s", "event", "id", "body", "species", "origin", "victim_id"}};
  std::map<IndividualId, Partner> born;
  std::vector<Scene> scenes;
  while (events.next()) {
    const std::string_view kind = events.text(1);
    if (kind != "birth" && kind != "catch") continue;
    const Partner one{.id = events.get<IndividualId>(2),
                      .body = events.get<std::size_t>(3),
                      .species = std::string{events.text(4)},
                      .origin = std::string{events.text(5)},
                      .born_s = events.get<double>(0)};
    if (kind == "birth") {
      born[one.id] = one;
    } else {
      Partner& victim = born[events.get<IndividualId>(6)];
      victim.id = events.get<IndividualId>(6);
      scenes.push_back(scene_of(one.born_s, one, victim));
    }
  }
  return scenes;
}

Json json_of(const Scene& scene) {
  return {
      {"time_s", scene.time_s},    {"begins_s", scene.time_s - Scene::before_s},       {"ends_s", scene.time_s + Scene::after_s},
      {"still_s", Scene::still_s}, {"bodies", {scene.hunter_body, scene.victim_body}}, {"sentence", scene.sentence}};
}

Json scenes_of(const RecordedRun& run, const Window& window) {
  std::vector<Scene> scenes = scenes_of(run);
  std::erase_if(scenes, [&](const Scene& scene) { return !window.has(scene.time_s); });
  const double first_s = window.start_s(run.recording);
  const double last_s = window.end_s(run.recording);
  const auto is_whole = [&](const Scene& scene) { return scene.time_s - Scene::before_s >= first_s && scene.time_s <= last_s; };
  auto opening = std::ranges::find_if(scenes, [&](const Scene& scene) { return is_whole(scene) && scene.hunter_is_inherited; });
  if (opening == scenes.end()) opening = std::ranges::find_if(scenes, is_whole);
  Json all = Json::array();
  for (const Scene& scene : scenes) all.push_back(json_of(scene));
  if (opening != scenes.end()) all[static_cast<std::size_t>(opening - scenes.begin())]["opens"] = true;
  return all;
}

}  // namespace trophic::command::replay
