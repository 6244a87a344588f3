// SPDX-License-Identifier: MIT
// The folder of a set of replicates: made once, resumed later, never overwritten.
#pragma once

#include <tools/replicates/plan.hpp>
#include <tools/replicates/rewind.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/no_links.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/unreadable_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::replicates {

using checkpoint::status_of;

/// The name of the file that lists a set's replicates.
inline constexpr const char* list_name = "replicates.json";

/// The run and moment at which they all begin, as in the file; empty if they begin at time 0.
[[nodiscard]] inline Json origin_of(const Plan& plan) {
  auto origin = Json::object();
  if (!plan.snapshot) return origin;
  for (const auto& [name, text] : checkpoint::provenance_of(plan.snapshot->moment)) origin[name] = text;
  return parse_json(json_text(origin));
}

/// Contents of the file: the planned runs, and what they have in common.
[[nodiscard]] inline std::string list_text(const Plan& plan, const observe::RunDescription& run,
                                           const io::Provenance& provenance) {
  auto replicates = Json::array();
  for (const Replicate& replicate : plan.all()) {
    replicates.push_back({{"folder", name_of(replicate.index)}, {"seed", replicate.seed}});
  }
  // Made whole: a value that becomes an object while memory runs out cannot be destroyed.
  Json content{{"format", 2},
               {"rule_table", run.rules},
               {"backend", run.backend},
               {"fingerprint", run.fingerprint},
               {"until_s", run.until_s},
               {"master_seed", plan.master_seed},
               {"count", plan.count},
               {"replicates", std::move(replicates)}};
  if (plan.snapshot) content["origin"] = origin_of(plan);
  for (const auto& [name, text] : provenance) content[name] = text;
  return sealed_text(content);
}

/// replicates.json and the remaining part of the plan. Holds a lock on the folder while it lives, so that two programs
/// cannot work in it at once.
class Folder {
 public:
  /// Makes the folder or, with `plan.resume`, resumes in it. Complete replicates stay; interrupted ones resume from their
  /// checkpoint. Those without one, and complete ones that were damaged, are moved to "replicate-NN.incomplete-K" and are to be
  /// run anew. `run` is any run of the plan, seed aside. Throws std::invalid_argument if the folder exists and the plan does not
  /// resume, if what is there has other rules, parameters, seeds or a longer duration, if there are links in it, or if another
  /// build of the program made a part of the set and the plan does not accept that; std::runtime_error if another program works
  /// in it or the system refuses.
  Folder(const Plan& plan, const observe::RunDescription& run, const io::Provenance& provenance) {
    plan.check();
    if (!plan.resume || !std::filesystem::exists(plan.out)) {
      static_cast<void>(io::make_new_folder(plan.out));
      lock_.emplace(plan.out);
    } else {
      lock_.emplace(plan.out);
      check_no_links_in(plan.out);
      if (!is_bare(plan.out)) check_same(plan, run);
    }
    std::vector<Replicate> incomplete;
    std::vector<std::filesystem::path> complete;
    for (Replicate& replicate : plan.all()) {
      const std::string status = status_of(replicate.folder);
      if (status == "complete" && is_complete(plan, replicate, run)) {
        complete.push_back(replicate.folder);
        ++kept_;
        continue;
      }
      if (status != "missing" && status != "complete") incomplete.push_back(replicate);
      pending_.push_back(std::move(replicate));
    }
    if (!pending_.empty() && plan.checkpoints.other_build == checkpoint::OtherBuild::refused) {
      for (const std::filesystem::path& folder : complete) checkpoint::check_build(folder);
    }
    for (const Replicate& replicate : incomplete) static_cast<void>(is_complete(plan, replicate, run));
    replace_file(plan.out / list_name, list_text(plan, run, provenance));
  }
  /// To be run, each into a new folder or from the checkpoint in its own.
  [[nodiscard]] const std::vector<Replicate>& pending() const { return pending_; }
  /// Number of those that were complete already.
  [[nodiscard]] std::size_t kept() const { return kept_; }
  /// A sentence about each folder that was renamed.
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  /// Whether the program that made the folder died before it could list the runs.
  [[nodiscard]] static bool is_bare(const std::filesystem::path& folder) {
    const std::string part = std::string{list_name} + ".part";
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
      if (entry.path().filename() != part) return false;
    }
    return true;
  }

  static void same(const std::filesystem::path& file, const std::string& field, const Json& there, const Json& ours) {
    if (there == ours) return;
    throw std::invalid_argument{file.string() + ": " + field + " = " + json_text(there) + ": must be " + json_text(ours) +
                                ", as in the experiment to resume"};
  }

  static Json read(const std::filesystem::path& path) {
    std::string text;
    try {
      text = read_whole_file(path);
    } catch (const UnreadableFile&) {
      throw;
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{std::string{error.what()} + "; only a folder of replicates can be resumed"};
    }
    auto json = parse_sealed(text);
    if (!json.is_object())
      throw std::invalid_argument{path.string() + ": is not a JSON object, or was modified after trophic wrote it"};
    return json;
  }

  static void check_same(const Plan& plan, const observe::RunDescription& run) {
    const std::filesystem::path path = plan.out / list_name;
    const Json there = read(path);
    try {
      same(path, "fingerprint", there.at("fingerprint"), run.fingerprint);
      same(path, "master_seed", there.at("master_seed"), plan.master_seed);
      if (there.at("until_s") > Json(run.until_s)) same(path, "until_s", there.at("until_s"), run.until_s);
      same(path, "origin", there.value("origin", Json::object()), origin_of(plan));
      const Json& count = there.at("count");
      if (count > Json(plan.count)) {
        throw std::invalid_argument{"replicates = " + std::to_string(plan.count) + ": must be >= " + json_text(count) +
                                    ", as in " + path.string() + "; a resumed set can grow but not shrink"};
      }
    } catch (const Json::exception& error) {
      throw std::invalid_argument{path.string() + ": " + reason_of(error)};
    }
  }

  /// Looks at a replicate; a sentence about one that is not complete goes to the remarks.
  [[nodiscard]] bool is_complete(const Plan& plan, const Replicate& replicate, observe::RunDescription run) {
    run.seed = replicate.seed;
    const auto state = checkpoint::run_state_in(replicate.folder, run, plan.snapshot, plan.checkpoints);
    if (!state.complete) remarks_.push_back(name_of(replicate.index) + " " + state.remark);
    return state.complete;
  }

  std::optional<FolderLock> lock_;
  std::vector<Replicate> pending_;
  std::size_t kept_ = 0;
  std::vector<std::string> remarks_;
};

}  // namespace trophic::replicates
