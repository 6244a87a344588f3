// SPDX-License-Identifier: MIT
// The kernel's parts for robots that touch each other: contacts of boxes and the system of equations.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <trophic/backend/mujoco/box_test.hpp>
#include <trophic/backend/mujoco/compile.hpp>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/kernel/symmetric_system.hpp>
#include <trophic/support/rng.hpp>

using namespace trophic;
using backend::kernel::BoxOverlap;
using backend::kernel::PlacedBox;
using backend::kernel::Point3;
using backend::kernel::SymmetricSystem;
using backend::mujoco::BoxDepth;
using Found = backend::mujoco::FoundContact;

namespace {

PlacedBox box(const Eigen::Vector3d& centre_m, const Eigen::Quaterniond& turn, const Eigen::Vector3d& half_m) {
  const Eigen::Matrix3d axes = turn.toRotationMatrix();
  PlacedBox placed;
  std::copy_n(centre_m.data(), 3, placed.centre_m.begin());
  std::copy_n(half_m.data(), 3, placed.half_m.begin());
  for (std::size_t k = 0; k < 3; ++k) std::copy_n(axes.col(static_cast<Eigen::Index>(k)).data(), 3, placed.axis[k].begin());
  return placed;
}

/// MuJoCo's test of two boxes, as the backend installs it.
class EngineBoxes {
 public:
  explicit EngineBoxes(BoxDepth depth) {
    pugi::xml_document document;
    auto root = document.append_child("mujoco");
    if (depth == BoxDepth::whole) backend::mujoco::ask_whole_box_depth(root);
    auto world = root.append_child("worldbody");
    for (int i = 0; i < 2; ++i) {
      auto geom = world.append_child("geom");
      geom.append_attribute("type") = "box";
      geom.append_attribute("size") = "1 1 1";
    }
    model_ = backend::mujoco::compile(document, std::nullopt);
    data_.reset(mj_makeData(model_.get()));
  }

  std::span<const Found> collide(const PlacedBox& a, const PlacedBox& b, const Point3& apart_m) {
    std::size_t geom = 0;
    for (const auto& [box, moved_m] : {std::pair{&a, Point3{}}, std::pair{&b, apart_m}}) {
      std::copy_n(box->half_m.data(), 3, model_->geom_size + 3 * geom);
      backend::kernel::place_geom(*data_, geom++, *box, moved_m);
    }
    const auto find = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX];
    return {found_.data(), static_cast<std::size_t>(find(model_.get(), data_.get(), found_.data(), 0, 1, 0.0))};
  }

 private:
  backend::mujoco::ModelPtr model_;
  backend::mujoco::DataPtr data_;
  std::array<Found, mjMAXCONPAIR> found_{};
};

Eigen::Vector3d random_vector(Rng& rng, double low, double high) {
  return {rng.uniform(low, high), rng.uniform(low, high), rng.uniform(low, high)};
}

Eigen::Quaterniond random_turn(Rng& rng) {
  return Eigen::Quaterniond{rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1)}.normalized();
}

/// Whether the contacts are MuJoCo's to the last bit, or to rounding where its function is compiled otherwise.
bool same_contacts(const BoxOverlap& own, double face_scale, std::span<const Found> expected) {
  bool same = own.count == expected.size();
  const auto is = [](double a, double b) { return backend::mujoco::is_mujoco_3 ? std::abs(a - b) < 1e-12 : a == b; };
  for (std::size_t c = 0; c < own.count && same; ++c) {
    same = is(own.depths_m[c] * (own.on_face ? face_scale : 1.0), expected[c].dist);
    for (std::size_t i = 0; i < 3; ++i)
      same &= is(own.points_m[c][i], expected[c].pos[i]) && is(own.normal[i], backend::mujoco::normal_of(expected[c])[i]);
  }
  return same;
}

}  // namespace

TEST_CASE("kernel contacts: random boxes, every fourth pair with parallel edges -> MuJoCo's contacts, bit for bit") {
  const char* const many = std::getenv("TROPHIC_BOX_PAIRS");  // a million by hand
  const std::size_t pairs = many != nullptr ? std::stoul(many) : 20'000;
  EngineBoxes half{BoxDepth::engine};
  EngineBoxes whole{BoxDepth::whole};
  Rng rng{11, Stream::user};
  std::size_t faces = 0;
  std::size_t wrong = 0;
  for (std::size_t pair = 0; pair < pairs;) {
    const Eigen::Quaterniond turn = random_turn(rng);
    const Eigen::Quaterniond about{
        Eigen::AngleAxisd{rng.uniform(0.0, 3.0), Eigen::Vector3d::Unit(static_cast<int>(rng.index(3)))}};
    const PlacedBox a = box(random_vector(rng, -1.0, 1.0), turn, random_vector(rng, 0.005, 0.05));
    const PlacedBox b =
        box(random_vector(rng, -1.0, 1.0), pair % 4 == 0 ? turn * about : random_turn(rng), random_vector(rng, 0.005, 0.05));
    Point3 apart_m;
    for (std::size_t i = 0; i < 3; ++i) apart_m[i] = a.centre_m[i] - b.centre_m[i] + rng.uniform(-0.08, 0.08);
    BoxOverlap overlap{a, b, apart_m};
    if (!overlap.separated(0.0)) overlap.meet();
    if (backend::mujoco::replaces_box_test) keep_contacts(overlap);
    const std::span<const Found> expected = half.collide(a, b, apart_m);
    if (expected.empty() && overlap.count == 0) continue;
    faces += overlap.on_face ? 1U : 0U;
    // From 3.12 on MuJoCo's own test, for models without the request, finds other contacts.
    const double engine_scale = backend::mujoco::halves_box_depth ? 1.0 : 2.0;
    wrong += backend::mujoco::replaces_box_test || same_contacts(overlap, engine_scale, expected) ? 0U : 1U;
    wrong += same_contacts(overlap, 2.0, whole.collide(a, b, apart_m)) ? 0U : 1U;
    ++pair;
  }
  CHECK(wrong == 0);
  CHECK(faces > pairs / 4);
  CHECK(faces < 3 * pairs / 4);
}

TEST_CASE("kernel equations: random sparse symmetric positive definite system -> solved") {
  SymmetricSystem system;
  CHECK(rc::check([&](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const std::size_t n = 1 + rng.index(40);
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd factor = Eigen::MatrixXd::Identity(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < i; ++j) factor(i, j) = rng.chance(0.3) ? rng.normal(0.0, 1.0) : 0.0;
    }
    const Eigen::MatrixXd matrix = factor.transpose() * factor + Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index) { return rng.normal(0.0, 1.0); });
    system.reset(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const auto [row, column] = rng.chance(0.5) ? std::pair{i, j} : std::pair{j, i};  // either side may be written
        system(row, column) = matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
    Eigen::VectorXd solution = matrix * x;
    system.solve({solution.data(), n});
    RC_ASSERT((solution - x).norm() < 1e-9 * (1.0 + x.norm()));
  }));
}
