// SPDX-License-Identifier: MIT
// Definitions of renderer.hpp.
#include <GL/osmesa.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/film/renderer.hpp>
#include <utility>

namespace trophic::film {

namespace {

/// An OpenGL context without a screen, current in the thread that made it.
class Offscreen {
 public:
  Offscreen() : context_{OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr)}, buffer_(4 * side * side) {
    if (context_ == nullptr || OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, side, side) == 0) {
      throw std::runtime_error{"OSMesa gives no OpenGL to draw with"};
    }
  }
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;
  ~Offscreen() { OSMesaDestroyContext(context_); }

 private:
  static constexpr int side = 16;  // pictures are drawn into a buffer of MuJoCo's own
  OSMesaContext context_;
  std::vector<std::uint8_t> buffer_;
};

using backend::mujoco::DataPtr;
using backend::mujoco::ModelPtr;

constexpr double fovy_deg = 38.0;
constexpr double flat_m = 5e-4;  ///< half as high as what lies on the floor

/// A world of nothing: what is drawn is put into the scene by hand.
ModelPtr empty_model(std::size_t width, std::size_t height, double extent_m) {
  const auto text = [](double value) { return std::to_string(value); };
  const std::string xml =
      "<mujoco><statistic center='0 0 0' extent='" + text(extent_m) + "'/><visual><global fovy='" + text(fovy_deg) +
      "' offwidth='" + std::to_string(width) + "' offheight='" + std::to_string(height) +
      "'/><quality offsamples='0' numslices='72'/><map znear='0.03' zfar='12' shadowclip='1.2' "
      "shadowscale='0.9'/>"
      "<headlight ambient='0.5 0.5 0.5' diffuse='0.14 0.14 0.14' specular='0 0 0'/></visual><worldbody>"
      "<light directional='true' pos='" +
      text(0.3 * extent_m) + " " + text(-0.5 * extent_m) + " " + text(extent_m) +
      "' dir='-0.28 0.5 -1' diffuse='0.42 0.42 0.42' specular='0 0 0' castshadow='false'/></worldbody></mujoco>";
  auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "empty.xml", static_cast<int>(xml.size()));
  std::ranges::copy(xml, static_cast<char*>(files->filedata[mj_findFileVFS(files.get(), "empty.xml")]));
  std::array<char, 1000> error{};
  ModelPtr model{mj_loadXML("empty.xml", files.get(), error.data(), static_cast<int>(error.size()))};
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error{std::string{"MuJoCo refuses an empty world: "} + error.data()};
  return model;
}

constexpr Colour floor_colour{0.965F, 0.97F, 0.975F};
constexpr Colour grid_colour{0.86F, 0.88F, 0.9F};
constexpr Colour wall_colour{0.72F, 0.76F, 0.8F};
constexpr Colour ink{0.07F, 0.09F, 0.12F};

Colour mixed(const Colour& a, const Colour& b, float part) {
  Colour colour;
  for (std::size_t i = 0; i < 3; ++i) colour[i] = a[i] + part * (b[i] - a[i]);
  return colour;
}

}  // namespace

class Renderer::Drawing {
 public:
  Drawing(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality)
      : robot_{robot},
        arena_{arena},
        scale_{quality == Quality::fine ? 2U : 1U},
        width_{checked("width", width)},
        height_{checked("height", height)},
        model_{empty_model(scale_ * width_, scale_ * height_, arena.half_side_m)},
        data_{mj_makeData(model_.get())},
        ring_m_{std::max(1.15 * robot.bounding_radius_m, 0.021 * arena.half_side_m)} {
    mjv_defaultScene(&scene_);
    mjr_defaultContext(&context_);
    mjv_makeScene(model_.get(), &scene_, most_geoms);
    mjr_makeContext(model_.get(), &context_, scale_ == 2 ? mjFONTSCALE_200 : mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
    if (context_.currentBuffer != mjFB_OFFSCREEN) {
      mjr_freeContext(&context_);
      mjv_freeScene(&scene_);
      throw std::runtime_error{"OpenGL has no buffer to draw into without a screen"};
    }
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing() {
    mjr_freeContext(&context_);
    mjv_freeScene(&scene_);
  }

  Image draw(const Picture& picture, const Camera& camera) {
    mjvCamera eye;
    mjv_defaultCamera(&eye);
    for (int i = 0; i < 3; ++i) eye.lookat[i] = camera.at_m[i];
    eye.distance = camera.distance_m;
    eye.azimuth = camera.azimuth_deg;
    eye.elevation = camera.elevation_deg;
    pixel_m_ = camera.distance_m * 2.0 * std::tan(0.5 * fovy_deg * std::numbers::pi / 180.0) / static_cast<double>(height_);
    mjvOption option;
    mjv_defaultOption(&option);
    mj_forward(model_.get(), data_.get());
    mjv_updateScene(model_.get(), data_.get(), &option, nullptr, &eye, mjCAT_ALL, &scene_);
    scene_.flags[mjRND_SHADOW] = 0;  // they darken the discs that tell tags, and take half of the time of a picture
    scene_.flags[mjRND_SKYBOX] = 0;
    scene_.flags[mjRND_REFLECTION] = 0;
    scene_.flags[mjRND_HAZE] = 0;
    add_arena();
    for (const FloorLine& line : picture.lines) add_line(line);
    for (const RobotLook& look : picture.robots) add_ring(look);
    for (const Flash& flash : picture.flashes) add_flash(flash);
    for (const RobotLook& look : picture.robots) add_body(look);
    return render(picture.caption);
  }

  [[nodiscard]] const Arena& arena() const { return arena_; }
  [[nodiscard]] const RobotModel& robot() const { return robot_; }
  [[nodiscard]] double aspect() const { return static_cast<double>(width_) / static_cast<double>(height_); }

 private:
  static constexpr int most_geoms = 60000;

  static std::size_t checked(const char* name, std::size_t size) {
    if (size % 2 == 0 && size >= 16 && size <= 4096) return size;
    throw std::invalid_argument{std::string{name} + " = " + std::to_string(size) + ": must be even, >= 16 and <= 4096"};
  }

  mjvGeom* add(int type, const Eigen::Vector3d& size, const Eigen::Vector3d& at, const Eigen::Matrix3d& turn,
               const Colour& colour, float opacity) {
    if (scene_.ngeom >= scene_.maxgeom)
      throw std::runtime_error{"too much in one picture: " + std::to_string(most_geoms) + " shapes"};
    mjvGeom* geom = scene_.geoms + scene_.ngeom++;
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = turn;
    const std::array<float, 4> rgba{colour[0], colour[1], colour[2], opacity};
    mjv_initGeom(geom, type, size.data(), at.data(), rows.data(), rgba.data());
    geom->category = mjCAT_DECOR;
    return geom;
  }

  /// Flat on the floor, `level` above what is lower.
  void add_disc(double x, double y, double radius, int level, const Colour& colour) {
    const Eigen::Vector3d at{x, y, 2e-3 + 1.5e-3 * level};
    add(mjGEOM_CYLINDER, {radius, flat_m, 0.0}, at, Eigen::Matrix3d::Identity(), colour, 1.0F);  // MuJoCo: radius, half height
  }

  /// A line of so many pixels, as a thin box: MuJoCo lights its own lines otherwise than surfaces.
  void add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double pixels, const Colour& colour) {
    const Eigen::Vector3d way = to - from;
    const double length = way.norm();
    if (length < 1e-6) return;
    const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), way).toRotationMatrix();
    add(mjGEOM_BOX, {0.5 * length, 0.5 * pixels * pixel_m_, flat_m}, 0.5 * (from + to), turn, colour, 1.0F);
  }

  void add_arena() {
    const double half = arena_.half_side_m;
    add(mjGEOM_BOX, {half, half, 0.01}, {0, 0, -0.0105}, Eigen::Matrix3d::Identity(), floor_colour, 1.0F);
    const double step = half > 40 ? 10 : half > 15 ? 2 : 1;
    for (double at = -std::floor(half / step) * step; at <= half + 1e-9; at += step) {
      add_segment({at, -half, 1e-3}, {at, half, 1e-3}, 1.3, grid_colour);
      add_segment({-half, at, 1e-3}, {half, at, 1e-3}, 1.3, grid_colour);
    }
    if (arena_.height_field) return add_slopes(*arena_.height_field);
    const double thick = 0.006 * half;
    const double height = 0.0175 * half;
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const double long_m = half + 2 * thick;
      add(mjGEOM_BOX, {x != 0 ? thick : long_m, y != 0 ? thick : long_m, height},
          {x * (half + thick), y * (half + thick), height}, Eigen::Matrix3d::Identity(), wall_colour, 1.0F);
    }
  }

  /// A net of lines; the slopes of an arena rise too high for a picture and are drawn flatter, as in the browser.
  void add_slopes(const HeightField& field) {
    const double highest = std::ranges::max(field.height_m);
    const double scale = highest > 1.5 ? 1.5 / highest : 1.0;
    const auto node = [&](std::size_t ix, std::size_t iy) {
      const double cell = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
      return Eigen::Vector3d{static_cast<double>(ix) * cell - field.half_extent_m,
                             static_cast<double>(iy) * cell - field.half_extent_m, scale * field.height_m[iy * field.nodes + ix]};
    };
    for (std::size_t i = 0; i < field.nodes; ++i) {
      for (std::size_t j = 0; j + 1 < field.nodes; ++j) {
        add_segment(node(i, j), node(i, j + 1), 1.6, wall_colour);
        add_segment(node(j, i), node(j + 1, i), 1.6, wall_colour);
      }
    }
  }

  void add_line(const FloorLine& line) {
    add_segment({line.x0_m, line.y0_m, 2e-3}, {line.x1_m, line.y1_m, 2e-3}, 1.6, mixed(floor_colour, line.colour, line.opacity));
  }

  void add_ring(const RobotLook& look) {
    const double x = look.root.position_m.x();
    const double y = look.root.position_m.y();
    if (look.is_marked) {
      add_disc(x, y, 1.78 * ring_m_, 0, ink);
      add_disc(x, y, 1.66 * ring_m_, 1, floor_colour);
    }
    const Eigen::Quaterniond& q = look.root.orientation;
    const double yaw = std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
    const double heading = yaw + robot_.forward_rad;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd{heading + std::numbers::pi / 4, Eigen::Vector3d::UnitZ()}.toRotationMatrix();
    const double tip = 0.3 * ring_m_;
    const Eigen::Vector3d at{x + 1.08 * ring_m_ * std::cos(heading), y + 1.08 * ring_m_ * std::sin(heading), 4e-3};
    add(mjGEOM_BOX, {tip, tip, 1e-3}, at, turn, look.colour, 1.0F);
    add_disc(x, y, ring_m_, 2, look.colour);
    add_disc(x, y, 0.86 * ring_m_, 3, look.filled ? mixed(floor_colour, look.colour, 0.45F) : floor_colour);
  }

  void add_flash(const Flash& flash) {
    constexpr int sides = 48;
    for (int i = 0; i < sides; ++i) {
      const auto corner = [&](int k) {
        const double angle = 2.0 * std::numbers::pi * k / sides;
        return Eigen::Vector3d{flash.x_m + flash.radius_m * std::cos(angle), flash.y_m + flash.radius_m * std::sin(angle), 9e-3};
      };
      add_segment(corner(i), corner(i + 1), 1.8, ink);
    }
  }

  void add_body(const RobotLook& look) {
    std::vector<Eigen::Isometry3d> frames(robot_.links.size());
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      const Link& link = robot_.links[i];
      if (i == 0) {
        frames[i] = Eigen::Translation3d{look.root.position_m} * look.root.orientation;
      } else {
        frames[i] = frames[static_cast<std::size_t>(link.parent)] * Eigen::Translation3d{link.offset_m} * link.rotation;
        if (!look.joint_angles_rad.empty()) {
          frames[i] = frames[i] * Eigen::AngleAxisd{look.joint_angles_rad[i - 1], robot_.hinges[i - 1].axis};
        }
      }
      const Colour colour = i == 0 ? look.colour : mixed(look.colour, ink, 0.42F);
      for (const Box& box : link.boxes) {
        const Eigen::Isometry3d frame = frames[i] * Eigen::Translation3d{box.centre_m} * box.orientation;
        add(mjGEOM_BOX, box.half_extents_m, frame.translation(), frame.linear(), colour, 1.0F)->category = mjCAT_DYNAMIC;
      }
    }
  }

  Image render(const std::string& caption) {
    const auto width = static_cast<int>(scale_ * width_);
    const auto height = static_cast<int>(scale_ * height_);
    const mjrRect view{0, 0, width, height};
    mjr_render(view, &scene_, &context_);
    if (!caption.empty()) mjr_text(mjFONT_NORMAL, caption.c_str(), &context_, 0.012F, 0.018F, ink[0], ink[1], ink[2]);
    Image upside_down = Image::blank(scale_ * width_, scale_ * height_, 0);
    mjr_readPixels(upside_down.rgb.data(), nullptr, view, &context_);
    Image image = upside_down;
    const std::size_t row = 3 * image.width;
    for (std::size_t y = 0; y < image.height; ++y) {
      std::copy_n(upside_down.rgb.begin() + static_cast<std::ptrdiff_t>((image.height - 1 - y) * row), row,
                  image.rgb.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    // Where nothing is, MuJoCo draws black.
    for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
      if (image.rgb[at] == 0 && image.rgb[at + 1] == 0 && image.rgb[at + 2] == 0) {
        std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(at), 3, std::uint8_t{255});
      }
    }
    return scale_ == 2 ? halved(image) : image;
  }

  RobotModel robot_;
  Arena arena_;
  std::size_t scale_;
  std::size_t width_;
  std::size_t height_;
  Offscreen offscreen_;
  ModelPtr model_;
  DataPtr data_;
  mjvScene scene_{};
  mjrContext context_{};
  double ring_m_;
  double pixel_m_ = 0.01;  ///< about how large a pixel is at what the camera looks at
};

Renderer::Renderer(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality)
    : drawing_{std::make_unique<Drawing>(robot, arena, width, height, quality)} {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Image Renderer::draw(const Picture& picture, const Camera& camera) {
  return drawing_->draw(picture, camera);
}

Camera Renderer::whole_arena() const {
  const double fit = std::max(1.0, 1.25 / drawing_->aspect());
  return {.at_m = {0, -0.09 * drawing_->arena().half_side_m, 0},
          .distance_m = 2.72 * fit * drawing_->arena().half_side_m,
          .azimuth_deg = 90.0,
          .elevation_deg = -50.0};
}

Camera Renderer::from_above() const {
  const double fit = std::max(1.0, 1.05 / drawing_->aspect());
  return {.at_m = Eigen::Vector3d::Zero(),
          .distance_m = 3.1 * fit * drawing_->arena().half_side_m,
          .azimuth_deg = 90.0,
          .elevation_deg = -90.0};
}

Camera Renderer::near(const Eigen::Vector3d& at_m) const {
  return {.at_m = {at_m.x(), at_m.y(), 0.0},
          .distance_m = 13.0 * drawing_->robot().bounding_radius_m,
          .azimuth_deg = 90.0,
          .elevation_deg = -33.0};
}

}  // namespace trophic::film
