// SPDX-License-Identifier: MIT
// Preloaded into a program, makes system calls fail: LD_PRELOAD=this FAULT_CALL=write FAULT_AT=3 makes the third write to a file
// fail as on a full disk, with FAULT_MODE=from every later one, too. FAULT_CALL: write, fsync, rename, ftruncate, open, read or
// new. FAULT_AT=0: nothing fails, and FAULT_COUNT names a file for the number of calls that there were.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<long> calls{0};
std::atomic<bool> in_main{false};

using Main = int (*)(int, char**, char**);
Main program_main = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  in_main = true;
  const int code = program_main(argc, argv, environment);
  in_main = false;
  return code;
}

const char* text(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Whether this call is one that fails.
bool fails(const char* call) {
  if (!in_main || std::strcmp(text("FAULT_CALL"), call) != 0) return false;
  const long now = ++calls;
  const long at = std::atol(text("FAULT_AT"));
  if (at == 0) return false;
  return std::strcmp(text("FAULT_MODE"), "from") == 0 ? now >= at : now == at;
}

template <class Function>
Function next(const char* name) {
  void* found = ::dlsym(RTLD_NEXT, name);
  Function function{};
  std::memcpy(&function, &found, sizeof(function));
  return function;
}

struct Counter {
  ~Counter() {
    if (*text("FAULT_COUNT") == '\0') return;
    if (std::FILE* file = std::fopen(text("FAULT_COUNT"), "w")) {
      std::fprintf(file, "%ld\n", calls.load());
      std::fclose(file);
    }
  }
} counter;

}  // namespace

extern "C" {

/// Calls before main, of libraries that start, do not count: the program could not report their failure.
int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*loader_fini)(), void* stack_end) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  program_main = main;
  return next<Start>("__libc_start_main")(counted_main, argc, argv, init, fini, loader_fini, stack_end);
}

ssize_t write(int file, const void* bytes, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  if (file > STDERR_FILENO && fails("write")) {
    // Half of it arrives, as on a disk that fills.
    if (size > 1 && real(file, bytes, size / 2) < 0) return -1;
    errno = ENOSPC;
    return -1;
  }
  return real(file, bytes, size);
}

int fsync(int file) {
  static const auto real = next<int (*)(int)>("fsync");
  if (!fails("fsync")) return real(file);
  errno = EIO;
  return -1;
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next<int (*)(const char*, const char*)>("rename");
  if (!fails("rename")) return real(from, to);
  errno = EACCES;
  return -1;
}

int ftruncate(int file, off_t length) noexcept {
  static const auto real = next<int (*)(int, off_t)>("ftruncate");
  if (!fails("ftruncate")) return real(file, length);
  errno = EIO;
  return -1;
}

/// Fails for files that are opened to be read: too many are open.
int open(const char* path, int flags, ...) {
  using Open = int (*)(const char*, int, ...);
  static const auto real = next<Open>("open");
  std::va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  if ((flags & O_ACCMODE) != O_RDONLY || !fails("open")) return real(path, flags, mode);
  errno = EMFILE;
  return -1;
}

/// Fails for files, as a disk that fails. Pipes are read as ever.
ssize_t read(int file, void* bytes, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, void*, std::size_t)>("read");
  struct stat status {};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || !fails("read")) return real(file, bytes, size);
  errno = EIO;
  return -1;
}

}  // extern "C"

void* operator new(std::size_t size) {
  if (fails("new")) throw std::bad_alloc{};
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
