// SPDX-License-Identifier: MIT
// The kernel's parts for robots that touch each other: contacts of boxes and the system of equations.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <Eigen/Dense>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/kernel/symmetric_system.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using backend::kernel::BoxCollider;
using backend::kernel::BoxContact;
using backend::kernel::PlacedBox;
using backend::kernel::SymmetricSystem;
using backend::mujoco::BoxDepth;

namespace {

PlacedBox box(const Eigen::Vector3d& centre_m, const Eigen::Quaterniond& turn, const Eigen::Vector3d& half_m) {
  const Eigen::Matrix3d axes = turn.toRotationMatrix();
  PlacedBox placed;
  for (int i = 0; i < 3; ++i) {
    placed.centre_m[i] = centre_m[i];
    placed.half_m[i] = half_m[i];
    for (int k = 0; k < 3; ++k) placed.axis[k][i] = axes(i, k);
  }
  return placed;
}

/// Two loose boxes in MuJoCo.
class LooseBoxes {
 public:
  LooseBoxes(const Eigen::Vector3d& half_a_m, const Eigen::Vector3d& half_b_m, BoxDepth depth) {
    pugi::xml_document document;
    auto root = document.append_child("mujoco");
    if (depth == BoxDepth::whole) backend::mujoco::ask_whole_box_depth(root);
    auto world = root.append_child("worldbody");
    for (int i = 0; i < 2; ++i) {
      auto body = world.append_child("body");
      body.append_child("freejoint");
      auto geom = body.append_child("geom");
      geom.append_attribute("type") = "box";
      geom.append_attribute("size") = "1 1 1";
    }
    model_ = backend::mujoco::compile(document, std::nullopt);
    std::copy_n(half_a_m.data(), 3, model_->geom_size);
    std::copy_n(half_b_m.data(), 3, model_->geom_size + 3);
    model_->geom_rbound[0] = half_a_m.norm();
    model_->geom_rbound[1] = half_b_m.norm();
    data_.reset(mj_makeData(model_.get()));
  }

  /// Their contacts by mj_collision.
  std::span<const mjContact> collide(const Eigen::Vector3d& a_m, const Eigen::Quaterniond& turn_a, const Eigen::Vector3d& b_m,
                                     const Eigen::Quaterniond& turn_b) {
    std::size_t at = 0;
    for (const auto& [centre_m, turn] : {std::pair{a_m, turn_a}, std::pair{b_m, turn_b}}) {
      std::copy_n(centre_m.data(), 3, data_->qpos + at);
      const std::array<double, 4> q{turn.w(), turn.x(), turn.y(), turn.z()};
      std::ranges::copy(q, data_->qpos + at + 3);
      at += 7;
    }
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_collision(model_.get(), data_.get());
    return {data_->contact, static_cast<std::size_t>(data_->ncon)};
  }

 private:
  backend::mujoco::ModelPtr model_;
  backend::mujoco::DataPtr data_;
};

Eigen::Vector3d random_vector(Rng& rng, double low, double high) {
  return {rng.uniform(low, high), rng.uniform(low, high), rng.uniform(low, high)};
}

Eigen::Quaterniond random_turn(Rng& rng) {
  return Eigen::Quaterniond{rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1)}.normalized();
}

}  // namespace

TEST_CASE("kernel contacts: two random boxes -> the contacts of mj_collision, frames included") {
  std::array<BoxCollider, 2> colliders{BoxCollider{BoxDepth::engine}, BoxCollider{BoxDepth::whole}};
  std::size_t found = 0;
  CHECK(rc::check([&](std::uint64_t seed, bool whole) {
    Rng rng{seed, Stream::user};
    BoxCollider& collider = colliders[whole ? 1 : 0];
    const Eigen::Vector3d half_a_m = random_vector(rng, 0.005, 0.05);
    const Eigen::Vector3d half_b_m = random_vector(rng, 0.005, 0.05);
    LooseBoxes boxes{half_a_m, half_b_m, whole ? BoxDepth::whole : BoxDepth::engine};
    for (int trial = 0; trial < 20; ++trial) {
      const Eigen::Vector3d a_m = random_vector(rng, -1.0, 1.0);
      const Eigen::Vector3d apart_m = random_vector(rng, -0.05, 0.05);
      const Eigen::Quaterniond turn_a = random_turn(rng);
      const Eigen::Quaterniond turn_b = random_turn(rng);
      const std::span<const mjContact> expected = boxes.collide(a_m, turn_a, a_m + apart_m, turn_b);
      std::vector<BoxContact> contacts;
      const bool sure = collider.collide(box({0, 0, 0}, turn_a, half_a_m), box({0, 0, 0}, turn_b, half_b_m),
                                         {apart_m.x(), apart_m.y(), apart_m.z()},
                                         [&](const BoxContact& contact) { contacts.push_back(contact); });
      if (!sure) continue;
      RC_ASSERT(contacts.size() == expected.size());
      found += contacts.size();
      for (std::size_t c = 0; c < contacts.size(); ++c) {
        RC_ASSERT(std::abs(contacts[c].depth_m - expected[c].dist) < 1e-12);
        for (std::size_t i = 0; i < 3; ++i) {
          RC_ASSERT(std::abs(contacts[c].point_m[i] + a_m[static_cast<Eigen::Index>(i)] - expected[c].pos[i]) < 1e-12);
          for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(std::abs(contacts[c].frame[k][i] - expected[c].frame[3 * k + i]) < 1e-9);
        }
      }
    }
  }));
  CHECK(found > 500);
}

TEST_CASE("kernel contacts: boxes with parallel edges, or an edge along a face -> left to MuJoCo") {
  BoxCollider collider;
  const auto sure = [&](const Eigen::Quaterniond& turn) {
    const Eigen::Vector3d half_m{0.02, 0.03, 0.04};
    return collider.collide(box({0, 0, 0}, Eigen::Quaterniond::Identity(), half_m), box({0.01, 0.02, 0.03}, turn, half_m), {},
                            [](const BoxContact&) {});
  };
  CHECK_FALSE(sure(Eigen::Quaterniond::Identity()));
  CHECK_FALSE(sure(Eigen::Quaterniond{Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())}));
  CHECK(sure(Eigen::Quaterniond{Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized())}));
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
