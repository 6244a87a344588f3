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
[[nodiscard]] int draw_robot(Options options) {
  if (options.out.empty()) options.out = free_name(options.robot, ".png");
  if (!options.run.empty()) throw std::invalid_argument{"--robot: not with a run, whose recording has its robot"};
  if (options.from_s || options.to_s || options.follow || options.catch_ || !options.sheet.empty()) {
    throw std::invalid_argument{"--robot: not with --from, --to, --follow, --catch or --sheet, which need a run"};
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

[[nodiscard]] int run(Options options) {
  if (!options.robot.empty()) return draw_robot(std::move(options));
  if (options.run.empty()) throw std::invalid_argument{"needs either the folder of a run, or --robot with a robot file"};
  if (options.out.empty()) options.out = free_name(options.run, options.sheet.empty() ? ".mp4" : ".png");
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
      "this program was built without pictures; run apt-get install libmujoco-dev libegl-dev libpng-dev and build it again"};
}
#endif

}  // namespace detail::film

/// Makes pictures of a recorded run.
Command film() {
  const auto options = std::make_shared<detail::film::Options>();
  return {
      .name = "film",
      .about =
          "Draws a recorded run on any machine, without a screen: a picture or a contact sheet as PNG, or a film as mp4, webm or "
          "gif (with ffmpeg).",
      .options =
          {{.name = "run", .target = &options->run, .help = "folder of a run"},
           {.name = "--robot", .target = &options->robot, .help = "draw this robot file instead of a run (its name or path)"},
           {.name = "--out",
            .target = &options->out,
            .help = "new file: .png, .mp4, .webm or .gif (default: RUN.mp4, or .png with --sheet or --robot; or the next free "
                    "RUN-2.mp4, ...)",
            .shorthand = "-o"},
           {.name = "--from",
            .target = &options->from_s,
            .help = "time of a picture, or start of a film, in seconds (default: the run's start)"},
           {.name = "--to", .target = &options->to_s, .help = "end of a film, in seconds (default: the run's end)"},
           {.name = "--follow", .target = &options->follow, .help = "follow the individual with this id, and mark it"},
           {.name = "--catch",
            .target = &options->catch_,
            .help = "show a catch, from 8 s before it, with both robots in the picture: its number in the run, counted from 1, "
                    "or best"},
           {.name = "--sheet",
            .target = &options->sheet,
            .help = "make a contact sheet of this many pictures, e.g. 4x3, from --from to --to"},
           {.name = "--size", .target = &options->size, .help = "pixels of each picture (default: 1280x720; 480x360 in a sheet)"},
           {.name = "--view",
            .target = &options->view,
            .help = "camera: orbit (the arena from the south) or top (default: orbit)",
            .words = {"orbit", "top"}},
           {.name = "--speed",
            .target = &options->speed,
            .help = "simulated seconds per second of film (default: 10; 1 for a catch)"},
           {.name = "--fps", .target = &options->fps, .help = "frames per second of film (default: 30)"},
           {.name = "--lines",
            .target = &options->lines,
            .help = "draw trails, and a line from each robot to the one that it perceives (default: on)",
            .words = {"on", "off"}},
           {.name = "--legend",
            .target = &options->legend,
            .help = "draw the title, the meaning of marks, species counts and a scale, in pictures at least 560 pixels wide "
                    "(default: on)",
            .words = {"on", "off"}},
           {.name = "--title", .target = &options->title, .help = "title (default: the run's name, rules, backend and seed)"},
           {.name = "--fine",
            .target = &options->fine,
            .help = "smooth the edges of films as in pictures, which takes four times as long"}},
      .work = [options] { return detail::film::run(*options); },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
