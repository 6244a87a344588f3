// SPDX-License-Identifier: MIT
// Definitions of manifest.hpp.
#pragma once

#include <trophic/io/manifest.hpp>
#include <trophic/io/program_code.hpp>
#include <trophic/io/recording_head.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/system_differences.hpp>
#include <trophic/support/version.hpp>
#include <variant>

namespace trophic::io {

namespace detail {

/// The path "rules.tag_switch.cool_down_s" as a place in a nested object.
[[nodiscard]] inline Json::json_pointer json_place(std::string path) {
  for (char& c : path) {
    if (c == '.') c = '/';
  }
  return Json::json_pointer{"/" + path};
}

/// Adds identity and description of a run with this origin, which may be empty, to its manifest.
inline void describe(observe::RunDescription run, const Provenance& origin, Json& json) {
  if (!origin.empty()) {
    const auto text = [&](std::string_view key) {
      const auto found = std::ranges::find(origin, key, &Provenance::value_type::first);
      return found == origin.end() ? std::string{"unknown"} : found->second;
    };
    run.branch =
        observe::Branch{.run = text("run"), .at_s = text("at_s"), .seed = text("seed"), .fingerprint = text("fingerprint")};
  }
  json["identity"] = observe::identity(run);
  Json said{{"name", observe::short_name(run)},
            {"sentence", observe::sentence(run)},
            {"parameters", Json::array()},
            {"changes", Json::array()}};
  for (const observe::OtherParam& param : run.other_params) {
    said["parameters"].push_back({{"path", param.path}, {"value", param.value}, {"table", param.table}});
  }
  for (const observe::ParameterChange& change : observe::effective(run.changes)) {
    said["changes"].push_back(
        {{"time_s", change.time_s}, {"number", change.number}, {"value", change.value}, {"before", change.before}});
  }
  json["description"] = std::move(said);
}

}  // namespace detail

TROPHIC_INLINE std::string compiler() {
#if defined(__clang__)
  return "clang++ " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
         std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
  return "g++ " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." + std::to_string(__GNUC_PATCHLEVEL__);
#else
  return "unknown";
#endif
}

struct Manifest::Content {
  std::filesystem::path path;
  Json json = {};

  void write() const { replace_file(path, sealed_text(json)); }

  /// Calls `change(json)` and keeps its effect unless it throws. If memory runs out in the call, the JSON library's values may
  /// hold null pointers that their destructors dereference, so such a copy is leaked.
  template <class Change>
  void change(Change&& change) {
    auto changed = std::make_unique<Json>(json);
    try {
      change(*changed);
    } catch (...) {
      static_cast<void>(changed.release());
      throw;
    }
    json = std::move(*changed);
  }
};

TROPHIC_INLINE Manifest::Manifest(std::filesystem::path path, Provenance provenance)
    : provenance_{std::move(provenance)}, content_{std::make_shared<Content>(Content{.path = std::move(path)})} {
  provenance_.emplace_back("code", program_code());
}

TROPHIC_INLINE void Manifest::persist(Archive& archive) {
  Provenance ours = provenance_;
  archive(provenance_, continued_, origin_, tally_, reached_s_);
  if (!archive.reads()) return;
  const Provenance& last = continued_.empty() ? provenance_ : continued_.back().provenance;
  if (std::ranges::find(last, std::pair{std::string{"code"}, program_code()}) == last.end()) {
    ours.emplace_back("other_build", "accepted");
  }
  continued_.push_back({.from_s = reached_s_, .provenance = std::move(ours)});
}

TROPHIC_INLINE void Manifest::set_tables(const std::vector<std::pair<std::string, TableSum>>& tables) {
  content_->change([&](Json& json) {
    for (const auto& [file, sum] : tables) {
      json["tables"][file] = {{"rows", sum.rows}, {"crc32", sum.crc32}};
      for (const auto& [name, type] : sum.columns) json["tables"][file]["columns"][name] = type;
    }
  });
}

TROPHIC_INLINE void Manifest::set_recording(std::uint64_t frames, std::uint32_t crc32) {
  content_->change([&](Json& json) { json["recording"] = {{"frames", frames}, {"crc32", crc32}}; });
}

TROPHIC_INLINE void Manifest::on_change(const observe::RunDescription& run, const View&) {
  changed_ = run;
  if (run.changes.size() < 2 * described_) return;  // else a file as long as all changes would be written at each of them
  described_ = run.changes.size();
  content_->change([&](Json& json) {
    detail::describe(run, origin_, json);
    json["remarks"] = run.remarks;
  });
  content_->write();
}

TROPHIC_INLINE void Manifest::on_start(const observe::RunDescription& run, const View& view) {
  until_s_ = run.until_s;
  inherits_bodies_ = run.inherits_bodies;
  content_->change([&](Json& json) {
    json["format"] = 2;  // sealed; those without it are not
    json["trophic"] = version;
    json["status"] = "running";
    json["fingerprint"] = run.fingerprint;
    detail::describe(run, origin_, json);
    json["seed"] = run.seed;
    json["rule_table"] = run.rules;
    json["backend"] = run.backend;
    json["remarks"] = run.remarks;
    json["compiler"] = compiler();
    json["architecture"] = architecture();
    json["c_library"] = c_library();
    for (const auto& [name, text] : provenance_) json[name] = text;
    for (const auto& [name, text] : origin_) json["origin"][name] = text;
    for (const Continuation& one : continued_) {
      Json program{{"from_s", one.from_s}};
      for (const auto& [name, text] : one.provenance) program[name] = text;
      json["continued"].push_back(std::move(program));
    }
    json["clock"] = {{"tick_s", run.tick_s}, {"simulated_s_per_clock_s", run.clock_scale}, {"until_s", run.until_s}};
    if (inputs_) json["senses"]["inputs"] = *inputs_;
    if (agents_every_ticks_ != 1) json["agents_every_ticks"] = agents_every_ticks_;
    for (Species species = 0; species < view.web.size(); ++species) json["species"].push_back(view.web.name(species));
    json["food_web"] = Json::array();
    for (const Feeding& link : view.web.links()) {
      json["food_web"].push_back({{"hunter", view.web.name(link.hunter)}, {"victim", view.web.name(link.victim)}});
    }
    json["arena"] = recording::json_of(view.arena);
    json["arena"]["friction"] = view.arena.friction;
    json["tags"] = run.tags;
    for (const auto& [slot, policy] : run.slots) json["rules"][slot] = policy;
    for (const NamedParam& param : run.named_params) {
      std::visit([&](const auto& value) { json["params"][detail::json_place(param.path)] = value; }, param.value);
    }
  });
  content_->write();
}

TROPHIC_INLINE void Manifest::on_failure(std::string_view what) {
  content_->change([&](Json& json) { json["error"] = what; });
  finish("failed");
}

TROPHIC_INLINE void Manifest::add(const Provenance& provenance) {
  content_->change([&](Json& json) {
    for (const auto& [name, text] : provenance) json[name] = text;
  });
  content_->write();
}

TROPHIC_INLINE void Manifest::finish(std::string_view status) {
  content_->change([&](Json& json) {
    if (changed_) {
      detail::describe(*changed_, origin_, json);
      json["remarks"] = changed_->remarks;
    }
    json["status"] = status;
    auto& result = json["result"];
    result["reached_s"] = reached_s_;
    if (!end_text_.empty()) result["ended"] = end_text_;
    result["births"] = tally_.births();
    result["deaths"] = tally_.deaths();
    for (const auto& [cause, deaths] : tally_.deaths_by_cause()) result[cause] = deaths;
    if (refused_births_ > 0) result["refused_births"] = refused_births_;
    if (inherits_bodies_) result["refused_bodies"] = refused_bodies_;
  });
  content_->write();
}

}  // namespace trophic::io
