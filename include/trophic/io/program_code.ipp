// SPDX-License-Identifier: MIT
// Definitions of program_code.hpp.
#pragma once

#include <link.h>

#include <algorithm>
#include <cstddef>
#include <trophic/io/program_code.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/support/word_hash.hpp>

namespace trophic {

namespace detail {

/// Whether a segment is code or constants. The first one without code has the file's header and the names of symbols.
[[nodiscard]] inline bool is_code(const ElfW(Phdr) & segment) {
  const bool runs = (segment.p_flags & PF_X) != 0;
  return segment.p_type == PT_LOAD && (segment.p_flags & PF_W) == 0 && (runs || segment.p_offset != 0);
}

/// Eight bytes at any address.
using LooseWord = std::uint64_t __attribute__((aligned(1), may_alias));

/// Copies bytes without AddressSanitizer's checks, which would reject its own guards between constants.
__attribute__((no_sanitize("address"))) inline void copy_unchecked(const char* from, std::size_t size, std::uint64_t* into) {
  const volatile auto* const words = reinterpret_cast<const volatile LooseWord*>(from);
  const std::size_t whole = size / sizeof(*into);
  for (std::size_t i = 0; i < whole; ++i) into[i] = words[i];
  const volatile char* const rest = from + whole * sizeof(*into);
  for (std::size_t i = 0; i < size % sizeof(*into); ++i)
    into[whole] |= std::uint64_t{static_cast<unsigned char>(rest[i])} << 8 * i;
}

/// The bytes of a segment as words, without notes, because the linker's note changes with everything in the file.
[[nodiscard]] inline std::vector<std::uint64_t> words_of(const ElfW(Phdr) & segment, std::span<const ElfW(Phdr)> all,
                                                         ElfW(Addr) base) {
  std::vector<std::uint64_t> words(segment.p_memsz / sizeof(std::uint64_t) + 1);
  copy_unchecked(reinterpret_cast<const char*>(base + segment.p_vaddr), segment.p_memsz, words.data());
  const auto bytes = std::as_writable_bytes(std::span{words}).first(segment.p_memsz);
  for (const auto& note : all) {
    if (note.p_type != PT_NOTE || note.p_vaddr < segment.p_vaddr || note.p_vaddr >= segment.p_vaddr + bytes.size()) continue;
    const std::size_t at = note.p_vaddr - segment.p_vaddr;
    std::ranges::fill(bytes.subspan(at, std::min<std::size_t>(note.p_memsz, bytes.size() - at)), std::byte{0});
  }
  return words;
}

[[nodiscard]] inline std::uint64_t hash_words(std::span<const std::uint64_t> words) {
  WordHash hash;
  for (const std::uint64_t word : words) hash.add(word);
  return hash.value();
}

/// Hashes the object that contains this function: a program, or a library such as a Python module.
inline int hash_own_object(::dl_phdr_info* object, std::size_t, void* into) {
  const std::span segments{object->dlpi_phdr, object->dlpi_phnum};
  const auto here = reinterpret_cast<ElfW(Addr)>(&hash_own_object);
  const auto is_here = [&](const auto& segment) {
    return segment.p_type == PT_LOAD && here - (object->dlpi_addr + segment.p_vaddr) < segment.p_memsz;
  };
  if (std::ranges::none_of(segments, is_here)) return 0;
  std::string hashes;
  for (const auto& segment : segments) {
    if (is_code(segment)) hashes += std::to_string(hash_words(words_of(segment, segments, object->dlpi_addr))) + ' ';
  }
  *static_cast<std::string*>(into) = hash_text(hashes);
  return 1;
}

}  // namespace detail

TROPHIC_INLINE const std::string& program_code() {
  static const std::string code = [] {
    std::string hash;
    ::dl_iterate_phdr(detail::hash_own_object, &hash);
    return hash;
  }();
  return code;
}

}  // namespace trophic
