// SPDX-License-Identifier: MIT
// manifest.json: what made a run, and how it ended.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <trophic/observe/run.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/version.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace trophic::observe {

/// Facts that only the program knows: command line, host, revision of its own source. trophic's programs give them
/// (examples/facts.hpp); a program of your own gives what it knows.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// The compiler that made this program, with its version: "g++ 12.2.0".
[[nodiscard]] inline std::string compiler() {
#if defined(__clang__)
  return "clang++ " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
         std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
  return "g++ " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." + std::to_string(__GNUC_PATCHLEVEL__);
#else
  return "unknown";
#endif
}

/// Writes the manifest when the run starts (status "running") and again when it ends: "complete", "stopped" (an observer ended it
/// early) or "failed" with the error. Each time the file is replaced as a whole.
class Manifest {
 public:
  Manifest(std::filesystem::path path, Facts facts) : path_{std::move(path)}, facts_{std::move(facts)} {}

  void on_start(const Run& run, const View& view) {
    until_s_ = run.until_s;
    content_["trophic"] = version;
    content_["status"] = "running";
    content_["fingerprint"] = run.fingerprint;
    content_["seed"] = run.seed;
    content_["rule_table"] = run.rules;
    content_["backend"] = run.backend;
    content_["remarks"] = run.remarks;
    content_["compiler"] = compiler();
    for (const auto& [name, text] : facts_) content_[name] = text;
    content_["clock"] = {{"tick_s", run.tick_s}, {"simulated_s_per_clock_s", run.clock_scale}, {"until_s", run.until_s}};
    for (Species species = 0; species < view.web.size(); ++species) content_["species"].push_back(view.web.name(species));
    content_["food_web"] = nlohmann::ordered_json::array();
    for (const Feeding& link : view.web.links()) {
      content_["food_web"].push_back({{"hunter", view.web.name(link.hunter)}, {"victim", view.web.name(link.victim)}});
    }
    content_["arena"] = {{"half_side_m", view.arena.half_side_m}, {"extent_m", view.arena.extent_m}};
    content_["tags"] = run.tags;
    for (const auto& [slot, policy] : run.slots) content_["rules"][slot] = policy;
    for (const Setting& setting : run.settings) {
      std::visit([&](const auto& value) { content_["numbers"][pointer(setting.path)] = value; }, setting.value);
    }
    write();
  }
  void on_event(const Event& event, const View& view) { tally_.on_event(event, view); }
  void on_tick(const View& view) { reached_s_ = view.time_s; }
  void on_end(const View& view) { finish(view.time_s < until_s_ ? "stopped" : "complete"); }
  void on_failure(std::string_view what) {
    content_["error"] = what;
    finish("failed");
  }

  /// Adds facts that are known only now, such as the wall time, and writes again.
  void add(const Facts& facts) {
    for (const auto& [name, text] : facts) content_[name] = text;
    write();
  }

 private:
  /// "rules.tag_switch.cool_down_s" as the place in a nested object.
  static nlohmann::ordered_json::json_pointer pointer(std::string path) {
    for (char& c : path) {
      if (c == '.') c = '/';
    }
    return nlohmann::ordered_json::json_pointer{"/" + path};
  }

  void finish(std::string_view status) {
    content_["status"] = status;
    auto& result = content_["result"];
    result["reached_s"] = reached_s_;
    result["births"] = tally_.births();
    result["deaths"] = tally_.deaths();
    for (std::size_t cause = 0; cause < enum_names(Cause{}).size(); ++cause) {
      result[std::string{enum_name(static_cast<Cause>(cause))}] = tally_.deaths(static_cast<Cause>(cause));
    }
    write();
  }

  void write() const { replace_file(path_, content_.dump(2) + '\n'); }

  std::filesystem::path path_;
  Facts facts_;
  nlohmann::ordered_json content_;
  Tally tally_;
  double until_s_ = 0.0;
  double reached_s_ = 0.0;
};

}  // namespace trophic::observe
