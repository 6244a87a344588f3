// SPDX-License-Identifier: MIT
// Selects whether non-template code comes with the headers or from a compiled library.
#pragma once

#include <trophic/support/cpp20.hpp>

/// Non-template functions are declared in X.hpp and defined in X.ipp. In the header-only mode, the default, X.hpp includes
/// X.ipp and they are inline. The targets trophic::compiled, trophic::mujoco_compiled and trophic::ode_compiled contain them in
/// compiled form and define TROPHIC_HEADER_ONLY as 0. A program then includes neither the definitions nor the parsers, solvers
/// and engines that only they need. All parts of a program must use the same mode.
#ifndef TROPHIC_HEADER_ONLY
#define TROPHIC_HEADER_ONLY 1
#endif

#if TROPHIC_HEADER_ONLY
#define TROPHIC_INLINE inline
#else
#define TROPHIC_INLINE
#endif
