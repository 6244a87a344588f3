// SPDX-License-Identifier: MIT
// The identity of this program: a hash of its machine code.
#pragma once

#include <string>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Returns 16 hexadecimal digits: a hash of this program's machine code and constants, as they are in memory. Rules are code, so
/// another rule, and another constant in a rule, is another hash. Another compiler, another option of it or another version of a
/// library that is linked in is another hash, too; debugging information and the revision of the sources are not in it, nor are
/// shared libraries.
[[nodiscard]] const std::string& program_code();

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/io/program_code.ipp>
#endif
