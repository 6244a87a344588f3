// SPDX-License-Identifier: MIT
// trophic::command_compiled: the part of the command line that no rule table changes.
#include <trophic/command/experiment_program.ipp>
#include <trophic/command/play_contests.ipp>
#include <trophic/command/run_command.ipp>
#include <trophic/command/run_experiment.ipp>
#include <trophic/command/run_live.ipp>
#include <trophic/command/sweep.ipp>
#include <trophic/command/sweep_status.ipp>
