// SPDX-License-Identifier: MIT
// Patches that are eaten whole and regrow after a delay.
#pragma once

#include <trophic/energy/resource/contract.hpp>

namespace trophic::energy::resource {

/// Rule: a patch is one cell and holds either `patch` or nothing. After a bite it is bare, and it is full again `delay_ticks`
/// later. At the start a share `grown` of the patches is full; the others have a random part of the delay left, as in NetLogo's
/// wolf sheep predation [wilensky1997]. All parameters are free.   Reads: nothing.   Random draws: two per cell at the start.
struct DelayedPatches {
  static constexpr std::string_view name = "delayed_patches";
  static constexpr std::string_view source = "not in the paper; [wilensky1997]";

  struct Params {
    std::size_t patches_in_a_row = 51;
    double patch_J = 4.0;
    std::int64_t delay_ticks = 30;
    double grown = 0.5;
    static constexpr auto fields() {
      return std::tuple{
          field("patches_in_a_row", &Params::patches_in_a_row, between(1, 2000), "number of patches along a side of the arena")
              .read_at_start(),
          field("patch_J", &Params::patch_J, at_least(0.0), "energy of a full patch"),
          field("delay_ticks", &Params::delay_ticks, at_least(1), "ticks until a bare patch is full again"),
          field("grown", &Params::grown, between(0.0, 1.0), "share of patches that are full at the start").read_at_start()};
    }
  };
  Params params;

  /// Layer 0 holds the ticks until a patch is full.
  [[nodiscard]] ResourceField start(const Arena& arena, Rng& rng) const {
    ResourceField field{arena, params.patches_in_a_row, 1};
    for (std::size_t cell = 0; cell < field.cells(); ++cell) {
      const bool is_full = rng.chance(params.grown);
      const double wait = static_cast<double>(rng.index(static_cast<std::size_t>(params.delay_ticks)));
      field.food_J(cell) = is_full ? params.patch_J : 0.0;
      field.layer(0, cell) = is_full ? 0.0 : wait;
    }
    return field;
  }

  void grow(ResourceField& field, const View&, Rng&) const {
    for (std::size_t cell = 0; cell < field.cells(); ++cell) {
      if (field.food_J(cell) > 0.0) continue;
      if (field.layer(0, cell) <= 0.0) {
        field.food_J(cell) = params.patch_J;
      } else {
        field.layer(0, cell) -= 1.0;
      }
    }
  }

  void on_bite(ResourceField& field, std::size_t cell, double, BodyIndex, const View&) const {
    field.food_J(cell) = 0.0;
    field.layer(0, cell) = static_cast<double>(params.delay_ticks);
  }
};
static_assert(Resource<DelayedPatches>);

}  // namespace trophic::energy::resource
