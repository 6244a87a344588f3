// SPDX-License-Identifier: MIT
// A run's folder, written by hand.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace trophic::test {

inline const std::string event_header =
    "time_s,tick,event,id,species,body,tag,active,origin,parent_id,genome_id,cause,killer_id,victim_id,x_m,y_m\n";
inline const std::string agent_header =
    "time_s,tick,body,id,species,origin,active,tag,x_m,y_m,heading_rad,target_angle_rad,adversary_id,adversary_distance_m,"
    "hunger_ticks\n";

inline std::string manifest(const std::string& fingerprint, int seed, const std::string& rules = "paper") {
  return R"({"fingerprint": ")" + fingerprint + R"(", "rule_table": ")" + rules +
         R"(", "backend": "kinematic 1", "status": "complete", "seed": )" + std::to_string(seed) +
         R"(, "clock": {"until_s": 6000}, "arena": {"half_side_m": 10.0}, "species": ["prey", "predator"],
         "food_web": [{"hunter": "predator", "victim": "prey"}]})";
}

/// FOLDER/NAME with a predator that catches an inherited prey; its own origin is `hunter`.
inline std::filesystem::path write_run(const std::filesystem::path& folder, const std::string& manifest_text,
                                       const std::string& hunter = "inherited") {
  std::filesystem::create_directories(folder);
  std::ofstream{folder / "manifest.json"} << manifest_text;
  std::ofstream{folder / "events.csv"} << event_header << "0,0,birth,0,prey,0,1,1,inherited,,0,,,,1,2\n"
                                       << "0,0,birth,1,predator,1,1,1," << hunter << ",,1,,,,1,2\n"
                                       << "2,1,catch,1,predator,1,1,1," << hunter << ",,1,,,0,1,2\n"
                                       << "2,1,death,0,prey,0,1,1,inherited,,0,caught,1,,1,2\n"
                                       << "2,1,birth,2,predator,0,1,1,random,,2,,,,1,2\n";
  std::ofstream{folder / "agents.csv"} << agent_header << "0,0,0,0,prey,inherited,1,1,9.5,2,0,0.7,,,\n"
                                       << "0,0,1,1,predator," << hunter << ",1,1,1,2,0,0.7,0,8.5,0\n"
                                       << "2,1,0,2,predator,random,1,1,1,2,0,0.7,,,0\n"
                                       << "2,1,1,1,predator," << hunter << ",1,1,1,2,0,0.7,,,0\n";
  return folder;
}

/// A run of a table with the rule `heredity`; its floor has the number `floor`.
inline std::filesystem::path run_of(const std::filesystem::path& folder, const std::string& heredity, int floor = 7, int seed = 1,
                                    const std::string& status = "complete") {
  std::string text = manifest(heredity, seed);
  text.replace(text.find("complete"), 8, status);
  return write_run(folder, text.substr(0, text.size() - 1) + R"(, "rules": {"heredity": ")" + heredity +
                               R"(", "floor": "victim_floor"}, "params": {"seed": )" + std::to_string(seed) +
                               R"(, "rules": {"floor": {"floor": )" + std::to_string(floor) + "}}}}");
}

}  // namespace trophic::test
