// SPDX-License-Identifier: MIT
// Where the models lie that came with the library.
#pragma once

/// The folder that the library was built or installed with; a default argument of every loader, because a library that was
/// compiled in one place may be installed in another. Its CMake targets define it; empty: there is none.
#ifndef TROPHIC_MODEL_DIR
#define TROPHIC_MODEL_DIR ""
#endif
