// SPDX-License-Identifier: MIT
// Definitions of claim.hpp.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <tools/command/host_name.hpp>
#include <tools/sweep/claim.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/no_links.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/system_differences.hpp>
#include <trophic/support/whole_file.hpp>
#include <utility>

namespace trophic::sweep {

namespace detail {

inline constexpr const char* owner_file = "owner.json";

[[nodiscard]] inline std::filesystem::path claim_folder(const std::filesystem::path& claims, std::size_t run,
                                                        std::size_t generation) {
  return claims / (std::to_string(run) + "." + std::to_string(generation));
}

/// Makes a unique folder, and that of the claims, which others remove whenever it is empty.
[[nodiscard]] inline std::filesystem::path new_folder(const std::filesystem::path& claims) {
  const std::string beginning = "new." + host_name() + "." + std::to_string(::gettid()) + ".";
  for (std::size_t number = 0;;) {
    std::error_code error;
    std::filesystem::create_directories(claims, error);
    check_no_link(claims);
    std::filesystem::path folder = claims / (beginning + std::to_string(number));
    if (::mkdir(folder.c_str(), 0777) == 0) return folder;
    if (errno == EEXIST) ++number;
    if (errno == EEXIST || (errno == ENOENT && !error)) continue;
    throw std::runtime_error{"cannot make " + folder.string() + ": " + std::generic_category().message(errno)};
  }
}

/// Distinguishes two processes of one number: the machine since its start, and the container.
[[nodiscard]] inline std::string process_space() {
  std::string boot;
  try {
    boot = read_beginning("/proc/sys/kernel/random/boot_id", 64);  // its size is said to be 0
  } catch (const std::invalid_argument&) {                         // on a system without it the host alone identifies a process
    boot = host_name();
  }
  while (!boot.empty() && boot.back() == '\n') boot.pop_back();
  std::error_code error;
  return boot + " " + std::filesystem::read_symlink("/proc/self/ns/pid", error).string();
}

/// Makes a file or sets its time to now, by the clock of the file system. False, with errno, if it cannot or if there is a link.
[[nodiscard]] inline bool touch(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW, 0666);
  if (file < 0) return false;
  const bool is_touched = ::futimens(file, nullptr) == 0;
  const int reason = errno;
  ::close(file);
  errno = reason;
  return is_touched;
}

[[nodiscard]] inline std::optional<double> touched_s(const std::filesystem::path& path) {
  struct stat state {};
  if (::lstat(path.c_str(), &state) != 0) return std::nullopt;
  return modified_s(state);
}

/// Age of a claim since it was made or renewed, by the clock of the file system; `nullopt` if it was given back meanwhile.
[[nodiscard]] inline std::optional<double> age_s(const std::filesystem::path& claim) {
  const auto renewed = touched_s(claim / owner_file);
  const auto last = renewed ? renewed : touched_s(claim);
  if (!last) return std::nullopt;
  const std::filesystem::path now = claim.parent_path() / ("now." + host_name() + "." + std::to_string(::gettid()));
  if (!touch(now)) throw std::runtime_error{"cannot write " + now.string() + ": " + std::generic_category().message(errno)};
  const auto now_s = touched_s(now);
  std::error_code error;
  std::filesystem::remove(now, error);
  return now_s ? *now_s - *last : 0.0;
}

struct Owner {
  std::string host;
  pid_t process;
  std::string space;
};

/// Identity of a claim's owner; `nullopt` if it cannot be read.
[[nodiscard]] inline std::optional<Owner> owner_of(const std::filesystem::path& claim) {
  try {
    constexpr std::uint64_t largest_owner = 64 * 1024;
    const Json json = parse_json(read_whole_file(claim / owner_file, largest_owner));
    return Owner{.host = plain_text(json, "host"),
                 .process = whole_number<pid_t>(json, "process", 1),
                 .space = json.at("space").get<std::string>()};
  } catch (const std::invalid_argument&) {  // not yet written, given back, or a process that cannot be
    return std::nullopt;
  } catch (const Json::exception&) {  // a file of another program
    return std::nullopt;
  }
}

/// Whether it was claimed by a process of this machine that has died.
[[nodiscard]] inline bool is_dead(const Owner& owner) {
  return owner.space == process_space() && ::kill(owner.process, 0) != 0 && errno == ESRCH;
}

[[nodiscard]] inline bool is_stale(const std::filesystem::path& claim, double lease_s) {
  const auto owner = owner_of(claim);
  if (owner && is_dead(*owner)) return true;
  // A time in the future is that of a clock that was wrong: a claim that is alive is given the time of now again.
  const auto age = age_s(claim);
  return age && std::abs(*age) > lease_s;
}

/// The last claim on a run, if there is one.
[[nodiscard]] inline std::optional<std::size_t> last_generation(const std::filesystem::path& claims, std::size_t run) {
  std::optional<std::size_t> last;
  for (std::size_t next = 0; std::filesystem::exists(claim_folder(claims, run, next)); ++next) last = next;
  return last;
}

}  // namespace detail

struct Claim::Renewal {
  std::filesystem::path claims;
  std::size_t run;
  std::size_t generation;
  std::mutex mutex = {};
  std::condition_variable_any woken = {};
  std::jthread thread = {};

  void renew_every(double period_s) {
    thread = std::jthread{[this, period_s](const std::stop_token& stop) {
      std::unique_lock lock{mutex};
      const auto period = std::chrono::duration<double>{period_s};
      while (!woken.wait_for(lock, stop, period, [&] { return stop.stop_requested(); }) && !stop.stop_requested()) {
        // A claim that cannot be renewed goes stale, and another program does the run, too: only time is lost.
        static_cast<void>(detail::touch(detail::claim_folder(claims, run, generation) / detail::owner_file));
      }
    }};
  }
};

Claim::Claim(std::filesystem::path claims, std::size_t run, std::size_t generation, double lease_s)
    : renewal_{new Renewal{std::move(claims), run, generation}} {
  renewal_->renew_every(lease_s / 4.0);
}
Claim::Claim(Claim&&) noexcept = default;
Claim& Claim::operator=(Claim&&) noexcept = default;

Claim::~Claim() {
  if (!renewal_) return;
  renewal_->thread.request_stop();
  renewal_->thread.join();
  std::error_code error;
  for (std::size_t generation = renewal_->generation + 1; generation-- > 0;) {
    std::filesystem::remove_all(detail::claim_folder(renewal_->claims, renewal_->run, generation), error);
  }
}

std::optional<Claim> Claim::take(const std::filesystem::path& claims, std::size_t run, double lease_s) {
  const auto last = detail::last_generation(claims, run);
  if (last && !detail::is_stale(detail::claim_folder(claims, run, *last), lease_s)) return std::nullopt;
  const std::size_t generation = last ? *last + 1 : 0;
  const std::filesystem::path own = detail::new_folder(claims);
  const Json owner{{"host", host_name()}, {"process", ::getpid()}, {"space", detail::process_space()}};
  replace_file(own / detail::owner_file, json_text(owner) + "\n");
  const std::filesystem::path folder = detail::claim_folder(claims, run, generation);
  std::error_code error;
  std::filesystem::rename(own, folder, error);
  if (error) {
    const std::string why = error.message();
    const bool is_taken = error == std::errc::directory_not_empty || error == std::errc::file_exists;
    std::filesystem::remove_all(own, error);
    if (is_taken) return std::nullopt;
    throw std::runtime_error{"cannot make " + folder.string() + ": " + why};
  }
  return Claim{claims, run, generation, lease_s};
}

std::string claimant_of(const std::filesystem::path& claims, std::size_t run, double lease_s) {
  const auto last = detail::last_generation(claims, run);
  if (!last) return "";
  const std::filesystem::path folder = detail::claim_folder(claims, run, *last);
  if (detail::is_stale(folder, lease_s)) return "";
  const auto owner = detail::owner_of(folder);
  return owner ? owner->host + " (process " + std::to_string(owner->process) + ")" : "another program";
}

}  // namespace trophic::sweep
