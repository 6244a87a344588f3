// SPDX-License-Identifier: MIT
// Claims on runs, among programs that share only a folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace trophic::sweep {

/// A claim that has not been renewed for this long has no owner.
inline constexpr double default_lease_s = 120.0;

/// A run that this program works on. As long as the claim lives a thread renews it, four times in its lease, so that others leave
/// the run alone; it is given back when the claim is destroyed. A program that dies cannot: its claim goes stale.
///
/// A claim on run 17 is the folder "17.0": of all programs that give this name to a folder with their identity, one succeeds
/// (rename, which is atomic on network file systems where locks are not). Its age is the time since its file was last touched, by
/// the clock of the file system, as clocks of machines differ. A program that finds it stale makes "17.1", and so on. Its former
/// owner may only have been slow: a claim saves duplicate work, and correctness does not depend on it.
class Claim {
 public:
  /// Claims a run in the folder `claims`; none if another program has it. A claim of a program that ran on this machine and is
  /// dead is stale at once, and one whose time is more than a lease in the future is stale, too. Throws std::runtime_error if the
  /// system refuses, std::invalid_argument if `claims` is a link.
  [[nodiscard]] static std::optional<Claim> take(const std::filesystem::path& claims, std::size_t run, double lease_s);

  Claim(Claim&&) noexcept;
  Claim& operator=(Claim&&) noexcept;
  ~Claim();

 private:
  struct Renewal;
  Claim(std::filesystem::path claims, std::size_t run, std::size_t generation, double lease_s);

  std::unique_ptr<Renewal> renewal_;
};

/// Owner of the claim on a run, "HOST (process 123)"; empty without a claim, or if it is stale.
[[nodiscard]] std::string claimant_of(const std::filesystem::path& claims, std::size_t run, double lease_s);

}  // namespace trophic::sweep
