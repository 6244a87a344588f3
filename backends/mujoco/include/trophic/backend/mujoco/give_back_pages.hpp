// SPDX-License-Identifier: MIT
// Memory that nobody needs goes back to the system.
#pragma once

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>

namespace trophic::backend::mujoco {

/// Gives the whole pages of an array back, whose content is lost. The array stays: whoever reads it gets zeros, whoever writes it
/// gets memory again.
inline void give_back_pages(void* array, std::size_t bytes) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(array);
  const std::uintptr_t begin = (first + page - 1) / page * page;
  const std::uintptr_t end = (first + bytes) / page * page;
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
}

/// Gives back the pages of what was freed: glibc keeps those that lie below something that is still in use.
inline void give_back_freed_pages() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace trophic::backend::mujoco
