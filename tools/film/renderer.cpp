// SPDX-License-Identifier: MIT
// Definitions of renderer.hpp: MuJoCo draws into a buffer of its own.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <tools/film/offscreen.hpp>
#include <tools/film/overlay.hpp>
#include <tools/film/renderer.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <trophic/habitat/link_frames.hpp>

namespace trophic::film {

namespace {

using backend::mujoco::DataPtr;
using backend::mujoco::ModelPtr;

constexpr double flat_m = 5e-4;  ///< half the height of marks on the floor

/// A world with the slopes of an arena, if it has any: the scene's other objects are added by hand. `samples`: of each pixel.
ModelPtr empty_model(std::size_t width, std::size_t height, const Arena& arena, int samples) {
  const double extent_m = arena.half_side_m;
  const auto text = [](double value) { return std::to_string(value); };
  const double highest_m = edge_of(arena).height_m;
  const bool has_slopes = arena.height_field && highest_m > 0.0;
  std::string asset;
  std::string geom;
  if (has_slopes) {
    const std::string nodes = std::to_string(arena.height_field->nodes);
    const std::string half = text(arena.height_field->half_extent_m) + " ";
    asset =
        "<hfield name='slopes' nrow='" + nodes + "' ncol='" + nodes + "' size='" + half + half + text(highest_m) + " 0.001'/>";
    geom = "<geom type='hfield' hfield='slopes' pos='0 0 -0.08' rgba='0.74 0.77 0.81 1'/>";
  }
  const std::string xml =
      "<mujoco><statistic center='0 0 0' extent='" + text(extent_m) + "'/><visual><global fovy='" + text(fovy_deg) +
      "' offwidth='" + std::to_string(width) + "' offheight='" + std::to_string(height) + "'/><quality offsamples='" +
      std::to_string(samples) +
      "' numslices='72'/><map znear='0.03' zfar='12' shadowclip='1.2' "
      "shadowscale='0.9'/>"
      "<headlight ambient='0.5 0.5 0.5' diffuse='0.14 0.14 0.14' specular='0 0 0'/></visual><asset><texture type='skybox' "
      "builtin='flat' rgb1='1 1 1' rgb2='1 1 1' width='4' height='24'/>" +
      asset + "</asset><worldbody>" + geom + "<light directional='true' pos='" + text(0.3 * extent_m) + " " +
      text(-0.5 * extent_m) + " " + text(extent_m) +
      "' dir='-0.28 0.5 -1' diffuse='0.42 0.42 0.42' specular='0 0 0' castshadow='false'/></worldbody></mujoco>";
  auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  backend::mujoco::add_file(*files, "empty.xml", xml);
  std::array<char, 1000> error{};
  ModelPtr model{mj_loadXML("empty.xml", files.get(), error.data(), static_cast<int>(error.size()))};
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error{std::string{"MuJoCo rejects an empty world: "} + error.data()};
  if (has_slopes) {
    const double tallest_m = std::ranges::max(arena.height_field->height_m);
    std::ranges::transform(arena.height_field->height_m, model->hfield_data,
                           [&](double height_m) { return static_cast<float>(height_m / tallest_m); });
  }
  return model;
}

constexpr Colour floor_colour{0.885F, 0.905F, 0.925F};
constexpr Colour grid_colour{0.8F, 0.83F, 0.86F};
constexpr Colour wall_colour{0.66F, 0.7F, 0.75F};
constexpr float shadow_opacity = 0.085F;  ///< of each of three layers, the widest and the narrowest of which make a soft edge
constexpr double shadow_edge = 0.2;       ///< of a box's width
/// The light as a slope: a shadow lies so many metres aside a metre of height.
constexpr double light_x = -0.28;
constexpr double light_y = 0.5;

std::size_t checked(const char* name, std::size_t size) {
  if (size % 2 == 0 && size >= 16 && size <= 4096) return size;
  throw std::invalid_argument{std::string{name} + " = " + std::to_string(size) + ": must be even, >= 16 and <= 4096"};
}

}  // namespace

class Renderer::Scene {
 public:
  Scene(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality)
      : robot_{robot},
        arena_{arena},
        scale_{quality == Quality::fine ? 2U : 1U},
        width_{scale_ * checked("width", width)},
        height_{scale_ * checked("height", height)},
        model_{empty_model(width_, height_, arena, quality == Quality::fine ? 4 : 0)},
        data_{mj_makeData(model_.get())} {
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
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    mjr_freeContext(&context_);
    mjv_freeScene(&scene_);
  }

  [[nodiscard]] Image draw(const Picture& picture, const Camera& camera) {
    const Overlay overlay{context_, view_};
    const mjrRect stage = stage_of(overlay, picture);
    mjvCamera eye;
    mjv_defaultCamera(&eye);
    for (int i = 0; i < 3; ++i) eye.lookat[i] = camera.at_m[i];
    eye.distance = camera.distance_m;
    eye.azimuth = camera.azimuth_deg;
    eye.elevation = camera.elevation_deg;
    sight_ = Sight{camera};
    a_pixel_ = 2.0 * half_height() / stage.height;
    pixel_m_ = camera.distance_m * a_pixel_;
    mjvOption option;
    mjv_defaultOption(&option);
    mj_forward(model_.get(), data_.get());
    mjv_updateScene(model_.get(), data_.get(), &option, nullptr, &eye, mjCAT_ALL, &scene_);
    scene_.flags[mjRND_SHADOW] = 0;  // MuJoCo's take half of the time of a picture: `add_shadow` draws simpler ones
    scene_.flags[mjRND_SKYBOX] = 0;  // MuJoCo draws black in empty places; a white sky would cost more than `read` does
    scene_.flags[mjRND_REFLECTION] = 0;
    scene_.flags[mjRND_HAZE] = 0;
    add_arena(sight_.eye_m, picture.food);
    for (const Circle& one : picture.circles)
      add_circle(one.x_m, one.y_m, one.radius_m, 6e-3, 1.2 * static_cast<double>(scale_), one.colour);
    for (const FloorLine& line : picture.lines) add_line(line);
    for (const RobotLook& look : picture.robots) add_ring(look);
    for (const Flash& flash : picture.flashes) add_flash(flash);
    for (const RobotLook& look : picture.robots) add_body(look);
    mjr_render(stage, &scene_, &context_);
    write_over(overlay, picture, camera, places_of(picture, camera, stage));
    return scale_ == 2 ? halved(read()) : read();
  }

  [[nodiscard]] double aspect(const Picture& picture) const {
    const mjrRect stage = stage_of(Overlay{context_, view_}, picture);
    return static_cast<double>(stage.width) / stage.height;
  }

 private:
  /// Where robots are in a picture, pixels; of no size behind the camera.
  [[nodiscard]] std::vector<Overlay::Disc> places_of(const Picture& picture, const Camera& camera, const mjrRect& stage) const {
    std::vector<Overlay::Disc> places;
    for (const RobotLook& look : picture.robots) {
      const auto point = seen_at(camera, look.root.position_m);
      if (!point) {
        places.push_back({});
        continue;
      }
      places.push_back({0.5 * (stage.width + point->x * stage.height), stage.bottom + 0.5 * (1.0 + point->y) * stage.height,
                        ring_m(look) / pixel_at(look.root.position_m)});
    }
    return places;
  }

  /// Size of a pixel at a place, as seen by the camera.
  [[nodiscard]] double pixel_at(const Eigen::Vector3d& at_m) const {
    return std::max(1e-6, (at_m - sight_.eye_m).dot(sight_.forward)) * a_pixel_;
  }
  [[nodiscard]] const RobotModel& body_of(const RobotLook& look) const { return look.body ? *look.body : robot_; }
  [[nodiscard]] double ring_m(const RobotLook& look) const {
    return ring_radius_m(body_of(look), static_cast<double>(scale_) * pixel_at(look.root.position_m));
  }

  [[nodiscard]] Image read() const {
    Image upside_down = Image::blank(static_cast<std::size_t>(view_.width), static_cast<std::size_t>(view_.height), 0);
    mjr_readPixels(upside_down.rgb.data(), nullptr, view_, &context_);
    Image image = upside_down;
    const std::size_t row = 3 * image.width;
    for (std::size_t y = 0; y < image.height; ++y) {
      std::copy_n(upside_down.rgb.begin() + static_cast<std::ptrdiff_t>((image.height - 1 - y) * row), row,
                  image.rgb.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
      if (image.rgb[at] == 0 && image.rgb[at + 1] == 0 && image.rgb[at + 2] == 0) {
        std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(at), 3, std::uint8_t{255});
      }
    }
    return image;
  }

  static constexpr int most_geoms = 120000;

  mjvGeom* add(int type, const Eigen::Vector3d& size, const Eigen::Vector3d& at, const Eigen::Matrix3d& turn,
               const Colour& colour, float opacity) {
    if (scene_.ngeom >= scene_.maxgeom)
      throw std::runtime_error{"too many objects in one picture: " + std::to_string(most_geoms) + " shapes"};
    mjvGeom* geom = scene_.geoms + scene_.ngeom++;
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = turn;
    const std::array<float, 4> rgba{colour[0], colour[1], colour[2], opacity};
    mjv_initGeom(geom, type, size.data(), at.data(), rows.data(), rgba.data());
    geom->category = mjCAT_DECOR;
    return geom;
  }

  /// Flat on the floor, `level` layers up.
  void add_disc(double x, double y, double radius, int level, const Colour& colour) {
    const Eigen::Vector3d at{x, y, 2e-3 + 1.5e-3 * level};
    add(mjGEOM_CYLINDER, {radius, flat_m, 0.0}, at, Eigen::Matrix3d::Identity(), colour, 1.0F);  // MuJoCo: radius, half height
  }

  /// A line of so many pixels, as a thin box: MuJoCo lights its own lines differently from surfaces.
  void add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double pixels, const Colour& colour) {
    const Eigen::Vector3d way = to - from;
    const double length = way.norm();
    if (length < 1e-6) return;
    const Eigen::AngleAxisd heading{std::atan2(way.y(), way.x()), Eigen::Vector3d::UnitZ()};
    const Eigen::AngleAxisd slope{-std::atan2(way.z(), std::hypot(way.x(), way.y())), Eigen::Vector3d::UnitY()};
    const Eigen::Matrix3d turn = (heading * slope).toRotationMatrix();
    add(mjGEOM_BOX, {0.5 * length, 0.5 * pixels * pixel_m_, flat_m}, 0.5 * (from + to), turn, colour, 1.0F);
  }

  void add_arena(const Eigen::Vector3d& eye_m, std::span<const FoodTile> food) {
    const double half = arena_.half_side_m;
    if (food.empty()) add(mjGEOM_BOX, {half, half, 0.01}, {0, 0, -0.0105}, Eigen::Matrix3d::Identity(), floor_colour, 1.0F);
    for (const auto& [x, y, side, shares] : food) {
      const Colour colour = floor_with(floor_colour, shares);
      add(mjGEOM_BOX, {side, side, 0.01}, {x, y, -0.0105}, Eigen::Matrix3d::Identity(), colour, 1.0F);
    }
    const double step = half > 40 ? 10 : half > 15 ? 2 : 1;
    for (double at = -std::floor(half / step) * step; at <= half + 1e-9; at += step) {
      add_segment({at, -half, 1e-3}, {at, half, 1e-3}, 0.9 * static_cast<double>(scale_), grid_colour);
      add_segment({-half, at, 1e-3}, {half, at, 1e-3}, 0.9 * static_cast<double>(scale_), grid_colour);
    }
    for (const Obstacle& one : arena_.obstacles) add_obstacle(one);
    for (const Zone& zone : arena_.zones)
      add_circle(zone.x_m, zone.y_m, zone.radius_m, 1.5e-3, 1.6 * static_cast<double>(scale_), zone_colour);
    if (arena_.height_field) return add_slopes(*arena_.height_field);
    const double thick = 0.006 * half;
    const double height = 0.5 * edge_of(arena_).height_m;
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const double long_m = half + 2 * thick;
      const bool hides_the_floor = eye_m.x() * x + eye_m.y() * y > 1.02 * half;
      add(mjGEOM_BOX, {x != 0 ? thick : long_m, y != 0 ? thick : long_m, height},
          {x * (half + thick), y * (half + thick), height}, Eigen::Matrix3d::Identity(), wall_colour,
          hides_the_floor ? 0.25F : 1.0F);
    }
  }

  void add_obstacle(const Obstacle& one) {
    const double half_m = 0.5 * one.height_m;
    const auto upright = Eigen::Matrix3d::Identity();
    add(mjGEOM_CYLINDER, {one.radius_m, one.radius_m, half_m}, {one.x_m, one.y_m, half_m}, upright, wall_colour, 1.0F);
    if (one.is_pillar()) return;
    add(mjGEOM_CYLINDER, {one.radius_m, one.radius_m, half_m}, {one.to_x_m, one.to_y_m, half_m}, upright, wall_colour, 1.0F);
    const Eigen::AngleAxisd along{one.turn_rad(), Eigen::Vector3d::UnitZ()};
    add(mjGEOM_BOX, {0.5 * one.length_m(), one.radius_m, half_m}, {one.middle_x_m(), one.middle_y_m(), half_m},
        along.toRotationMatrix(), wall_colour, 1.0F);
  }

  /// A net of lines on the slopes, which lie a little lower than the floor: marks of robots at their foot stay visible.
  void add_slopes(const HeightField& field) {
    const double highest = std::ranges::max(field.height_m);
    const double scale = highest > 0.0 ? edge_of(arena_).height_m / highest : 1.0;
    const auto node = [&](std::size_t ix, std::size_t iy) {
      const double cell = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
      return Eigen::Vector3d{static_cast<double>(ix) * cell - field.half_extent_m,
                             static_cast<double>(iy) * cell - field.half_extent_m,
                             scale * field.height_m[iy * field.nodes + ix] - 0.07};
    };
    for (std::size_t i = 0; i < field.nodes; ++i) {
      for (std::size_t j = 0; j + 1 < field.nodes; ++j) {
        add_segment(node(i, j), node(i, j + 1), 1.6, wall_colour);
        add_segment(node(j, i), node(j + 1, i), 1.6, wall_colour);
      }
    }
  }

  void add_line(const FloorLine& line) {
    const Eigen::Vector3d from{line.x0_m, line.y0_m, 2e-3};
    const Eigen::Vector3d way{line.x1_m - line.x0_m, line.y1_m - line.y0_m, 0.0};
    const double pixels = (line.is_dashed ? 1.3 : 2.0) * static_cast<double>(scale_);
    const Colour colour = mixed(floor_colour, line.colour, line.opacity);
    constexpr double dash_pixels = 12.0;  // with the gap behind it
    constexpr double most_dashes = 40.0;
    const double dashes =
        line.is_dashed
            ? std::clamp(std::round(way.norm() / (dash_pixels * static_cast<double>(scale_) * pixel_m_)), 1.0, most_dashes)
            : 1.0;
    const double length = line.is_dashed && dashes > 1.0 ? 0.55 : 1.0;
    for (double dash = 0.0; dash < dashes; ++dash) {
      add_segment(from + dash / dashes * way, from + (dash + length) / dashes * way, pixels, colour);
    }
  }

  void add_ring(const RobotLook& look) {
    const double x = look.root.position_m.x();
    const double y = look.root.position_m.y();
    const double ring = ring_m(look);
    if (look.is_marked) {
      add_disc(x, y, 1.78 * ring, 0, ink);
      add_disc(x, y, 1.66 * ring, 1, floor_colour);
    }
    const Eigen::Quaterniond& q = look.root.orientation;
    const double yaw = std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
    const double heading = yaw + body_of(look).forward_rad;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd{heading + std::numbers::pi / 4, Eigen::Vector3d::UnitZ()}.toRotationMatrix();
    const double tip = 0.3 * ring;
    const Eigen::Vector3d at{x + 1.08 * ring * std::cos(heading), y + 1.08 * ring * std::sin(heading), 4e-3};
    add(mjGEOM_BOX, {tip, tip, 1e-3}, at, turn, look.colour, 1.0F);
    add_disc(x, y, ring, 2, look.colour);
    add_disc(x, y, 0.86 * ring, 3, look.filled ? mixed(floor_colour, look.colour, 0.45F) : floor_colour);
  }

  void add_flash(const Flash& flash) {
    const double pixel_m = pixel_at({flash.x_m, flash.y_m, 0.0});
    const double radius_m = flash.rings * ring_radius_m(robot_, static_cast<double>(scale_) * pixel_m);
    const double thin = 1.6 * static_cast<double>(scale_);
    const double pixels = flash.is_catch ? std::max(1.8 * thin, 0.07 * radius_m / pixel_m) : thin;
    add_circle(flash.x_m, flash.y_m, radius_m, 9e-3, pixels, flash.is_catch ? catch_colour : ink);
  }

  void add_circle(double x_m, double y_m, double radius_m, double z_m, double pixels, const Colour& colour) {
    constexpr int sides = 48;
    const auto corner = [&](int k) {
      const double angle = 2.0 * std::numbers::pi * k / sides;
      return Eigen::Vector3d{x_m + radius_m * std::cos(angle), y_m + radius_m * std::sin(angle), z_m};
    };
    for (int i = 0; i < sides; ++i) add_segment(corner(i), corner(i + 1), pixels, colour);
  }

  void add_body(const RobotLook& look) {
    const RobotModel& robot = body_of(look);
    std::vector<Eigen::Isometry3d> frames = link_frames(robot, look.root, look.joint_angles_rad);
    const double larger = std::max(1.0, ring_m(look) / (1.15 * robot.bounding_radius_m));  // as its ring is, on its feet
    const Eigen::Vector3d foot{look.root.position_m.x(), look.root.position_m.y(), 0.0};
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Colour colour = i == 0 ? look.colour : limb_colour(look.colour);
      for (const Box& box : robot.links[i].boxes) {
        Eigen::Isometry3d frame = frames[i] * Eigen::Translation3d{box.centre_m} * box.orientation;
        frame.translation() = foot + larger * (frame.translation() - foot);
        const Eigen::Vector3d half_m = larger * box.half_extents_m;
        add(mjGEOM_BOX, half_m, frame.translation(), frame.linear(), colour, 1.0F)->category = mjCAT_DYNAMIC;
        if (!arena_.height_field) add_shadow(half_m, frame);
      }
    }
  }

  /// Rectangles round what a box hides of the light.
  void add_shadow(const Eigen::Vector3d& half_m, const Eigen::Isometry3d& frame) {
    const auto cast = [](const Eigen::Vector3d& v) { return Eigen::Vector2d{v.x() + light_x * v.z(), v.y() + light_y * v.z()}; };
    std::array<Eigen::Vector2d, 3> edges;
    for (int axis = 0; axis < 3; ++axis) {
      edges[static_cast<std::size_t>(axis)] = cast(half_m[axis] * frame.linear().col(axis));
    }
    const Eigen::Vector2d along =
        std::ranges::max_element(edges, {}, [](const Eigen::Vector2d& edge) { return edge.norm(); })->normalized();
    double half_length = 0.0;
    double half_width = 0.0;
    for (const Eigen::Vector2d& edge : edges) {
      half_length += std::abs(edge.dot(along));
      half_width += std::abs(edge.x() * along.y() - edge.y() * along.x());
    }
    const Eigen::Vector2d at = cast(frame.translation());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd{std::atan2(along.y(), along.x()), Eigen::Vector3d::UnitZ()}.toRotationMatrix();
    for (int layer = -1; layer <= 1; ++layer) {
      const double wider = shadow_edge * half_width * layer;
      const Eigen::Vector3d size{half_length + wider, half_width + wider, 1e-4};
      add(mjGEOM_BOX, size, {at.x(), at.y(), 7.5e-3 + 4e-4 * layer}, turn, ink, shadow_opacity);
    }
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
  mjrRect view_{0, 0, static_cast<int>(width_), static_cast<int>(height_)};
  Sight sight_{Camera{}};
  double a_pixel_ = 0.01;  ///< size of a pixel at a distance of 1
  double pixel_m_ = 0.01;  ///< approximate size of a pixel at the camera's target
};

Renderer::Renderer(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality)
    : scene_{std::make_unique<Scene>(robot, arena, width, height, quality)} {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
/// An exception that passed through the driver leaves its locks closed: what it draws with then stays until the exit.
Renderer::~Renderer() {
  if (std::uncaught_exceptions() > 0) static_cast<void>(scene_.release());
}

double Renderer::aspect(const Picture& picture) const {
  return scene_->aspect(picture);
}

Image Renderer::draw(const Picture& picture, const Camera& camera) {
  return scene_->draw(picture, camera);
}

}  // namespace trophic::film
