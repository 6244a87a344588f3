// SPDX-License-Identifier: MIT
// Reads the constants of a body from MuJoCo's model.
#pragma once

#include <mujoco/mujoco.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>
#include <trophic/backend/mujoco/box_test.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/mujoco/kernel/body.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// Reads a KernelModel from MuJoCo's model of one robot; see `read_model`.
class ModelReader {
 public:
  explicit ModelReader(const mjModel& model) : m_{model} {}

  [[nodiscard]] std::optional<KernelModel> read() {
    if (!plain_options() || !plain_geoms() || !plain_tree() || !plain_servos() || !read_ground()) return std::nullopt;
    kernel_.friction = std::max(friction_, mjMINMU);
    kernel_.link_friction = std::max(robot_friction_, mjMINMU);
    kernel_.timestep_s = m_.opt.timestep;
    kernel_.gravity_m_s2 = -m_.opt.gravity[2];
    kernel_.runge_kutta = m_.opt.integrator == mjINT_RK4;
    if (mujoco::asks_whole_box_depth(m_)) kernel_.box_depth = mujoco::BoxDepth::whole;
    read_law();
    for (int body = 1; body < m_.nbody; ++body) read_link(body);
    read_reaches();
    for (std::size_t b = 1; b < kernel_.links.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        const bool boxes = kernel_.links[a].boxes > 0 && kernel_.links[b].boxes > 0;
        if (kernel_.links[b].parent != a && boxes) kernel_.pairs.push_back({a, b});
      }
    }
    return kernel_;
  }

 private:
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

  static Vector vector(const mjtNum* from) { return {from[0], from[1], from[2]}; }
  static Matrix rotation(const mjtNum* q) { return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix(); }
  static void store(const Vector& from, std::array<double, 3>& to) { std::copy_n(from.data(), 3, to.begin()); }
  static void store(const Matrix& from, std::array<double, 9>& to) { std::copy_n(from.data(), 9, to.begin()); }

  [[nodiscard]] bool plain_options() const {
    const mjOption& o = m_.opt;
    const bool solver = o.solver == mjSOL_NEWTON && o.cone == mjCONE_PYRAMIDAL && o.impratio == 1.0 && o.noslip_iterations == 0;
    const bool still_air = o.density == 0.0 && o.viscosity == 0.0 && o.gravity[0] == 0.0 && o.gravity[1] == 0.0;
    const bool flags = (o.disableflags & ~mujoco::turned_off) == 0 && (o.enableflags & (mjENBL_OVERRIDE | mjENBL_FWDINV)) == 0;
    const bool extras = m_.ntendon == 0 && m_.neq == 0 && m_.na == 0 && m_.nmocap == 0 && m_.nexclude == 0;
    return solver && still_air && flags && extras && (o.integrator == mjINT_EULER || o.integrator == mjINT_RK4);
  }

  /// Accepts planes or a height field of the world and boxes of the robot, all with equal contact parameters; the same applies to
  /// explicit pairs.
  [[nodiscard]] bool plain_geoms() {
    const bool only_pairs = mujoco::tests_only_pairs(m_);
    for (int g = 0; g < m_.ngeom; ++g) {
      const bool own = m_.geom_bodyid[g] != 0;
      const bool ground = m_.geom_type[g] == mjGEOM_PLANE || m_.geom_type[g] == mjGEOM_HFIELD;
      if (own ? m_.geom_type[g] != mjGEOM_BOX : !ground) return false;
      if (m_.geom_condim[g] != 3 || m_.geom_priority[g] != 0 || m_.geom_margin[g] != 0.0 || m_.geom_gap[g] != 0.0) return false;
      const int type = mujoco::has_collision_option || !only_pairs ? 1 : 0;
      if (m_.geom_contype[g] != type || m_.geom_conaffinity[g] != type ||
          !same_law(m_.geom_solref + 2 * g, m_.geom_solimp + 5 * g)) {
        return false;
      }
      double& part = own ? robot_friction_ : ground_friction_;
      if (part >= 0.0 && part != m_.geom_friction[3 * g]) return false;
      part = m_.geom_friction[3 * g];
    }
    friction_ = std::max(robot_friction_, ground_friction_);
    for (int p = 0; mujoco::tests_pairs(m_) && p < m_.npair; ++p) {
      if (m_.pair_dim[p] != 3 || m_.pair_margin[p] != 0.0 || m_.pair_gap[p] != 0.0) return false;
      const bool ground = m_.geom_bodyid[m_.pair_geom1[p]] == 0 || m_.geom_bodyid[m_.pair_geom2[p]] == 0;
      const mjtNum* friction = m_.pair_friction + 5 * p;
      const double expected = ground ? friction_ : robot_friction_;
      if (friction[0] != expected || friction[1] != expected) return false;
      if (!same_law(m_.pair_solref + 2 * p, m_.pair_solimp + 5 * p)) return false;
    }
    return !only_pairs || m_.npair > 0;
  }

  /// A free root and one plain hinge for every other body.
  [[nodiscard]] bool plain_tree() const {
    if (m_.nbody < 2 || m_.njnt != m_.nbody - 1) return false;
    for (int body = 1; body < m_.nbody; ++body) {
      const int joint = body - 1;
      if (m_.body_jntnum[body] != 1 || m_.body_jntadr[body] != joint) return false;
      if (m_.jnt_type[joint] != (body == 1 ? mjJNT_FREE : mjJNT_HINGE) || (m_.body_parentid[body] == 0) != (body == 1))
        return false;
      if (m_.jnt_stiffness[joint] != 0.0) return false;
      if (body == 1) continue;
      if (!vector(m_.jnt_pos + 3 * joint).isZero(0.0) || m_.qpos0[joint + 6] != 0.0 || m_.jnt_limited[joint] == 0) return false;
      if (m_.jnt_margin[joint] != 0.0 || !same_law(m_.jnt_solref + 2 * joint, m_.jnt_solimp + 5 * joint)) return false;
    }
    for (int dof = 0; dof < m_.nv; ++dof) {
      if (m_.dof_armature[dof] != 0.0 || m_.dof_frictionloss[dof] != 0.0 || (dof < 6 && m_.dof_damping[dof] != 0.0)) return false;
    }
    return true;
  }

  /// One affine actuator per hinge.
  [[nodiscard]] bool plain_servos() {
    servo_of_.assign(static_cast<std::size_t>(m_.njnt), -1);
    for (int a = 0; a < m_.nu; ++a) {
      const bool affine = m_.actuator_gaintype[a] == mjGAIN_FIXED && m_.actuator_dyntype[a] == mjDYN_NONE &&
                          (m_.actuator_biastype[a] == mjBIAS_AFFINE || m_.actuator_biastype[a] == mjBIAS_NONE);
      if (!affine || m_.actuator_trntype[a] != mjTRN_JOINT || m_.actuator_forcelimited[a] != 0 ||
          m_.actuator_gear[6 * a] != 1.0) {
        return false;
      }
      int& servo = servo_of_[static_cast<std::size_t>(m_.actuator_trnid[2 * a])];
      if (servo != -1) return false;
      servo = a;
    }
    return m_.nu == m_.njnt - 1 && std::ranges::count(servo_of_, -1) == 1 && servo_of_[0] == -1;
  }

  /// Whether the softness parameters equal those of the first call and have power 2.
  [[nodiscard]] bool same_law(const mjtNum* solref, const mjtNum* solimp) {
    if (solref_ == nullptr) {
      solref_ = solref;
      solimp_ = solimp;
      return solref[0] > 0.0 && solref[1] > 0.0 && solimp[4] == 2.0 && solimp[2] > mjMINVAL && solimp[0] < solimp[1];
    }
    return std::equal(solref, solref + mjNREF, solref_) && std::equal(solimp, solimp + mjNIMP, solimp_);
  }
  [[nodiscard]] bool same_law(const mjtNum* solref, const mjtNum* solimp) const {
    return std::equal(solref, solref + mjNREF, solref_) && std::equal(solimp, solimp + mjNIMP, solimp_);
  }

  /// MuJoCo keeps the time constant tc at two timesteps at least; K = 1 / (dmax tc zeta)^2, B = 2 / (dmax tc).
  void read_law() {
    const auto bounded = [](double value) { return std::clamp(value, mjMINIMP, mjMAXIMP); };
    ContactLaw& law = kernel_.law;
    law.impedance_min = bounded(solimp_[0]);
    law.impedance_max = bounded(solimp_[1]);
    law.width_m = solimp_[2];
    law.midpoint = bounded(solimp_[3]);
    const double rate = law.impedance_max * std::max(solref_[0], 2.0 * m_.opt.timestep);
    law.damping_per_s = 2.0 / rate;
    law.stiffness_per_s2 = 1.0 / (rate * rate * solref_[1] * solref_[1]);
  }

  /// Planes across the axes of the world and one height field at most.
  [[nodiscard]] bool read_ground() {
    for (int g = 0; g < m_.ngeom; ++g) {
      if (m_.geom_bodyid[g] != 0) continue;
      if (m_.geom_type[g] == mjGEOM_HFIELD) {
        const mjtNum* const turn = m_.geom_quat + 4 * g;
        if (kernel_.field || turn[0] != 1.0) return false;
        const int* const box = std::find(m_.geom_type, m_.geom_type + m_.ngeom, static_cast<int>(mjGEOM_BOX));
        if (box == m_.geom_type + m_.ngeom) return false;
        const mujoco::EngineGuard guard;
        kernel_.field = {{mj_copyModel(nullptr, &m_), mujoco::DeleteModel{}}, g, static_cast<int>(box - m_.geom_type)};
        continue;
      }
      const Vector normal = rotation(m_.geom_quat + 4 * g).col(2);
      const Vector rounded = normal.array().round().matrix();
      if ((normal - rounded).cwiseAbs().maxCoeff() > 1e-12) return false;
      Eigen::Index axis = 0;
      rounded.cwiseAbs().maxCoeff(&axis);
      kernel_.planes.push_back({static_cast<int>(axis), rounded[axis], rounded.dot(vector(m_.geom_pos + 3 * g))});
    }
    return true;
  }

  /// Orthonormal axes whose third is `axis`; a permutation of the coordinate axes if `axis` is one of them.
  [[nodiscard]] static Matrix frame_along(const Vector& axis) {
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    const Vector third = axis.normalized();
    const Vector guess = Vector::Unit((largest + 1) % 3);
    const Vector first = (guess - guess.dot(third) * third).normalized();
    Matrix frame;
    frame << first, third.cross(first), third;
    return frame;
  }

  void read_link(int body) {
    const int joint = body - 1;
    const Matrix frame = body == 1 ? Matrix::Identity() : frame_along(vector(m_.jnt_axis + 3 * joint));
    frames_.push_back(frame);
    KernelLink own{};
    const Matrix principal = frame.transpose() * rotation(m_.body_iquat + 4 * body);
    const Matrix inertia = principal * vector(m_.body_inertia + 3 * body).asDiagonal() * principal.transpose();
    own.mass_kg = m_.body_mass[body];
    own.inertia_kgm2 = {inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2)};
    store(frame.transpose() * vector(m_.body_ipos + 3 * body), own.centre_of_mass_m);
    own.own_inverse_weight_per_kg = m_.body_invweight0[2 * body];
    own.inverse_weight_per_kg = own.own_inverse_weight_per_kg + m_.body_invweight0[0];
    reaches_m_.push_back(0.0);
    if (body > 1) {
      own.parent = static_cast<std::size_t>(m_.body_parentid[body] - 1);
      const Matrix& parent = frames_[own.parent];
      store(parent.transpose() * vector(m_.body_pos + 3 * body), own.offset_m);
      store(parent.transpose() * rotation(m_.body_quat + 4 * body) * frame, own.rotation);
      reaches_m_.back() = reaches_m_[own.parent] + vector(m_.body_pos + 3 * body).norm();
      read_hinge(joint);
    }
    own.first_box = kernel_.boxes.size();
    own.boxes = static_cast<std::size_t>(m_.body_geomnum[body]);
    for (int g = m_.body_geomadr[body]; g < m_.body_geomadr[body] + m_.body_geomnum[body]; ++g) read_box(g, frame);
    enclose_boxes(own);
    kernel_.links.push_back(own);
  }

  /// From the leaves inwards, as a link comes after its parent.
  void read_reaches() {
    const auto length_m = [](const std::array<double, 3>& a) { return Vector(a[0], a[1], a[2]).norm(); };
    for (std::size_t i = kernel_.links.size(); i-- > 0;) {
      KernelLink& link = kernel_.links[i];
      link.reach_m = std::max(link.reach_m, length_m(link.sphere_centre_m) + link.sphere_radius_m);
      if (i == 0) continue;
      KernelLink& parent = kernel_.links[link.parent];
      parent.reach_m = std::max(parent.reach_m, length_m(link.offset_m) + link.reach_m);
    }
  }

  void read_hinge(int joint) {
    const int servo = servo_of_[static_cast<std::size_t>(joint)];
    const int dof = joint + 5;
    const mjtNum* bias = m_.actuator_biasprm + mjNBIAS * servo;
    const bool biased = m_.actuator_biastype[servo] == mjBIAS_AFFINE;
    const bool clipped = m_.actuator_ctrllimited[servo] != 0;
    kernel_.hinges.push_back({{.lower_rad = m_.jnt_range[2 * joint],
                               .upper_rad = m_.jnt_range[2 * joint + 1],
                               .damping = m_.dof_damping[dof],
                               .inverse_weight = m_.dof_invweight0[dof],
                               .gain = m_.actuator_gainprm[mjNGAIN * servo],
                               .bias = biased ? bias[0] : 0.0,
                               .angle_gain = biased ? bias[1] : 0.0,
                               .rate_gain = (biased ? bias[2] : 0.0) - m_.dof_damping[dof],
                               .lowest_target_rad = clipped ? m_.actuator_ctrlrange[2 * servo] : -mjMAXVAL,
                               .highest_target_rad = clipped ? m_.actuator_ctrlrange[2 * servo + 1] : mjMAXVAL},
                              static_cast<std::size_t>(servo)});
    kernel_.damped |= m_.dof_damping[dof] > 0.0;
  }

  void read_box(int geom, const Matrix& frame) {
    KernelBox own{};
    const Vector centre = vector(m_.geom_pos + 3 * geom);
    Matrix axes = frame.transpose() * rotation(m_.geom_quat + 4 * geom);
    Vector half_m = vector(m_.geom_size + 3 * geom);
    store(half_m, own.geom_half_extents_m);
    store(axes, own.geom_axes);
    // A box turned by right angles is the same box with its extents exchanged.
    const Matrix rounded = axes.array().round().matrix();
    own.aligned = (axes - rounded).cwiseAbs().maxCoeff() < 1e-12;
    if (own.aligned) {
      half_m = rounded.cwiseAbs() * half_m;
      axes.setIdentity();
    }
    store(frame.transpose() * centre, own.centre_m);
    store(half_m, own.half_extents_m);
    store(axes, own.axes);
    own.radius_m = half_m.norm();
    kernel_.bounding_radius_m = std::max(kernel_.bounding_radius_m, reaches_m_.back() + centre.norm() + own.radius_m);
    kernel_.boxes.push_back(own);
  }

  /// Sphere around the middle of the link's boxes.
  void enclose_boxes(KernelLink& link) const {
    std::vector<Vector> corners;
    for (std::size_t b = link.first_box; b < link.first_box + link.boxes; ++b) {
      const KernelBox& box = kernel_.boxes[b];
      const Eigen::Map<const Matrix> axes(box.axes.data());
      for (int corner = 0; corner < 8; ++corner) {
        const Vector sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
        corners.push_back(Eigen::Map<const Vector>(box.centre_m.data()) +
                          axes * sign.cwiseProduct(Eigen::Map<const Vector>(box.half_extents_m.data())));
      }
    }
    if (corners.empty()) return;
    Eigen::AlignedBox3d around;
    for (const Vector& corner : corners) around.extend(corner);
    store(around.center(), link.sphere_centre_m);
    for (const Vector& corner : corners) link.sphere_radius_m = std::max(link.sphere_radius_m, (corner - around.center()).norm());
  }

  const mjModel& m_;
  KernelModel kernel_;
  const mjtNum* solref_ = nullptr;
  const mjtNum* solimp_ = nullptr;
  double robot_friction_ = -1.0;
  double ground_friction_ = -1.0;
  double friction_ = 0.0;
  std::vector<int> servo_of_;
  std::vector<Matrix> frames_;     ///< kernel axes in MuJoCo's body frame
  std::vector<double> reaches_m_;  ///< length of the chain from the root's origin to the link's hinge
};

/// The kernel's constants of a model of one robot on planes or a height field, or nothing if the model requires something that
/// the kernel does not compute; then MuJoCo must step it.
[[nodiscard]] inline std::optional<KernelModel> read_model(const mjModel& model) {
  return ModelReader{model}.read();
}

}  // namespace trophic::backend::kernel
