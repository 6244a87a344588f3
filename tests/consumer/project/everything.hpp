// SPDX-License-Identifier: MIT
// Everything public, for two translation units: what is included is there, and two definitions of anything that is not inline do
// not link.
#pragma once

#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef CONSUMER_HAS_ode
#include <trophic/backend/ode.hpp>
#endif

double first_draw_of_other_unit();
