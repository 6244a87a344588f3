// SPDX-License-Identifier: MIT
// trophic::compiled: the file readers.
#include <trophic/habitat/load/arena.ipp>
#include <trophic/habitat/load/gait.ipp>
#include <trophic/habitat/load/habitat.ipp>
#include <trophic/habitat/load/models.ipp>
#include <trophic/habitat/load/robot.ipp>
#include <trophic/params/parse_toml.ipp>
