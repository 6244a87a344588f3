// SPDX-License-Identifier: MIT
// Bodies of other programs that are made of the same modules: cores, active hinges and bricks.
#pragma once

#include <string>
#include <string_view>
#include <trophic/habitat/body/module.hpp>
#include <vector>

namespace trophic::convert {

/// A body as trophic's modules.
struct ForeignBody {
  std::string format;                ///< as errors name it
  body::ModuleTree modules;          ///< the front of the core is that of the other program
  std::vector<std::string> names;    ///< of the modules in their file; may be empty
  std::vector<std::string> remarks;  ///< of what is not as in the file, a line each
};

[[nodiscard]] bool is_utf8(const std::string& text);

/// Reads a body of RoboGen (text, or parts and connections as JSON), Revolve or revolve2 (a tree of modules as JSON or YAML), as
/// its simulator builds it:
/// - RoboGen: slots 0 to 3 of the core are left, right, front and back as seen from its front; of a brick 0 is ahead, 1 right, 2
///   left. A quarter turn is about the axis that points to the parent. Bricks lie flat, whatever their turn.
/// - Revolve: slots 0 to 3 are back, front, right and left, as the geometry of its SDF has them; `orientation` in degrees; `slot`
/// is
///   the part's own slot that touches its parent.
/// - revolve2: faces by name, or by number as its classes have them; `rotation` in radians.
/// Brains and unknown keys are not read. Parts of another type that carry no module are left out, if a hinge remains. Throws
/// std::invalid_argument "FILE:LINE: PART: ..." for another format, another part that carries modules, and a body that cannot be
/// built.
[[nodiscard]] ForeignBody read_foreign_body(std::string_view text, const std::string& file);

/// The robot file of a body; it has the standard parts of models/README.md.
[[nodiscard]] std::string robot_file(const ForeignBody& body, const std::string& name);

}  // namespace trophic::convert
