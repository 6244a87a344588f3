// SPDX-License-Identifier: MIT
// Definitions of make_run.hpp.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <tools/replicates/rewind.hpp>
#include <tools/sweep/make_run.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/run/checkpoint/manifest_in.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/no_links.hpp>

namespace trophic::sweep {

namespace detail {

[[nodiscard]] inline std::filesystem::path lock_of(const std::filesystem::path& run) {
  return run.string() + ".lock";
}
[[nodiscard]] inline std::filesystem::path making_of(const std::filesystem::path& run) {
  return run.string() + ".making";
}

/// The right to make a run. Network file systems that lock a file for all machines lock a folder for one.
class RunLock {
 public:
  explicit RunLock(const std::filesystem::path& run) : name_{lock_of(run)} {
    // Another program may look at it (stage_of) or remove it at this moment.
    for (int left = 5; !take(); --left) {
      if (left == 0) throw std::runtime_error{"another program is making it"};
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
  }
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  ~RunLock() {
    ::unlink(name_.c_str());
    ::close(file_);
  }

 private:
  [[nodiscard]] bool take() {
    file_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) throw std::runtime_error{"cannot open " + name_.string() + ": " + std::strerror(errno)};
    if (lock_named(file_, name_)) return true;
    ::close(file_);
    return false;
  }

  std::filesystem::path name_;
  int file_ = -1;
};

[[nodiscard]] inline bool is_locked(const std::filesystem::path& run) {
  const int file = ::open(lock_of(run).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return false;
  const bool is_held = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return is_held;
}

[[nodiscard]] inline bool holds(const std::filesystem::path& folder, const PlannedRun& run) {
  return checkpoint::holds_complete(folder, run.fingerprint, run.seed, run.until_s);
}

/// How the files in a run's place differ from what a run wrote there; empty if they do not, or if no run wrote there.
[[nodiscard]] inline std::string damage_in(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "manifest.json") ? checkpoint::damage_in(folder) : "";
}

/// Whether a folder holds the complete run, but to an earlier end.
[[nodiscard]] inline bool holds_shorter(const std::filesystem::path& folder, const PlannedRun& run) {
  const double until_s = checkpoint::detail::until_in(checkpoint::detail::manifest_in(folder));
  return until_s < run.until_s && checkpoint::holds_complete(folder, run.fingerprint, run.seed, until_s);
}

/// Throws std::invalid_argument if a folder on the way from a sweep to its run is a link, or if the run's holds anything else
/// than its beginning.
inline void check_place(const std::filesystem::path& sweep, const PlannedRun& run) {
  std::filesystem::path at = sweep;
  for (const auto& part : run.folder) check_no_link(at /= part);
  for (const auto& beside : {lock_of(at), making_of(at)}) check_no_link(beside);
  if (!std::filesystem::exists(std::filesystem::symlink_status(at)) || std::filesystem::is_empty(at) || holds_shorter(at, run)) {
    return;
  }
  throw std::invalid_argument{at.string() + ": holds something else than the complete run that was planned: move it away"};
}

/// Begins or resumes a run in a folder and completes it.
inline void complete(const std::filesystem::path& making, const PlannedRun& run,
                     const std::function<void(const std::filesystem::path& folder)>& work) {
  if (checkpoint::status_of(making) == "complete") {
    const bool is_whole = checkpoint::damage_in(making).empty();
    if (is_whole && holds(making, run)) return;
    if (!is_whole || !holds_shorter(making, run)) static_cast<void>(checkpoint::rename_incomplete(making));
  }
  const bool resumes = checkpoint::last_moment_s(making).has_value();
  if (!resumes) std::filesystem::remove_all(making);
  try {
    work(making);
  } catch (const DamagedFile& error) {
    if (!resumes) throw;
    throw DamagedFile{std::string{error.what()} + "; kept as " + checkpoint::rename_incomplete(making).string() +
                      ", the next attempt begins without it"};
  }
  const std::string status = checkpoint::status_of(making);
  if (status != "complete") throw std::runtime_error{"status \"" + status + "\""};
}

}  // namespace detail

bool is_complete(const std::filesystem::path& sweep, const PlannedRun& run) {
  return detail::holds(sweep / run.folder, run);
}

Stage stage_of(const std::filesystem::path& sweep, const PlannedRun& run, bool verifies) {
  const std::filesystem::path folder = sweep / run.folder;
  if (verifies && !detail::damage_in(folder).empty()) return Stage::failed;
  if (is_complete(sweep, run)) return Stage::complete;
  if (detail::is_locked(folder)) return Stage::running;
  const std::string status = checkpoint::status_of(detail::making_of(folder));
  return status == "missing" ? Stage::missing : status == "failed" ? Stage::failed : Stage::interrupted;
}

std::string make_run(const std::filesystem::path& sweep, const PlannedRun& run,
                     const std::function<void(const std::filesystem::path& folder)>& work, bool verifies) {
  const std::filesystem::path folder = sweep / run.folder;
  std::string damage = verifies ? detail::damage_in(folder) : "";
  if (damage.empty() && is_complete(sweep, run)) {
    // Its program may have been killed before it removed the lock.
    if (!detail::is_locked(folder)) ::unlink(detail::lock_of(folder).c_str());
    return "";
  }
  if (damage.empty()) detail::check_place(sweep, run);
  std::filesystem::create_directories(folder.parent_path());
  const detail::RunLock alone{folder};
  // Another program may have completed it before it gave the lock back.
  if (verifies) damage = detail::damage_in(folder);
  if (damage.empty() && is_complete(sweep, run)) return "";
  if (!damage.empty()) {
    damage = run.folder.string() + ": was damaged (" + damage + "): kept as " +
             checkpoint::rename_incomplete(folder).filename().string() + ", run anew";
    detail::check_place(sweep, run);
  } else if (detail::holds_shorter(folder, run)) {
    std::filesystem::rename(folder, detail::making_of(folder));
  }
  detail::complete(detail::making_of(folder), run, work);
  std::filesystem::rename(detail::making_of(folder), folder);
  return damage;
}

void check_builds(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan) {
  std::vector<std::filesystem::path> complete;
  for (const PlannedRun& run : plan) {
    if (is_complete(sweep, run)) complete.push_back(sweep / run.folder);
  }
  if (complete.size() == plan.size()) return;
  for (const std::filesystem::path& folder : complete) checkpoint::check_build(folder);
}

}  // namespace trophic::sweep
