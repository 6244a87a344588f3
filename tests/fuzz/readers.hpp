// SPDX-License-Identifier: MIT
// Every reader of trophic's as a function of bytes, for fuzzers.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <support/forged_recording.hpp>
#include <support/temporary_folder.hpp>
#include <tools/changes/change.hpp>
#include <tools/command/config.hpp>
#include <tools/command/toml_of_json.hpp>
#include <tools/contest/contest_plan.hpp>
#include <tools/live/wishes.hpp>
#include <tools/plan/plan_file.hpp>
#include <tools/reading/checked_rows.hpp>
#include <tools/reading/lineages.hpp>
#include <tools/reading/table_reader.hpp>
#include <tools/recording/read_recording.hpp>
#include <tools/trophic/convert/foreign_body.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/io/recording_planes.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/rules/with.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>

namespace trophic::test {

/// The path of a file that holds these bytes and needs no disk; lives as long as this.
class FileInMemory {
 public:
  explicit FileInMemory(std::string_view bytes) : file_{::memfd_create("trophic", 0)} {
    if (file_ < 0 || ::write(file_, bytes.data(), bytes.size()) != static_cast<::ssize_t>(bytes.size())) {
      throw std::runtime_error{"no file in memory"};
    }
  }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  ~FileInMemory() { ::close(file_); }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

inline void read_robot(std::string_view bytes) {
  static_cast<void>(load_robot(FileInMemory{bytes}.path()));
}
inline void read_arena(std::string_view bytes) {
  static_cast<void>(load_arena(FileInMemory{bytes}.path()));
}
inline void read_gait(std::string_view bytes) {
  static_cast<void>(load_gait(FileInMemory{bytes}.path()));
}

using FuzzedExperiment = Experiment<rules::Released>;

inline void read_config(std::string_view bytes) {
  const FileInMemory file{bytes};
  FuzzedExperiment experiment;
  command::apply_config(param_refs(experiment), command::read_config(file.path(), {}));
  validate(experiment, "");
}
inline void read_assignment(std::string_view bytes) {
  FuzzedExperiment experiment;
  command::apply_config(param_refs(experiment), command::read_config("", {std::string{bytes}}));
  validate(experiment, "");
}

inline const FoodWeb& fuzzed_web() {
  static const FoodWeb web{{"prey", "predator"}, {{1, 0}}};
  return web;
}
template <io::TableRow Row>
void read_table(std::string_view bytes) {
  const FileInMemory file{bytes};
  const FoodWeb web = fuzzed_web();
  analysis::TableReader<Row> table{file.path(), web};
  for (Row row; table.next(row);) continue;
}
inline void read_manifest(std::string_view bytes) {
  static_cast<void>(analysis::manifest_of(bytes, "manifest.json"));
}

inline void read_checkpoint_file(std::string_view bytes) {
  static_cast<void>(checkpoint::from_bytes(bytes, "checkpoint.bin"));
}
/// Four robots of a table.
template <class Rules>
[[nodiscard]] Ecology<Rules> fuzzed_ecology(Experiment<Rules> experiment = {}) {
  experiment.ecology.robots = 4;
  experiment.rules.community.predators = 2;
  static const Habitat habitat = load_habitat(experiment.ecology);
  return Ecology<Rules>{experiment, backend::Kinematic::Params{}, habitat};
}

/// With a rule whose bodies may be spare and whose individuals have a state.
using Recruited = with_recruitment<rules::Released, reproduction::recruitment::AfterEscapes>;
[[nodiscard]] inline Ecology<Recruited> recruited_ecology() {
  Experiment<Recruited> experiment;
  experiment.rules.recruitment.spare_bodies = 1;
  return fuzzed_ecology(experiment);
}

inline void read_state(Simulation& ecology, std::string_view bytes) {
  Archive archive{bytes};
  ecology.persist(archive);
  archive.finish();
}
/// A checkpoint's section of an ecology: bytes behind the checksum, which must do no harm even if they are forged.
inline void read_ecology(std::string_view bytes) {
  auto ecology = fuzzed_ecology<rules::Released>();
  read_state(ecology, bytes);
}
inline void read_recruited(std::string_view bytes) {
  auto ecology = recruited_ecology();
  read_state(ecology, bytes);
  ecology.run_until(ecology.time_s() + 4.0);
}

/// A recording whose checksums are right: the bytes behind them must do no harm even if they are forged.
inline void read_whole_recording(const std::string& bytes) {
  const FileInMemory file{bytes};
  const io::RecordingReader recording{file.path()};
  const std::size_t last_robot = recording.head().robots - 1;
  for (const std::size_t frame : {std::size_t{0}, recording.frames() / 2, recording.frames() - 1}) {
    static_cast<void>(recording.frame_at(recording.time_s(frame)));
    static_cast<void>(recording.root(frame, last_robot));
    for (std::size_t joint = 0; joint < recording.head().joints; ++joint) {
      static_cast<void>(recording.joint_angle_rad(frame, last_robot, joint));
    }
  }
}

inline void read_recording(std::string_view bytes) {
  read_whole_recording(with_right_checksums(std::string{bytes}));
}
/// The head of a recording, before a frame of one robot without joints.
inline void read_head(std::string_view bytes) {
  using namespace io::recording;
  std::string frames;
  append_u32(frames, 0);
  append_u32(frames, 1);
  frames += packed(std::vector<std::int16_t>(pose_channels), pose_channels);
  read_whole_recording(recording_with(bytes, block(frames_kind, frames)));
}

inline void read_plan(std::string_view bytes) {
  static_cast<void>(plan::read_plan(FileInMemory{bytes}.path()));
}

/// A plan of contests, and its numbers as those of an experiment.
inline void read_contest(std::string_view bytes) {
  const contest::Plan plan = contest::read_plan(FileInMemory{bytes}.path());
  FuzzedExperiment experiment;
  command::read_parameters(experiment, command::toml_of(plan.params));
  validate(experiment, "");
}

/// A body of another program, to its robot file.
inline void read_body(std::string_view bytes) {
  const convert::ForeignBody foreign = convert::read_foreign_body(bytes, "body");
  body::Design design;
  design.name = "body";
  design.modules = foreign.modules;
  static_cast<void>(body::build(design));
  static_cast<void>(convert::robot_file(foreign, "body"));
}

/// A folder for the tables of a run until 600 s, written anew by each case.
inline analysis::RunManifest run_with_tables(std::string_view first, std::string_view first_bytes, std::string_view second,
                                             std::string_view second_bytes) {
  static const TemporaryFolder folder;
  static_cast<void>(folder.file(first, first_bytes));
  static_cast<void>(folder.file(second, second_bytes));
  analysis::RunManifest run;
  run.folder = folder.path();
  run.status = "complete";
  run.until_s = 600.0;
  run.reached_s = 600.0;
  run.web = fuzzed_web();
  run.policies = Json::object();
  return run;
}

/// Two tables, of which the second begins after the first empty line.
template <class Read>
void read_two_tables(std::string_view bytes, const char* first, const char* second, Read&& read) {
  const std::size_t end = std::min(bytes.find("\n\n"), bytes.size());
  read(run_with_tables(first, bytes.substr(0, std::min(end + 1, bytes.size())), second,
                       bytes.substr(std::min(end + 2, bytes.size()))));
}

inline void read_lineages(std::string_view bytes) {
  read_two_tables(bytes, "phylogeny.csv", "genomes.csv", [](const analysis::RunManifest& run) {
    analysis::for_each_row<io::TaxonRow>(run, "phylogeny.csv", [&](const io::TaxonRow& row) {
      analysis::check_taxon(row, run);
      static_cast<void>(analysis::parents_in(row.ancestor_list));
    });
    analysis::for_each_row<io::GenomeRow>(run, "genomes.csv", [](const io::GenomeRow&) {});
  });
}
inline void read_changes(std::string_view bytes) {
  static_cast<void>(changes::read_changes(FileInMemory{bytes}.path()));
}
/// A message of a page to a live run.
inline void read_wish(std::string_view bytes) {
  static const command::LiveRun run{
      .folder = {}, .rule_table = "paper", .rule_tables = {"paper", "released"}, .numbers = named_params_of(FuzzedExperiment{})};
  static_cast<void>(live::read_wish(bytes, run));
}

/// A reader and the folder of its corpus.
struct Reader {
  std::string_view name;
  void (*read)(std::string_view bytes);
};
inline constexpr std::array readers{Reader{"robot", read_robot},
                                    Reader{"arena", read_arena},
                                    Reader{"gait", read_gait},
                                    Reader{"config", read_config},
                                    Reader{"assignment", read_assignment},
                                    Reader{"events", read_table<io::EventRow>},
                                    Reader{"agents", read_table<io::AgentRow>},
                                    Reader{"manifest", read_manifest},
                                    Reader{"checkpoint", read_checkpoint_file},
                                    Reader{"ecology", read_ecology},
                                    Reader{"recruited", read_recruited},
                                    Reader{"recording", read_recording},
                                    Reader{"head", read_head},
                                    Reader{"plan", read_plan},
                                    Reader{"contest", read_contest},
                                    Reader{"body", read_body},
                                    Reader{"lineages", read_lineages},
                                    Reader{"changes", read_changes},
                                    Reader{"wish", read_wish}};

/// Reads arbitrary bytes. A reader may throw std::invalid_argument or std::runtime_error; any other exception
/// propagates.
inline void try_reader(const Reader& reader, std::string_view bytes) {
  try {
    reader.read(bytes);
  } catch (const std::invalid_argument&) {  // a sentence for the user
  } catch (const std::runtime_error&) {     // likewise
  }
}

}  // namespace trophic::test
