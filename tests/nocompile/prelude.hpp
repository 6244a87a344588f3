// SPDX-License-Identifier: MIT
// What most cases include, compiled once for each compiler so that a case costs a second; a case still names what it includes.
#pragma once

#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/rules/paper.hpp>
