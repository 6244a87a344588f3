// SPDX-License-Identifier: MIT
// Writes robots and arena as MJCF, MuJoCo's model format.
#pragma once

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/mujoco/box_test.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <trophic/support/units.hpp>

namespace trophic::backend::mujoco {

/// The pairs of geoms that are tested for contacts.
enum class Collisions {
  pairs,      ///< an explicit list of every pair that can touch: cheapest for one robot
  broadphase  ///< MuJoCo's own sweep over bodies: cheapest for many
};

/// The actuators of a hinge's servo. The motion is the same; MuJoCo stores actuators x velocities numbers, so that many
/// actuators cost most in a large model.
enum class Servos {
  combined,              ///< one general actuator with an affine bias
  position_and_velocity  ///< the usual form: `<position>` takes the target, `<velocity>` brakes
};

/// The content of an MJCF model besides the robots.
struct Scene {
  bool walls = true;      ///< the four walls of an arena without height field
  bool obstacles = true;  ///< the obstacles of the arena
  Collisions collisions = Collisions::broadphase;
  Servos servos = Servos::position_and_velocity;
  BoxDepth box_depth = BoxDepth::engine;
};

/// Names of robot `robot`'s parts in the model: "robot3", "robot3.link1", "robot3.link1.box0", "robot3.hinge0". Indices are those
/// of RobotModel.
[[nodiscard]] inline std::string body_name(std::size_t robot, std::size_t link) {
  const std::string name = "robot" + std::to_string(robot);
  return link == 0 ? name : name + ".link" + std::to_string(link);
}
[[nodiscard]] inline std::string box_name(std::size_t robot, std::size_t link, std::size_t box) {
  return body_name(robot, link) + ".box" + std::to_string(box);
}
[[nodiscard]] inline std::string hinge_name(std::size_t robot, std::size_t hinge) {
  return body_name(robot, 0) + ".hinge" + std::to_string(hinge);
}

/// Numbers as MJCF lists them: separated by spaces, each reading back exactly.
[[nodiscard]] inline std::string numbers_text(std::span<const double> values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ' ';
    text += number_text(value);
  }
  return text;
}

/// A height field as MuJoCo's binary file: rows and columns as 32-bit integers, then the heights as 32-bit floats, row (y) by
/// row.
[[nodiscard]] inline std::string height_file_content(const HeightField& field) {
  const std::array<std::int32_t, 2> size{static_cast<std::int32_t>(field.nodes), static_cast<std::int32_t>(field.nodes)};
  const std::vector<float> heights(field.height_m.begin(), field.height_m.end());
  std::string bytes(sizeof size + heights.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), size.data(), sizeof size);
  std::memcpy(bytes.data() + sizeof size, heights.data(), heights.size() * sizeof(float));
  return bytes;
}

/// Builds one MJCF document; `write_mjcf` is its public interface.
class MjcfWriter {
 public:
  MjcfWriter(std::span<const RobotModel* const> models, const Arena& arena, const Physics& physics, const Scene& scene)
      : models_{models}, arena_{arena}, scene_{scene} {
    root_ = document_.append_child("mujoco");
    root_.append_attribute("model").set_value(models.front()->name.c_str());
    auto compiler = root_.append_child("compiler");
    set(compiler, "angle", "radian");
    set(compiler, "inertiafromgeom", "false");
    write_option(physics);
    if (scene.box_depth == BoxDepth::whole || replaces_box_test) ask_whole_box_depth(root_);
  }

  pugi::xml_document write(std::span<const Pose> poses, const std::string& height_file) {
    if (arena_.height_field) write_height_asset(*arena_.height_field, height_file);
    auto world = root_.append_child("worldbody");
    write_ground(world);
    for (std::size_t robot = 0; robot < models_.size(); ++robot) write_robot(world, robot, poses[robot]);
    write_servos();
    if (scene_.collisions == Collisions::pairs) write_pairs();
    return std::move(document_);
  }

 private:
  static void set(pugi::xml_node node, const char* name, std::string_view text) {
    node.append_attribute(name).set_value(std::string{text}.c_str());
  }
  static void set(pugi::xml_node node, const char* name, double value) { set(node, name, number_text(value)); }
  static void set(pugi::xml_node node, const char* name, std::initializer_list<double> values) {
    set(node, name, numbers_text({values.begin(), values.size()}));
  }
  static void set(pugi::xml_node node, const char* name, const Eigen::Vector3d& v) { set(node, name, {v.x(), v.y(), v.z()}); }
  static void set(pugi::xml_node node, const char* name, const Eigen::Quaterniond& q) {
    set(node, name, {q.w(), q.x(), q.y(), q.z()});
  }

  /// Newton on the pyramidal cone ends exactly. A tolerance at rounding level makes the result independent of the number of
  /// robots in the model, whose size scales MuJoCo's default tolerance.
  void write_option(const Physics& physics) {
    auto option = root_.append_child("option");
    set(option, "timestep", physics.timestep_s);
    set(option, "gravity", {0.0, 0.0, -physics.gravity_m_s2});
    set(option, "integrator", physics.integrator == Integrator::rk4 ? "RK4" : "Euler");
    set(option, "solver", "Newton");
    set(option, "cone", "pyramidal");
    set(option, "tolerance", 1e-15);
    set(option, "iterations", 100.0);
    if (!solves_sparse) set(option, "jacobian", "dense");
    if (turned_off != 0) {
      auto flag = option.append_child("flag");
      set(flag, "nativeccd", "disable");
      set(flag, "multiccd", "disable");
    }
    if (has_collision_option && scene_.collisions == Collisions::pairs) set(option, "collision", "predefined");
  }

  /// Without contact types a geom is only in the listed pairs.
  void leave_to_pairs(pugi::xml_node geom) const {
    if (has_collision_option || scene_.collisions != Collisions::pairs) return;
    set(geom, "contype", 0.0);
    set(geom, "conaffinity", 0.0);
  }

  void write_height_asset(const HeightField& field, const std::string& file) {
    const auto [low, high] = std::ranges::minmax(field.height_m);
    auto asset = root_.append_child("asset").append_child("hfield");
    set(asset, "name", "ground");
    set(asset, "file", file);
    const double rise_m = high > low ? high - low : 1.0;
    set(asset, "size", {field.half_extent_m, field.half_extent_m, rise_m, 1.0});
  }

  pugi::xml_node ground_geom(pugi::xml_node world, const char* name, const char* type) {
    auto geom = world.append_child("geom");
    set(geom, "name", name);
    set(geom, "type", type);
    set(geom, "friction", {arena_.friction, 0.005, 0.0001});
    leave_to_pairs(geom);
    ground_.emplace_back(name);
    return geom;
  }

  /// A pillar is a cylinder, a wall a box with a cylinder at each end.
  void write_obstacle(pugi::xml_node world, std::size_t number, const Obstacle& one) {
    const std::string name = "obstacle" + std::to_string(number);
    const double half_m = 0.5 * one.height_m;
    const auto end = [&](const std::string& own, double x_m, double y_m) {
      auto geom = ground_geom(world, own.c_str(), "cylinder");
      set(geom, "size", {one.radius_m, half_m});
      set(geom, "pos", {x_m, y_m, half_m});
    };
    end(name, one.x_m, one.y_m);
    if (one.is_pillar()) return;
    end(name + ".end", one.to_x_m, one.to_y_m);
    auto geom = ground_geom(world, (name + ".side").c_str(), "box");
    set(geom, "size", {0.5 * one.length_m(), one.radius_m, half_m});
    set(geom, "pos", {one.middle_x_m(), one.middle_y_m(), half_m});
    set(geom, "euler", {0.0, 0.0, one.turn_rad()});
  }

  void write_ground(pugi::xml_node world) {
    for (std::size_t i = 0; scene_.obstacles && i < arena_.obstacles.size(); ++i) write_obstacle(world, i, arena_.obstacles[i]);
    if (arena_.height_field) {
      auto geom = ground_geom(world, "ground", "hfield");
      set(geom, "hfield", "ground");
      set(geom, "pos", {0.0, 0.0, std::ranges::min(arena_.height_field->height_m)});
      return;
    }
    const double side_m = arena_.half_side_m;
    set(ground_geom(world, "floor", "plane"), "size", {side_m, side_m, 1.0});
    if (!scene_.walls) return;
    struct Wall {
      const char* name;
      double x, y;
    };
    for (const Wall& wall : {Wall{"wall_east", 1, 0}, {"wall_west", -1, 0}, {"wall_north", 0, 1}, {"wall_south", 0, -1}}) {
      auto geom = ground_geom(world, wall.name, "plane");
      set(geom, "size", {wall.x != 0.0 ? 0.5 : side_m, wall.x != 0.0 ? side_m : 0.5, 1.0});
      set(geom, "pos", {wall.x * side_m, wall.y * side_m, 0.5});
      set(geom, "zaxis", {-wall.x, -wall.y, 0.0});
      set(geom, "rgba", {0.5, 0.5, 0.5, 0.3});
    }
  }

  void write_robot(pugi::xml_node world, std::size_t robot, const Pose& pose) {
    const RobotModel& model = *models_[robot];
    std::vector<pugi::xml_node> bodies(model.links.size());
    for (std::size_t link = 0; link < model.links.size(); ++link) {
      const Link& part = model.links[link];
      auto parent = link == 0 ? world : bodies[static_cast<std::size_t>(part.parent)];
      auto body = bodies[link] = parent.append_child("body");
      set(body, "name", body_name(robot, link));
      set(body, "pos", link == 0 ? pose.position_m : part.offset_m);
      set(body, "quat", link == 0 ? pose.orientation : part.rotation);
      write_joint(body, robot, link);
      write_inertia(body, part);
      for (std::size_t box = 0; box < part.boxes.size(); ++box) write_box(body, robot, link, box);
    }
  }

  void write_joint(pugi::xml_node body, std::size_t robot, std::size_t link) {
    if (link == 0) {
      set(body.append_child("freejoint"), "name", body_name(robot, 0) + ".root");
      return;
    }
    const Hinge& hinge = models_[robot]->hinges[link - 1];
    auto joint = body.append_child("joint");
    set(joint, "name", hinge_name(robot, link - 1));
    set(joint, "type", "hinge");
    set(joint, "axis", hinge.axis);
    set(joint, "limited", "true");
    set(joint, "range", {-hinge.range_rad, hinge.range_rad});
  }

  static void write_inertia(pugi::xml_node body, const Link& link) {
    auto inertial = body.append_child("inertial");
    set(inertial, "pos", link.centre_of_mass_m);
    set(inertial, "mass", link.mass_kg);
    const Eigen::Matrix3d& i = link.inertia_kgm2;
    set(inertial, "fullinertia", {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)});
  }

  void write_box(pugi::xml_node body, std::size_t robot, std::size_t link, std::size_t box) {
    const Box& shape = models_[robot]->links[link].boxes[box];
    auto geom = body.append_child("geom");
    set(geom, "name", box_name(robot, link, box));
    set(geom, "type", "box");
    set(geom, "size", shape.half_extents_m);
    set(geom, "pos", shape.centre_m);
    set(geom, "quat", shape.orientation);
    set(geom, "friction", {models_[robot]->friction, 0.005, 0.0001});
    leave_to_pairs(geom);
  }

  /// Torque = position_gain (target - angle) - velocity_gain * velocity. A robot's first controls are its targets, hinge by
  /// hinge.
  void write_servos() {
    auto actuators = root_.append_child("actuator");
    for (std::size_t robot = 0; robot < models_.size(); ++robot) {
      const std::vector<Hinge>& hinges = models_[robot]->hinges;
      for (std::size_t hinge = 0; hinge < hinges.size(); ++hinge) {
        const Servo& servo = hinges[hinge].servo;
        const bool combined = scene_.servos == Servos::combined;
        auto actuator = actuator_of(actuators, combined ? "general" : "position", robot, hinge);
        set(actuator, "ctrllimited", "true");
        set(actuator, "ctrlrange", {-servo.target_limit_rad, servo.target_limit_rad});
        if (combined) {
          set(actuator, "gainprm", servo.position_gain);
          set(actuator, "biastype", "affine");
          set(actuator, "biasprm", {0.0, -servo.position_gain, -servo.velocity_gain});
        } else {
          set(actuator, "kp", servo.position_gain);
        }
      }
      for (std::size_t hinge = 0; hinge < hinges.size() && scene_.servos == Servos::position_and_velocity; ++hinge) {
        set(actuator_of(actuators, "velocity", robot, hinge), "kv", hinges[hinge].servo.velocity_gain);
      }
    }
  }

  static pugi::xml_node actuator_of(pugi::xml_node actuators, const char* kind, std::size_t robot, std::size_t hinge) {
    auto actuator = actuators.append_child(kind);
    set(actuator, "name", hinge_name(robot, hinge) + "." + kind);
    set(actuator, "joint", hinge_name(robot, hinge));
    return actuator;
  }

  void write_pairs() {
    auto contact = root_.append_child("contact");
    // A pair does not inherit the friction of its geoms.
    const auto add = [&](const std::string& a, const std::string& b, double friction) {
      auto pair = contact.append_child("pair");
      set(pair, "geom1", a);
      set(pair, "geom2", b);
      set(pair, "friction", {friction, friction, 0.005, 0.0001, 0.0001});
    };
    const auto add_links = [&](std::size_t robot_a, std::size_t a, std::size_t robot_b, std::size_t b) {
      const double friction = std::max(models_[robot_a]->friction, models_[robot_b]->friction);
      for (std::size_t i = 0; i < models_[robot_a]->links[a].boxes.size(); ++i) {
        for (std::size_t j = 0; j < models_[robot_b]->links[b].boxes.size(); ++j) {
          add(box_name(robot_a, a, i), box_name(robot_b, b, j), friction);
        }
      }
    };
    for (std::size_t robot = 0; robot < models_.size(); ++robot) {
      const std::vector<Link>& links = models_[robot]->links;
      const double ground_friction = std::max(models_[robot]->friction, arena_.friction);
      for (std::size_t a = 0; a < links.size(); ++a) {
        for (std::size_t i = 0; i < links[a].boxes.size(); ++i) {
          for (const std::string& ground : ground_) add(ground, box_name(robot, a, i), ground_friction);
        }
        for (std::size_t b = a + 1; b < links.size(); ++b) {
          const bool adjacent = links[b].parent == static_cast<int>(a);
          if (!adjacent) add_links(robot, a, robot, b);
        }
        for (std::size_t other = robot + 1; other < models_.size(); ++other) {
          for (std::size_t b = 0; b < models_[other]->links.size(); ++b) add_links(robot, a, other, b);
        }
      }
    }
  }

  std::span<const RobotModel* const> models_;  ///< one per robot
  const Arena& arena_;
  Scene scene_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::vector<std::string> ground_;
};

/// One model with robots of these bodies at these poses in the arena: inertias as in the RobotModel, a position servo per hinge,
/// walls as planes. `height_file` is the name under which MuJoCo will find `height_file_content` (unused without height field).
[[nodiscard]] inline pugi::xml_document write_mjcf(std::span<const RobotModel* const> models, const Arena& arena,
                                                   const Physics& physics, const Scene& scene, std::span<const Pose> poses,
                                                   const std::string& height_file) {
  return MjcfWriter{models, arena, physics, scene}.write(poses, height_file);
}

}  // namespace trophic::backend::mujoco
