// SPDX-License-Identifier: MIT
// Whether non-template code comes with the headers or from a compiled library.
#pragma once

#include <trophic/support/cpp20.hpp>

/// Non-template functions are declared in X.hpp and defined in X.ipp. In the header-only mode, the default, X.hpp includes
/// X.ipp and they are inline. The targets trophic::compiled, trophic::mujoco_compiled and trophic::ode_compiled contain them
/// compiled and define TROPHIC_HEADER_ONLY as 0. A program then includes no definition, and none of the parsers, solvers and
/// engines that only definitions need. All parts of a program must agree.
#ifndef TROPHIC_HEADER_ONLY
#define TROPHIC_HEADER_ONLY 1
#endif

#if TROPHIC_HEADER_ONLY
#define TROPHIC_INLINE inline
#else
#define TROPHIC_INLINE
#endif
