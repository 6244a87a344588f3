// SPDX-License-Identifier: MIT
// Definitions of rewind.hpp.
#include <cstdlib>
#include <system_error>
#include <tools/replicates/rewind.hpp>
#include <trophic/run/checkpoint/manifest_in.hpp>
#include <trophic/support/checksum.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/no_links.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/version.hpp>
#include <trophic/support/without_slash.hpp>

namespace trophic::checkpoint {

namespace detail {

/// Copies within the folder of the past first, so that the target has all of it or does not exist.
inline void copy_snapshot(const Snapshot& snapshot, const std::filesystem::path& folder) {
  const std::filesystem::path target = without_slash(folder);
  const std::filesystem::path part = snapshot.folder.parent_path() / ("part-" + std::to_string(checksum(target.string())));
  std::filesystem::remove_all(part);
  copy_until(snapshot.folder, std::numeric_limits<double>::infinity(), part);
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path());
  std::filesystem::rename(part, target);
}

/// Whether a clock shows the tick with which runs from a moment begin.
[[nodiscard]] inline bool is_tick_of(const Moment& moment, double time_s, double tick_s) {
  return time_s >= moment.at_s && time_s < moment.at_s + tick_s;
}

/// The last checkpoint that can be read, if it is of this version.
[[nodiscard]] inline std::optional<Checkpoint> last_resumable(const std::filesystem::path& folder) {
  std::vector<Checkpoint> all = read_all(folder);
  if (all.empty() || all.front().program_version != version) return std::nullopt;
  return std::move(all.front());
}

/// Whether a folder contains a copy of the moment that no run has continued.
[[nodiscard]] inline bool stands_at(const Moment& moment, const std::filesystem::path& folder, double tick_s) {
  const std::optional<Checkpoint> last = last_resumable(folder);
  return last && is_tick_of(moment, last->time_s, tick_s) && last->fingerprint == moment.fingerprint && last->seed == moment.seed;
}

/// Throws std::invalid_argument if the run of a folder's manifest began elsewhere.
inline void check_began_at(const Moment& moment, const std::filesystem::path& folder, double tick_s) {
  const Json manifest = manifest_in(folder);
  if (manifest.is_null()) return;
  const Json origin = manifest.value("origin", Json::object());
  const auto said = [&](const char* key) {
    const auto found = origin.find(key);
    return found != origin.end() && found->is_string() ? found->get<std::string>() : std::string{};
  };
  const bool same_run = said("fingerprint") == moment.fingerprint && said("seed") == std::to_string(moment.seed);
  if (same_run && is_tick_of(moment, std::strtod(said("at_s").c_str(), nullptr), tick_s)) return;
  throw std::invalid_argument{
      folder.string() + ": its run starts " + (origin.empty() ? "at 0 s" : "at " + said("at_s") + " s of " + said("run")) +
      "; it can be resumed, but it cannot start at " + number_text(moment.at_s) + " s of " + moment.run.string()};
}

[[nodiscard]] inline FolderLock make_and_lock(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  check_no_link(folder);
  return FolderLock{folder};
}

}  // namespace detail

std::optional<double> last_moment_s(const std::filesystem::path& run) {
  const std::vector<Checkpoint> all = read_all(run);
  return all.empty() ? std::nullopt : std::optional{all.front().time_s};
}

std::filesystem::path snapshot_folder(const std::filesystem::path& out, const Moment& moment) {
  return without_slash(out).string() + ".snapshot-" + moment.fingerprint + "-seed-" + std::to_string(moment.seed) + "-" +
         number_text(moment.at_s) + "-s/run";
}

SnapshotFolder::SnapshotFolder(const Snapshot& snapshot)
    : folder_{snapshot.folder.parent_path()}, lock_{detail::make_and_lock(folder_)} {}

SnapshotFolder::~SnapshotFolder() {
  std::error_code not_empty;
  std::filesystem::remove(folder_, not_empty);
}

bool SnapshotFolder::exists(const Snapshot& snapshot) {
  return std::filesystem::exists(snapshot.folder.parent_path());
}

void SnapshotFolder::clear() {
  for (const auto& entry : std::filesystem::directory_iterator{folder_}) std::filesystem::remove_all(entry.path());
}

bool needs_snapshot(const std::filesystem::path& folder, double until_s) {
  if (!std::filesystem::exists(folder)) return true;
  return !detail::is_complete(detail::manifest_in(folder), until_s) && !detail::last_resumable(folder);
}

void copy_until(const std::filesystem::path& run, double at_s, const std::filesystem::path& folder) {
  if (std::filesystem::exists(std::filesystem::symlink_status(folder))) {
    throw std::invalid_argument{folder.string() + ": exists already"};
  }
  const std::vector<Checkpoint> all = read_all(run);
  const auto early =
      std::ranges::find_if(all, [&](const Checkpoint& one) { return one.time_s <= at_s && one.program_version == version; });
  if (early == all.end()) return;
  std::error_code error;
  const auto require = [&](const std::filesystem::path& path) {
    if (error) throw std::runtime_error{"cannot copy " + path.string() + ": " + error.message()};
  };
  std::filesystem::create_directories(folder, error);
  require(folder);
  for (const auto& entry : std::filesystem::directory_iterator{run}) {
    const std::string name = entry.path().filename().string();
    if (entry.is_symlink() || !entry.is_regular_file() || name.starts_with("checkpoint.") || name.starts_with("manifest."))
      continue;
    std::filesystem::copy_file(entry.path(), folder / name, error);
    require(entry.path());
    sync_file(folder / name);  // before the checkpoint with its length is written
  }
  // Last, so that an interrupted copy has none.
  write(folder, *early);
}

io::Provenance provenance_of(const Moment& moment) {
  io::Provenance provenance{{"run", moment.run.string()},
                            {"at_s", number_text(moment.at_s)},
                            {"seed", std::to_string(moment.seed)},
                            {"fingerprint", moment.fingerprint}};
  if (!moment.code.empty()) provenance.emplace_back("code", moment.code);
  return provenance;
}

RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run,
                      const std::optional<Snapshot>& snapshot, const Schedule& schedule) {
  if (!snapshot) return run_state_in(folder, run, schedule);
  std::string remark;
  if (std::filesystem::exists(folder) && !detail::stands_at(snapshot->moment, folder, run.tick_s)) {
    detail::check_began_at(snapshot->moment, folder, run.tick_s);
    RunState run_state = run_state_in(folder, run, schedule);
    if (run_state.complete || run_state.from) return run_state;
    remark = run_state.remark + "; ";
  }
  if (!std::filesystem::exists(folder)) detail::copy_snapshot(*snapshot, folder);
  Checkpoint moment = read_last(folder);
  remark += "begins at " + number_text(moment.time_s) + " s of " + snapshot->moment.run.string();
  return {.complete = false, .from = std::move(moment), .remark = std::move(remark), .begins = true};
}

void check_begins(const Snapshot& snapshot, Simulation& ecology) {
  const Checkpoint moment = read_last(snapshot.folder);
  Archive archive{moment.section(ecology_section)};
  ecology.persist(archive);
  archive.finish();
}

void begin_at(RunState& run_state, const Moment& moment, Simulation& ecology, io::Manifest& manifest, const Parts& parts) {
  restore_any(*run_state.from, ecology, parts);
  Moment reached = moment;
  reached.at_s = run_state.from->time_s;
  manifest.begin_from(provenance_of(reached));
  run_state.from.reset();
}

}  // namespace trophic::checkpoint
