// SPDX-License-Identifier: MIT
// trophic::compiled: bodies, gaits, the kinematic backend and random numbers.
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/locomotion/cpg.ipp>
#include <trophic/control/locomotion/steerable.ipp>
#include <trophic/ecology/standing_poses.ipp>
#include <trophic/habitat/body/build.ipp>
#include <trophic/habitat/body/descriptors.ipp>
#include <trophic/habitat/body/distance.ipp>
#include <trophic/habitat/body/limits.ipp>
#include <trophic/habitat/body/module.ipp>
#include <trophic/habitat/body/plan.ipp>
#include <trophic/habitat/body/variation.ipp>
#include <trophic/habitat/gait.ipp>
#include <trophic/habitat/habitat.ipp>
#include <trophic/habitat/hinge_places.ipp>
#include <trophic/habitat/link_frames.ipp>
#include <trophic/habitat/touch.ipp>
#include <trophic/habitat/validate_robot.ipp>
#include <trophic/params/named_params.ipp>
#include <trophic/params/params.ipp>
#include <trophic/params/policy.ipp>
#include <trophic/support/rng.ipp>

template trophic::BackendChoice::BackendChoice(trophic::backend::Kinematic::Params);
