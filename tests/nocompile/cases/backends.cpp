// SPDX-License-Identifier: MIT
// A backend of one's own, and one of trophic's.
#include <trophic/backend/backend_choice.hpp>
#include <trophic/backend/kinematic.hpp>

class Still {
 public:
  static constexpr std::string_view name = "still";
  static std::string version() { return "1"; }
  static std::vector<std::string> remarks(const trophic::Physics&) { return {}; }
  struct Params {
    using Backend = Still;
  };
  struct State {
    double time_s = 0.0;
    static constexpr auto saved() { return std::tuple{&State::time_s}; }
  };

  Still(const trophic::RobotModel&, const trophic::Arena&, std::span<const trophic::Pose> starts, const trophic::Physics&,
        const Params&)
      : poses_{starts.begin(), starts.end()} {}
  void advance_to(double time_s) { state_.time_s = std::max(state_.time_s, time_s); }
  std::size_t robots() const { return poses_.size(); }
  double time_s() const { return state_.time_s; }
  trophic::Pose pose(std::size_t robot) const { return poses_.at(robot); }
  std::span<const double> joint_angles(std::size_t) const { return {}; }
  State save() const { return state_; }
  void restore(const State& state) { state_ = state; }

 private:
  std::vector<trophic::Pose> poses_;
  State state_;
};

int main() {
  const trophic::BackendChoice own{Still::Params{}};
  const trophic::BackendChoice shipped{trophic::backend::Kinematic::Params{.speed_scale = 2.0}};
  return own.name() == shipped.name() ? 1 : 0;
}
