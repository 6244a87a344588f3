// SPDX-License-Identifier: MIT
// Preloaded into a program, logs what it does to files: LD_PRELOAD=this CRASH_LOG=FILE CRASH_ROOT=FOLDER logs each call that
// changes something below the folder, one a line, for power_test.py: the call, its path, and what it changes, separated by tabs.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>

namespace {

template <class Function>
Function next(const char* name) {
  void* found = ::dlsym(RTLD_NEXT, name);
  Function function{};
  std::memcpy(&function, &found, sizeof(function));
  return function;
}

/// A path as one that is absolute, whatever it is relative to.
std::string absolute(int folder, const char* path) {
  if (*path == '/') return path;
  std::array<char, PATH_MAX> name{};
  const std::string link = folder == AT_FDCWD ? "/proc/self/cwd" : "/proc/self/fd/" + std::to_string(folder);
  const ssize_t length = ::readlink(link.c_str(), name.data(), name.size());
  return std::string{name.data(), length < 0 ? 0U : static_cast<std::size_t>(length)} + "/" + path;
}

std::string path_of(int file) {
  std::array<char, PATH_MAX> name{};
  const ssize_t length = ::readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), name.data(), name.size());
  return {name.data(), length < 0 ? 0U : static_cast<std::size_t>(length)};
}

void log(std::string_view call, const std::string& path, const std::string& what = "") {
  const char* root = std::getenv("CRASH_ROOT");
  const char* name = std::getenv("CRASH_LOG");
  if (root == nullptr || name == nullptr || !path.starts_with(std::string{root} + "/")) return;
  static std::mutex mutex;
  const std::scoped_lock lock{mutex};
  static const int file = next<int (*)(const char*, int, ...)>("open")(name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const std::string line = std::string{call} + "\t" + path + "\t" + what + "\n";
  static const auto write_out = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  if (write_out(file, line.data(), line.size()) < 0) std::abort();
}

std::string hex(const void* bytes, std::size_t size) {
  std::string text;
  const auto* each = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < size; ++i) {
    text += "0123456789abcdef"[each[i] >> 4U];
    text += "0123456789abcdef"[each[i] & 15U];
  }
  return text;
}

/// Where the next write to a file goes.
long long place_in(int file) {
  const int before = errno;
  long long place = ::lseek(file, 0, SEEK_CUR);
  struct stat state {};
  if ((::fcntl(file, F_GETFL) & O_APPEND) != 0 && ::fstat(file, &state) == 0) place = state.st_size;
  errno = before;
  return place;
}

/// Opens by the system's own function, and logs a file that was made or emptied.
template <class Open>
int open_and_log(const std::string& path, int flags, Open&& open_it) {
  struct stat state {};
  const bool was_there = ::lstat(path.c_str(), &state) == 0;
  const int file = open_it();
  if (file < 0) return file;
  if (!was_there && (flags & O_CREAT) != 0) log("create", path);
  if (was_there && (flags & O_TRUNC) != 0) log("truncate", path, "0");
  return file;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  static const auto real = next<int (*)(const char*, int, ...)>("open");
  return open_and_log(absolute(AT_FDCWD, path), flags, [&] { return real(path, flags, mode); });
}

int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  static const auto real = next<int (*)(const char*, int, ...)>("open64");
  return open_and_log(absolute(AT_FDCWD, path), flags, [&] { return real(path, flags, mode); });
}

ssize_t write(int file, const void* bytes, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  const long long place = place_in(file);
  const ssize_t written = real(file, bytes, size);
  if (written > 0) {
    const int before = errno;
    log("write", path_of(file), std::to_string(place) + " " + hex(bytes, static_cast<std::size_t>(written)));
    errno = before;
  }
  return written;
}

ssize_t sendfile(int to, int from, off_t* offset, std::size_t size) {
  // Copies by write, which is logged.
  std::array<char, 65536> piece{};
  const ssize_t got = offset == nullptr ? ::read(from, piece.data(), std::min(size, piece.size()))
                                        : ::pread(from, piece.data(), std::min(size, piece.size()), *offset);
  if (got <= 0) return got;
  const ssize_t written = write(to, piece.data(), static_cast<std::size_t>(got));
  if (offset != nullptr && written > 0) *offset += written;
  return written;
}

ssize_t copy_file_range(int, off_t*, int, off_t*, std::size_t, unsigned) {
  errno = ENOSYS;
  return -1;
}

int ftruncate(int file, off_t length) noexcept {
  static const auto real = next<int (*)(int, off_t)>("ftruncate");
  const int result = real(file, length);
  if (result == 0) log("truncate", path_of(file), std::to_string(length));
  return result;
}

int fsync(int file) {
  static const auto real = next<int (*)(int)>("fsync");
  const int result = real(file);
  if (result == 0) log("fsync", path_of(file));
  return result;
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next<int (*)(const char*, const char*)>("rename");
  const int result = real(from, to);
  if (result == 0) log("rename", absolute(AT_FDCWD, from), absolute(AT_FDCWD, to));
  return result;
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto real = next<int (*)(const char*, mode_t)>("mkdir");
  const int result = real(path, mode);
  if (result == 0) log("mkdir", absolute(AT_FDCWD, path));
  return result;
}

int unlink(const char* path) noexcept {
  static const auto real = next<int (*)(const char*)>("unlink");
  const int result = real(path);
  if (result == 0) log("remove", absolute(AT_FDCWD, path));
  return result;
}

int remove(const char* path) noexcept {
  static const auto real = next<int (*)(const char*)>("remove");
  const int result = real(path);
  if (result == 0) log("remove", absolute(AT_FDCWD, path));
  return result;
}

int unlinkat(int folder, const char* path, int flags) noexcept {
  static const auto real = next<int (*)(int, const char*, int)>("unlinkat");
  const std::string whole = absolute(folder, path);
  const int result = real(folder, path, flags);
  if (result == 0) log("remove", whole);
  return result;
}

}  // extern "C"
