// SPDX-License-Identifier: MIT
// Definitions of catch_scene.hpp.
#include <tools/trophic/replay/catch_scene.hpp>

#include <cstdio>
#include <map>
#include <tools/analysis/data/csv_reader.hpp>

namespace trophic::command::replay {

namespace {

struct Life {
  double born_s = 0.0;
  std::size_t body = 0;
  std::string species;
  std::string origin;
};

std::string whole(double seconds) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.0f", seconds);
  return text.data();
}

}  // namespace

CatchScene find_catch(const RecordedRun& run, std::uint64_t number) {
  analysis::CsvReader events{run.folder / "events.csv", {"time_s", "event", "id", "body", "species", "origin", "victim_id"}};
  std::map<IndividualId, Life> lives;
  std::uint64_t seen = 0;
  while (events.next()) {
    const auto time_s = events.get<double>(0);
    const std::string_view kind = events.text(1);
    const auto id = events.get<IndividualId>(2);
    const auto body = events.get<std::size_t>(3);
    if (kind == "birth") lives[id] = {time_s, body, std::string{events.text(4)}, std::string{events.text(5)}};
    if (kind != "catch" || ++seen != number) continue;
    const auto victim = events.get<IndividualId>(6);
    const Life& life = lives[victim];
    std::string sentence{events.text(4)};
    sentence += " " + std::to_string(id) + " catches " + life.species + " " + std::to_string(victim) + ": " + life.origin +
                ", lived " + whole(time_s - life.born_s) + " s";
    return {
        .time_s = time_s, .hunter = id, .victim = victim, .hunter_body = body, .victim_body = life.body, .sentence = sentence};
  }
  const std::string has = seen == 0 ? "has no catch" : seen == 1 ? "has one catch" : "has " + std::to_string(seen) + " catches";
  throw std::invalid_argument{"--catch " + std::to_string(number) + ": " + run.folder.string() + " " + has};
}

}  // namespace trophic::command::replay
