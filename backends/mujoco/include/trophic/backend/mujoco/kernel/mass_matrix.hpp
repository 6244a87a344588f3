// SPDX-License-Identifier: MIT
// Mass matrix and generalised forces of robots, for those whose links touch each other.
#pragma once

#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel {

/// Composite rigid bodies (Featherstone, "Rigid Body Dynamics Algorithms", ch. 6): C_i = I_i + sum of the children's C, momentum
/// F_i = C_i S_i of the subtree per unit of its joint's velocity; the mass matrix has S_k' F_i for the joints k from i to the
/// root, F_i between joint i and the root's motion, C_0 for the root. Bias forces are summed on the same way.
TROPHIC_LANES_INLINE void compose_links(const KernelModel& model, Workspace& work) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    work.composites[i].inertia = work.links[i].inertia;
    work.composites[i].bias = work.links[i].bias;
  }
  for (std::size_t i = model.links.size() - 1; i > 0; --i) {
    CompositeWork& own = work.composites[i];
    CompositeWork& parent = work.composites[model.links[i].parent];
    own.momentum = own.inertia * work.links[i].axis;
    parent.inertia.mass_kg += own.inertia.mass_kg;
    parent.inertia.moment = parent.inertia.moment + own.inertia.moment;
    for (int k = 0; k < 6; ++k) parent.inertia.rotational.v[k] += own.inertia.rotational.v[k];
    parent.bias = parent.bias + own.bias;
  }
}

}  // namespace trophic::backend::kernel
