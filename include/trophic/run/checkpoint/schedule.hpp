// SPDX-License-Identifier: MIT
// When checkpoints are written.
#pragma once

namespace trophic::checkpoint {

struct Schedule {
  double every_s = 300.0;    ///< seconds of the ecology's clock between two; 0: only where the run ends or is stopped
  double most_share = 0.01;  ///< of the wall time that may go into them: one that is due waits until it costs no more
};

}  // namespace trophic::checkpoint
