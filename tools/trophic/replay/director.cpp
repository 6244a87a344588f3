// SPDX-License-Identifier: MIT
// Definitions of director.hpp.
#include <tools/trophic/replay/director.hpp>

#include <map>
#include <tools/reading/csv_reader.hpp>
#include <tools/trophic/replay/recorded_run.hpp>

namespace trophic::command::replay {

namespace {

std::string name_of(const Partner& one) {
  return one.species + " " + std::to_string(one.id);
}

std::string seconds(double time_s) {
  return std::to_string(std::lround(time_s)) + " s";
}

/// How close a victim must be to hunters of a species, if the rule's parameters say so.
std::optional<double> reach_of(const RecordedRun& run, const std::string& hunters) {
  const Json rules = run.manifest.value("params", Json::object()).value("rules", Json::object());
  const Json capture = rules.value("capture", Json::object());
  const Json own = capture.contains(hunters) ? capture.at(hunters) : capture;
  return own.contains("reach_m") ? std::optional{own.at("reach_m").get<double>()} : std::nullopt;
}

/// A robot's path in a stretch of a recording.
Track track_of(const io::RecordingReader& recording, const Partner& one, double from_s, double to_s) {
  constexpr double step_s = 0.5;
  const std::size_t body = one.body;
  Track track;
  // Its body may have been elsewhere until its birth.
  for (double time_s = from_s > one.born_s ? from_s : from_s + step_s; time_s < to_s + step_s; time_s += step_s) {
    const std::size_t at = recording.frame_at(std::min(time_s, to_s));
    track.places_m.push_back(recording.root(at, body).position_m);
    track.radius_m = std::max(track.radius_m, recording.robot(at, body).bounding_radius_m);
  }
  return track;
}

}  // namespace

void Scene::add(Flaw flaw, const std::string& words) {
  flaws |= flaw;
  if (!words.empty()) remark += (remark.empty() ? "" : "; ") + words;
}

Scene scene_of(double time_s, const Partner& hunter, const Partner& victim) {
  Scene scene{.time_s = time_s,
              .begins_s = std::max({time_s - Scene::before_s, hunter.born_s, victim.born_s}),
              .ends_s = time_s + Scene::after_s,
              .hunter = hunter,
              .victim = victim,
              .sentence = name_of(hunter) + " catches " + name_of(victim) + ": " + victim.origin + ", lived " +
                          seconds(time_s - victim.born_s)};
  if (hunter.origin != "inherited") scene.add(Scene::random_hunter, "");
  for (const Partner& one : {hunter, victim}) {
    if (time_s - one.born_s >= Scene::before_s) continue;
    scene.add(Scene::newborn, name_of(one) + " was born " + seconds(time_s - one.born_s) + " before");
  }
  return scene;
}

void frame(Scene& scene, std::span<const Track> tracks, const Arena& arena) {
  constexpr double much = 0.25;
  scene.shot = shot_of(tracks, arena);
  if (!scene.shot.is_inside) scene.add(Scene::wall_in_front, "a wall stands in front");
  if (scene.shot.outside_share > much) scene.add(Scene::much_outside, "much of the picture is outside the arena");
}

std::vector<Scene> catches_of(const RecordedRun& run) {
  analysis::CsvReader events{run.folder / "events.csv",
                             {"time_s", "event", "id", "body", "species", "origin", "victim_id", "x_m", "y_m"}};
  std::map<IndividualId, Partner> born;
  std::map<IndividualId, double> died_s;
  std::vector<Scene> scenes;
  while (events.next()) {
    const std::string_view kind = events.text(1);
    const Partner one{.id = events.get<IndividualId>(2),
                      .body = events.get<std::size_t>(3),
                      .species = std::string{events.text(4)},
                      .origin = std::string{events.text(5)},
                      .born_s = events.get<double>(0)};
    if (kind == "birth") born[one.id] = one;
    if (kind == "death") died_s[one.id] = one.born_s;
    if (kind != "catch") continue;
    const auto victim_id = events.get<IndividualId>(6);
    for (const IndividualId id : {one.id, victim_id}) born.try_emplace(id, Partner{.id = id, .species = "robot"});
    scenes.push_back(scene_of(one.born_s, born[one.id], born[victim_id]));
    scenes.back().reach_m = reach_of(run, scenes.back().hunter.species);
    scenes.back().x_m = events.get<double>(7);
    scenes.back().y_m = events.get<double>(8);
  }
  for (Scene& scene : scenes) {
    const auto died = died_s.find(scene.hunter.id);
    if (died != died_s.end()) scene.ends_s = std::clamp(died->second, scene.time_s, scene.ends_s);
  }
  return scenes;
}

void stage(Scene& scene, const std::vector<Scene>& catches, const RecordedRun& run, const Window& window) {
  const double first_s = window.start_s(run.recording);
  const double last_s = window.end_s(run.recording);
  if (scene.begins_s < first_s) scene.add(Scene::cut, "its beginning is not shown");
  if (scene.ends_s > last_s) scene.add(Scene::cut, "its end is not shown");
  scene.begins_s = std::clamp(scene.begins_s, first_s, scene.time_s);
  scene.ends_s = std::clamp(scene.ends_s, scene.time_s, last_s);
  const std::array<Track, 2> tracks{track_of(run.recording, scene.hunter, scene.begins_s, scene.ends_s),
                                    track_of(run.recording, scene.victim, scene.begins_s, scene.time_s)};
  frame(scene, tracks, run.recording.head().arena);
  const auto others = std::ranges::count_if(catches, [&](const Scene& one) {
    if (one.time_s < scene.begins_s || one.time_s > scene.ends_s || one.victim.id == scene.victim.id) return false;
    const auto place = film::seen_at(scene.shot.camera(aspect_of_shots), {one.x_m, one.y_m, 0.0});
    return place && std::abs(place->x) < aspect_of_shots && std::abs(place->y) < 1.0;
  });
  if (others > 0)
    scene.add(Scene::other_catches,
              others == 1 ? "another catch is in the picture" : std::to_string(others) + " other catches are in the picture");
}

std::vector<Scene> scenes_of(const RecordedRun& run, const Window& window) {
  const std::vector<Scene> catches = catches_of(run);
  std::vector<Scene> scenes;
  for (const Scene& one : catches) {
    if (one.time_s < window.start_s(run.recording) || one.time_s > window.end_s(run.recording)) continue;
    stage(scenes.emplace_back(one), catches, run, window);
  }
  return scenes;
}

const Scene* best_of(const std::vector<Scene>& scenes) {
  const auto best = std::ranges::min_element(scenes, {}, &Scene::flaws);
  return best == scenes.end() ? nullptr : &*best;
}

Json json_of(const Scene& scene) {
  const auto whole = [](double value) { return std::round(1e3 * value) / 1e3; };
  const auto& [at_m, azimuth_deg, elevation_deg, near_m, high_m, wide_m, is_inside, outside_share] = scene.shot;
  Json json{{"time_s", scene.time_s},
            {"begins_s", scene.begins_s},
            {"ends_s", scene.ends_s},
            {"still_s", Scene::still_s},
            {"individuals", {scene.hunter.id, scene.victim.id}},
            {"sentence", scene.sentence},
            {"remark", scene.remark},
            {"camera",
             {{"at_m", {whole(at_m.x()), whole(at_m.y()), whole(at_m.z())}},
              {"azimuth_deg", azimuth_deg},
              {"elevation_deg", elevation_deg},
              {"near_m", whole(near_m)},
              {"high_m", whole(high_m)},
              {"wide_m", whole(wide_m)}}}};
  if (scene.reach_m) json["reach_m"] = *scene.reach_m;
  return json;
}

Json json_of_scenes(const RecordedRun& run, const Window& window) {
  const std::vector<Scene> scenes = scenes_of(run, window);
  const Scene* opening = best_of(scenes);
  Json all = Json::array();
  for (const Scene& scene : scenes) {
    all.push_back(json_of(scene));
    if (&scene == opening) all.back()["opens"] = true;
  }
  return all;
}

}  // namespace trophic::command::replay
