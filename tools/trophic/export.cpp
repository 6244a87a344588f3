// SPDX-License-Identifier: MIT
// `trophic export`: a stretch of a recorded run as a file for programs that draw: Blender, slides, web pages.
#include "commands.hpp"

#include <memory>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/trophic/replay/gltf_scene.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command {

namespace detail::export_run {

struct Options {
  std::string run;
  std::string out;
  replay::Window window;
  std::optional<std::uint64_t> follow;
};

[[nodiscard]] int run(Options options) {
  if (options.out.empty()) options.out = free_name(options.run, ".glb");
  const std::filesystem::path out = options.out;
  if (out.extension() != ".glb" && out.extension() != ".gltf") {
    throw std::invalid_argument{"--out " + options.out + ": must end in .glb or .gltf"};
  }
  check_new_file("--out", out);
  const replay::RecordedRun run = replay::open_run(options.run);
  for (const std::string& remark : run.remarks) std::cerr << "trophic export: " << remark << "\n";
  options.window.check(run.recording);
  const replay::GltfScene scene{run, options.window.start_s(run.recording), options.window.end_s(run.recording), options.follow};
  const std::string content = out.extension() == ".glb" ? scene.file().glb() : scene.file().gltf();
  write_new_file(out, content);
  std::cout << shown(options.out) << ": " << scene.individuals() << (scene.individuals() == 1 ? " robot, " : " robots, ")
            << scene.frames() << (scene.frames() == 1 ? " frame, " : " frames, ")
            << observe::short_text(static_cast<double>(content.size()) / 1e6) << " MB\n";
  flush_output();
  return 0;
}

}  // namespace detail::export_run

/// Makes a glTF file of a recorded run.
Command export_run() {
  const auto options = std::make_shared<detail::export_run::Options>();
  return {
      .name = "export",
      .about =
          "Writes part of a recorded run as glTF 2.0, which Blender, slides and web pages can open: robots as boxes in the "
          "colours of their species, the motion of robots and joints, the floor and the walls.",
      .options = {{.name = "run", .target = &options->run, .help = "folder of a run", .required = true},
                  {.name = "--out",
                   .target = &options->out,
                   .help = "new file, .glb (binary) or .gltf (text) (default: RUN.glb, or the next free RUN-2.glb, ...)",
                   .shorthand = "-o"},
                  {.name = "--from", .target = &options->window.from_s, .help = "start, in seconds (default: the run's start)"},
                  {.name = "--to",
                   .target = &options->window.to_s,
                   .help = "end, in seconds (default: the run's end); a value equal to --from gives one pose"},
                  {.name = "--follow", .target = &options->follow, .help = "only the individual with this id"}},
      .work = [options] { return detail::export_run::run(*options); }};
}

}  // namespace trophic::command
