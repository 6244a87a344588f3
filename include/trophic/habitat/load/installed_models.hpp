// SPDX-License-Identifier: MIT
// The folder of the models that are installed with the library.
#pragma once

/// The folder of the models, in the source tree or installed. CMake defines it; otherwise an installed header names the folder
/// next to itself. It is a default argument of every loader, because a compiled library may be installed elsewhere. Empty: none.
#ifndef TROPHIC_MODEL_DIR
#if __has_include(<trophic/habitat/load/installed_model_dir.hpp>)
#include <trophic/habitat/load/installed_model_dir.hpp>
#else
#define TROPHIC_MODEL_DIR ""
#endif
#endif
