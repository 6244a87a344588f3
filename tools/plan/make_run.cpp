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
#include <tools/plan/make_run.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/no_links.hpp>

namespace trophic::plan {

namespace detail {

[[nodiscard]] inline std::filesystem::path lock_of(const std::filesystem::path& run) {
  return run.string() + ".lock";
}

/// The right to make a run. Network file systems that lock a file for all machines lock a folder for one.
class RunLock {
 public:
  explicit RunLock(const std::filesystem::path& run) : name_{lock_of(run)} {
    // Another program may look at it (stage_of) or remove it at this moment.
    for (int left = 5; !take(); --left) {
      if (left == 0) throw std::runtime_error{"another program is running it"};
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

/// How the files in a run's place differ from what a run wrote there; empty if they do not, or if no run ended there.
[[nodiscard]] inline std::string damage_in(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "manifest.json") ? checkpoint::damage_in(folder) : "";
}

[[nodiscard]] inline bool is_done(const std::filesystem::path& plan, const PlannedRun& run, bool verifies) {
  return is_complete(plan, run) && (!verifies || damage_in(plan / run.folder).empty());
}

/// Throws std::invalid_argument if the lock or a folder on the way from a plan to its run is a link.
inline void check_place(const std::filesystem::path& plan, const PlannedRun& run) {
  std::filesystem::path at = plan;
  for (const auto& part : run.folder) check_no_link(at /= part);
  check_no_link(lock_of(at));
}

}  // namespace detail

bool is_complete(const std::filesystem::path& plan, const PlannedRun& run) {
  return checkpoint::holds_complete(plan / run.folder, run.fingerprint, run.seed, run.until_s);
}

Stage stage_of(const std::filesystem::path& plan, const PlannedRun& run, bool verifies) {
  const std::filesystem::path folder = plan / run.folder;
  if (detail::is_locked(folder)) return Stage::running;
  if (is_complete(plan, run)) return verifies && !detail::damage_in(folder).empty() ? Stage::failed : Stage::complete;
  const std::string status = checkpoint::status_of(folder);
  return status == "missing" ? Stage::missing : status == "failed" ? Stage::failed : Stage::interrupted;
}

void make_run(const std::filesystem::path& plan, const PlannedRun& run,
              const std::function<void(const std::filesystem::path& folder)>& work, bool verifies) {
  const std::filesystem::path folder = plan / run.folder;
  if (detail::is_done(plan, run, verifies)) {
    // Its program may have been killed before it removed the lock.
    if (!detail::is_locked(folder)) ::unlink(detail::lock_of(folder).c_str());
    return;
  }
  detail::check_place(plan, run);
  std::filesystem::create_directories(folder.parent_path());
  const detail::RunLock alone{folder};
  // Another program may have completed it before it gave the lock back.
  if (detail::is_done(plan, run, verifies)) return;
  try {
    work(folder);
  } catch (const DamagedFile& error) {
    throw DamagedFile{std::string{error.what()} + "; kept as " + checkpoint::rename_incomplete(folder).string() +
                      "; the next attempt starts without it"};
  }
  const std::string status = checkpoint::status_of(folder);
  if (status != "complete") throw std::runtime_error{"status \"" + status + "\""};
}

void check_builds(const std::filesystem::path& plan, const std::vector<PlannedRun>& runs) {
  std::vector<std::filesystem::path> complete;
  for (const PlannedRun& run : runs) {
    if (is_complete(plan, run)) complete.push_back(plan / run.folder);
  }
  if (complete.size() == runs.size()) return;
  for (const std::filesystem::path& folder : complete) checkpoint::check_build(folder);
}

}  // namespace trophic::plan
