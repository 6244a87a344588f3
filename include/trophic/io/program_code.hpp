// SPDX-License-Identifier: MIT
// The identity of this program: a hash of its machine code.
#pragma once

#include <string>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Returns 16 hexadecimal digits: a hash of this program's machine code and constants, as they are in memory. Rules are code, so
/// a different rule, or a different constant in a rule, gives a different hash. So does a different compiler, compiler option or
/// version of a statically linked library. Debugging information, the revision of the sources and shared libraries have no
/// effect. In a shared library that contains trophic, such as a Python module, it is that library's hash.
[[nodiscard]] const std::string& program_code();

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/io/program_code.ipp>
#endif
