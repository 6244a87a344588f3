// SPDX-License-Identifier: MIT
// Every public header but the command line's, for two translation units: what is not inline does not
// link.
#pragma once

#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef CONSUMER_HAS_ode
#include <trophic/backend/ode.hpp>
#endif

double first_draw_of_other_unit();
