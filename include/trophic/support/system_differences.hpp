// SPDX-License-Identifier: MIT
// The differences between Linux and macOS in file times and pipes, and the names of architecture and C library.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <trophic/support/cpp20.hpp>

#include <array>
#include <string>

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

namespace trophic {

/// When a file was last changed, in seconds since 1970.
[[nodiscard]] inline double modified_s(const struct stat& state) {
#if defined(__APPLE__)
  const timespec& time = state.st_mtimespec;
#else
  const timespec& time = state.st_mtim;
#endif
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Opens a pipe whose ends (reading end, writing end) are not inherited by child programs. Returns false, with errno, on
/// failure.
[[nodiscard]] inline bool open_pipe(std::array<int, 2>& ends) {
#if defined(__APPLE__)
  if (::pipe(ends.data()) != 0) return false;
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  return true;
#else
  return ::pipe2(ends.data(), O_CLOEXEC) == 0;
#endif
}

/// "x86_64", "aarch64"; the architecture for which the program was compiled.
[[nodiscard]] inline std::string architecture() {
#if defined(__x86_64__)
  return "x86_64";
#elif defined(__aarch64__)
  return "aarch64";
#elif defined(__riscv)
  return "riscv" + std::to_string(__riscv_xlen);
#elif defined(__powerpc64__)
  return "ppc64";
#else
  return "unknown";
#endif
}

/// "glibc 2.36": the C library with which the program runs. It determines the last bits of logarithms and sines.
[[nodiscard]] inline std::string c_library() {
#if defined(__GLIBC__)
  return std::string{"glibc "} + ::gnu_get_libc_version();
#elif defined(__APPLE__)
  return "macOS";
#else
  return "unknown";
#endif
}

}  // namespace trophic
