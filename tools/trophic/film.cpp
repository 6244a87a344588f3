// SPDX-License-Identifier: MIT
// `trophic film`: pictures, contact sheets and films of a recorded run, without a screen.
#include "commands.hpp"

#include <memory>
#include <tools/command/option.hpp>
// Defined in programs that link trophic::film.
#ifdef TROPHIC_WITH_FILM
#include <iostream>
#include <tools/command/output.hpp>
#include <tools/trophic/replay/film_run.hpp>
#include <tools/trophic/replay/robot_picture.hpp>
#include <trophic/support/new_file.hpp>
#endif

namespace trophic::command {

namespace detail::film {

/// Options of the command line.
struct Options {
  std::string run;
  std::string robot;
  std::string out;
  std::optional<double> from_s;
  std::optional<double> to_s;
  std::optional<std::uint64_t> follow;
  std::string sheet;
  std::string size;
  std::string view = "orbit";
  std::optional<double> speed;
  std::optional<std::string> catch_;
  std::string lines = "on";
  std::string legend = "on";
  std::optional<std::string> title;
  std::uint64_t fps = 30;
  bool fine = false;
};

#ifdef TROPHIC_WITH_FILM
/// The picture of a robot file.
[[nodiscard]] int draw_robot(const Options& options) {
  if (!options.run.empty()) throw std::invalid_argument{"--robot: not with a run; its recording has its robot"};
  if (options.from_s || options.to_s || options.follow || options.catch_ || !options.sheet.empty()) {
    throw std::invalid_argument{"--robot: not with --from, --to, --follow, --catch or --sheet, which are of a run"};
  }
  if (!options.out.ends_with(".png")) throw std::invalid_argument{"--out " + options.out + ": must end in .png with --robot"};
  check_new_file("--out", options.out);
  const auto [width, height] = replay::two_numbers("--size", options.size.empty() ? "1280x720" : options.size, 4096);
  replay::draw_robot({.robot = options.robot,
                      .out = options.out,
                      .width = width,
                      .height = height,
                      .from_above = options.view == "top",
                      .has_legend = options.legend == "on"});
  std::cout << shown(options.out) << ": 1 picture\n";
  flush_output();
  return 0;
}

[[nodiscard]] int run(const Options& options) {
  if (!options.robot.empty()) return draw_robot(options);
  if (options.run.empty()) throw std::invalid_argument{"either the folder of a run, or --robot and a robot file"};
  return replay::film_run({.folder = options.run,
                           .out = options.out,
                           .window = {options.from_s, options.to_s},
                           .follow = options.follow,
                           .sheet = options.sheet,
                           .size = options.size,
                           .from_above = options.view == "top",
                           .speed = options.speed,
                           .catch_ = options.catch_,
                           .has_lines = options.lines == "on",
                           .has_legend = options.legend == "on",
                           .title = options.title,
                           .fps = options.fps,
                           .fine = options.fine});
}
#else
[[nodiscard]] int run(const Options&) {
  throw std::invalid_argument{
      "this program was built without pictures; apt-get install libmujoco-dev libegl-dev libpng-dev and build again"};
}
#endif

}  // namespace detail::film

/// Makes pictures of a recorded run.
Command film() {
  const auto options = std::make_shared<detail::film::Options>();
  return {
      .name = "film",
      .about =
          "Draws a recorded run on any machine, without a screen: a picture or a contact sheet as PNG, a film as mp4, webm or "
          "gif (by ffmpeg).",
      .options = {{.name = "run", .target = &options->run, .help = "folder of a run"},
                  {.name = "--robot", .target = &options->robot, .help = "draw a robot file instead of a run: its name or path"},
                  {.name = "--out",
                   .target = &options->out,
                   .help = "new file: .png, .mp4, .webm or .gif",
                   .required = true,
                   .shorthand = "-o"},
                  {.name = "--from",
                   .target = &options->from_s,
                   .help = "the moment of a picture, or the start of a film, seconds (the run's)"},
                  {.name = "--to", .target = &options->to_s, .help = "the end, seconds (the run's)"},
                  {.name = "--follow", .target = &options->follow, .help = "stay near the individual of that id, and mark it"},
                  {.name = "--catch",
                   .target = &options->catch_,
                   .help = "show a catch from 8 s before it, both robots in the picture: its number in the run, from 1, or best"},
                  {.name = "--sheet",
                   .target = &options->sheet,
                   .help = "a contact sheet of so many pictures, e.g. 4x3, from --from to --to"},
                  {.name = "--size", .target = &options->size, .help = "pixels of each picture (1280x720; 480x360 in a sheet)"},
                  {.name = "--view",
                   .target = &options->view,
                   .help = "orbit, the arena from the south, or top (orbit)",
                   .words = {"orbit", "top"}},
                  {.name = "--speed", .target = &options->speed, .help = "ecology seconds a second of film (10; of a catch 1)"},
                  {.name = "--fps", .target = &options->fps, .help = "pictures a second of film (30)"},
                  {.name = "--lines",
                   .target = &options->lines,
                   .help = "trails, and lines from robots to those that they perceive (on)",
                   .words = {"on", "off"}},
                  {.name = "--legend",
                   .target = &options->legend,
                   .help = "title, marks with their meaning, counts of species, a scale, in pictures of at least 560 pixels (on)",
                   .words = {"on", "off"}},
                  {.name = "--title", .target = &options->title, .help = "the title (the run's name, rules, backend and seed)"},
                  {.name = "--fine",
                   .target = &options->fine,
                   .help = "films with edges as smooth as those of pictures; four times as slow"}},
      .work = [options] { return detail::film::run(*options); },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
