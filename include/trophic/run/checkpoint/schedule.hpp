// SPDX-License-Identifier: MIT
// When checkpoints are written.
#pragma once

namespace trophic::checkpoint {

struct Schedule {
  double every_s = 300.0;    ///< seconds of the ecology's clock between two; 0: only when the run ends or is stopped
  double most_share = 0.01;  ///< largest share of the wall time for them: a checkpoint that is due waits until it costs no more
};

}  // namespace trophic::checkpoint
