// SPDX-License-Identifier: MIT
// trophic::compiled: the readers of files and the writers of a run's files.
#include <trophic/habitat/load/arena.ipp>
#include <trophic/habitat/load/gait.ipp>
#include <trophic/habitat/load/habitat.ipp>
#include <trophic/habitat/load/models.ipp>
#include <trophic/habitat/load/robot.ipp>
#include <trophic/io/growing_file.ipp>
#include <trophic/io/manifest.ipp>
#include <trophic/io/program_code.ipp>
#include <trophic/io/recording.ipp>
#include <trophic/io/recording_planes.ipp>
#include <trophic/io/run_folder.ipp>
#include <trophic/observe/run_description.ipp>
#include <trophic/params/parse_toml.ipp>
#include <trophic/run.ipp>
#include <trophic/run/checkpoint/checkpoint_file.ipp>
#include <trophic/run/checkpoint/checkpoint_writer.ipp>
#include <trophic/run/checkpoint/resume.ipp>
#include <trophic/support/checksum.ipp>
#include <trophic/support/json.ipp>
#include <trophic/support/new_file.ipp>
#include <trophic/support/replace_file.ipp>
#include <trophic/support/whole_file.ipp>
