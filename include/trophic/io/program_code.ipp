// SPDX-License-Identifier: MIT
// Definitions of program_code.hpp.
#pragma once

#include <link.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <trophic/io/program_code.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic {

namespace detail {

/// Whether a segment is code or constants. The first one without code has the file's head and the names of symbols.
[[nodiscard]] inline bool is_code(const ElfW(Phdr) & segment) {
  const bool runs = (segment.p_flags & PF_X) != 0;
  return segment.p_type == PT_LOAD && (segment.p_flags & PF_W) == 0 && (runs || segment.p_offset != 0);
}

/// Copies bytes without AddressSanitizer's checks, which would refuse the guards that it puts between constants.
__attribute__((no_sanitize("address"))) inline void copy_unchecked(const volatile char* from, std::string& into) {
  for (char& byte : into) byte = *from++;
}

/// The bytes of a segment without notes: the linker's note changes with all that the file holds.
[[nodiscard]] inline std::string bytes_of(const ElfW(Phdr) & segment, std::span<const ElfW(Phdr)> all, ElfW(Addr) base) {
  std::string bytes(segment.p_memsz, '\0');
  copy_unchecked(reinterpret_cast<const volatile char*>(base + segment.p_vaddr), bytes);
  for (const auto& note : all) {
    if (note.p_type != PT_NOTE || note.p_vaddr < segment.p_vaddr || note.p_vaddr >= segment.p_vaddr + segment.p_memsz) continue;
    const std::size_t at = note.p_vaddr - segment.p_vaddr;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), std::min<std::size_t>(note.p_memsz, bytes.size() - at), '\0');
  }
  return bytes;
}

/// Hashes the program, which is the first object that the system names.
inline int hash_program(::dl_phdr_info* program, std::size_t, void* into) {
  const std::span segments{program->dlpi_phdr, program->dlpi_phnum};
  std::string hashes;
  for (const auto& segment : segments) {
    if (is_code(segment)) hashes += hash_text(bytes_of(segment, segments, program->dlpi_addr));
  }
  *static_cast<std::string*>(into) = hash_text(hashes);
  return 1;
}

}  // namespace detail

TROPHIC_INLINE const std::string& program_code() {
  static const std::string code = [] {
    std::string hash;
    ::dl_iterate_phdr(detail::hash_program, &hash);
    return hash;
  }();
  return code;
}

}  // namespace trophic
