// SPDX-License-Identifier: MIT
// `trophic convert`: a robot file from a body of another program.
#include <algorithm>
#include <memory>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/trophic/convert/foreign_body.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/support/new_file.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/whole_file.hpp>

#include "commands.hpp"

namespace trophic::command {

namespace detail::convert_body {

struct Options {
  std::string body;
  std::string out;
  std::string name;
};

/// Larger than any body; also the bound of a robot file's text.
inline constexpr std::uint64_t most_bytes = std::uint64_t{1} << 20U;

[[nodiscard]] int run(Options options) {
  if (options.out.empty()) options.out = free_name(options.body, ".toml");
  const std::filesystem::path out = options.out;
  if (out.extension() != ".toml") throw std::invalid_argument{"--out " + options.out + ": must end in .toml"};
  check_new_file("--out", out);
  const std::string name = options.name.empty() ? out.stem().string() : options.name;
  if (!is_plain(name) || !convert::is_utf8(name)) {
    throw std::invalid_argument{"--name: must be UTF-8 text without control characters"};
  }
  const convert::ForeignBody body = convert::read_foreign_body(read_whole_file(options.body, most_bytes), options.body);
  body::Design design;
  design.name = name;
  design.modules = body.modules;
  const RobotModel robot = body::build(design);
  write_new_file(out, convert::robot_file(body, name));
  const auto bricks = std::ranges::count(body.modules.modules(), body::ModuleType::brick, &body::Module::type);
  std::cout << shown(options.out) << ": " << robot.hinges.size() << (robot.hinges.size() == 1 ? " hinge, " : " hinges, ")
            << bricks << (bricks == 1 ? " brick" : " bricks") << ", from " << body.format
            << "; its brain, sizes and masses were not converted\n";
  for (const std::string& remark : body.remarks) std::cout << remark << '\n';
  flush_output();
  return 0;
}

}  // namespace detail::convert_body

/// Converts a body.
Command convert_body() {
  const auto options = std::make_shared<detail::convert_body::Options>();
  return {.name = "convert",
          .about =
              "Converts another program's body of cores, active hinges and bricks to a robot file. It reads RoboGen's text or "
              "JSON, Revolve's YAML, or a tree of revolve2's modules as JSON or YAML.",
          .options = {{.name = "body", .target = &options->body, .help = "file of the body", .required = true},
                      {.name = "--out",
                       .target = &options->out,
                       .help = "new robot file (default: BODY.toml, or the next free BODY-2.toml, ...)"},
                      {.name = "--name", .target = &options->name, .help = "name of the robot (default: the file's name)"}},
          .work = [options] { return detail::convert_body::run(*options); },
          .examples = {"trophic convert starfish.txt --out starfish.toml"}};
}

}  // namespace trophic::command
