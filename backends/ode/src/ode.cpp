// SPDX-License-Identifier: MIT
// trophic::ode_compiled.
#include <trophic/backend/ode.ipp>
