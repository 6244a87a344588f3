// SPDX-License-Identifier: MIT
// Returns unused memory to the system.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace trophic::backend::mujoco {

/// Returns the whole pages of an array to the system; their content is lost. The array stays valid: reads give zeros, writes
/// allocate memory again.
inline void give_back_pages(void* array, std::size_t bytes) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(array);
  const std::uintptr_t begin = (first + page - 1) / page * page;
  const std::uintptr_t end = (first + bytes) / page * page;
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
}

/// Returns the pages of freed memory: glibc keeps those below memory that is still in use.
inline void give_back_freed_pages() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace trophic::backend::mujoco
