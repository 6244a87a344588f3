// SPDX-License-Identifier: MIT
// The type-erased choice of a backend, with its parameters.
#pragma once

#include <trophic/backend/any_backend.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic {

/// A backend and its parameters, before it has bodies. Constructed from them: `backend::Mujoco::Params{.threads = 2}`.
class BackendChoice {
 public:
  template <class Params>
  requires requires { typename Params::Backend; }
  BackendChoice(Params params);  // NOLINT(google-explicit-constructor): the parameters are the choice

  BackendChoice(const BackendChoice& other) : choice_{other.choice_->copy()} {}
  BackendChoice(BackendChoice&&) noexcept = default;
  BackendChoice& operator=(const BackendChoice& other) {
    choice_ = other.choice_->copy();
    return *this;
  }
  BackendChoice& operator=(BackendChoice&&) noexcept = default;
  ~BackendChoice() = default;

  /// Returns the same backend with default parameters.
  [[nodiscard]] BackendChoice fresh() const {
    BackendChoice same{*this};
    same.choice_ = choice_->fresh();
    return same;
  }
  [[nodiscard]] std::string name() const { return std::string{choice_->name()}; }
  [[nodiscard]] std::string version() const { return choice_->version(); }
  /// One sentence for each parameter of `physics` without effect.
  [[nodiscard]] std::vector<std::string> remarks(const Physics& physics) const { return choice_->remarks(physics); }
  /// Sets the members of `physics` that the backend's parameters prescribe, such as the time step of a stepping mode, and returns
  /// a sentence about it. Throws std::invalid_argument if `physics` has neither the prescribed value nor that of `table`, the
  /// physics of the rule table.
  std::string prescribe(Physics& physics, const Physics& table) const { return choice_->prescribe(physics, table); }
  [[nodiscard]] bool has_joints() const { return choice_->has_joints(); }
  /// Whether bodies can be exchanged (Embodying).
  [[nodiscard]] bool can_embody() const { return choice_->can_embody(); }
  /// Whether robots can be removed and added (Placing).
  [[nodiscard]] bool can_place() const { return choice_->can_place(); }
  /// The backend's number of threads; null for a backend without threads.
  [[nodiscard]] std::size_t* threads() { return choice_->threads(); }

  /// Appends references to its parameters, under "PATH.".
  void append_param_refs(std::string_view path, ParamRefs& params) { choice_->append_param_refs(path, params); }
  /// Throws std::invalid_argument naming the first number outside its bounds, as "PATH.NAME".
  void validate(std::string_view path) const { choice_->validate(path); }

  /// The parameters of backend B; null if a different backend was chosen.
  template <Backend B>
  [[nodiscard]] typename B::Params* as() {
    auto* choice = dynamic_cast<Of<B>*>(choice_.get());
    return choice == nullptr ? nullptr : &choice->params;
  }

  /// Makes the backend with one body per start pose. Throws as the backend's constructor does.
  [[nodiscard]] std::unique_ptr<AnyBackend> build(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts,
                                                  const Physics& physics) const {
    return choice_->build(robot, arena, starts, physics);
  }

 private:
  class Any {
   public:
    Any() = default;
    Any(const Any&) = default;
    Any& operator=(const Any&) = delete;
    virtual ~Any() = default;
    [[nodiscard]] virtual std::unique_ptr<Any> copy() const = 0;
    [[nodiscard]] virtual std::unique_ptr<Any> fresh() const = 0;
    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual std::string version() const = 0;
    [[nodiscard]] virtual std::vector<std::string> remarks(const Physics& physics) const = 0;
    [[nodiscard]] virtual std::string prescribe(Physics& physics, const Physics& table) const = 0;
    [[nodiscard]] virtual bool has_joints() const = 0;
    [[nodiscard]] virtual bool can_embody() const = 0;
    [[nodiscard]] virtual bool can_place() const = 0;
    [[nodiscard]] virtual std::size_t* threads() = 0;
    virtual void validate(std::string_view path) const = 0;
    virtual void append_param_refs(std::string_view path, ParamRefs& refs) = 0;
    [[nodiscard]] virtual std::unique_ptr<AnyBackend> build(const RobotModel& robot, const Arena& arena,
                                                            std::span<const Pose> starts, const Physics& physics) const = 0;
  };

  template <Backend B>
  class Of final : public Any {
   public:
    explicit Of(typename B::Params own) : params(std::move(own)) {}
    [[nodiscard]] std::unique_ptr<Any> copy() const override { return std::make_unique<Of>(*this); }
    [[nodiscard]] std::unique_ptr<Any> fresh() const override { return std::make_unique<Of>(typename B::Params{}); }
    [[nodiscard]] std::string_view name() const override { return B::name; }
    [[nodiscard]] std::string version() const override { return B::version(); }
    [[nodiscard]] std::vector<std::string> remarks(const Physics& physics) const override { return B::remarks(physics); }
    [[nodiscard]] std::string prescribe(Physics& physics, const Physics& table) const override {
      if constexpr (requires { params.prescribe(physics, table); }) return params.prescribe(physics, table);
      return {};
    }
    [[nodiscard]] bool has_joints() const override { return JointDriven<B>; }
    [[nodiscard]] bool can_embody() const override { return Embodying<B>; }
    [[nodiscard]] bool can_place() const override { return Placing<B>; }
    [[nodiscard]] std::size_t* threads() override {
      if constexpr (requires { params.threads; }) return &params.threads;
      return nullptr;
    }
    void validate(std::string_view path) const override { trophic::validate(params, path); }
    void append_param_refs(std::string_view path, ParamRefs& refs) override { detail::append_param_refs(params, path, refs); }
    [[nodiscard]] std::unique_ptr<AnyBackend> build(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts,
                                                    const Physics& physics) const override {
      return std::make_unique<BackendOf<B>>(robot, arena, starts, physics, params);
    }

    typename B::Params params;
  };

  std::unique_ptr<Any> choice_;
};

template <class Params>
requires requires {
  typename Params::Backend;
}
BackendChoice::BackendChoice(Params params) {
  constexpr bool is_backend = Backend<typename Params::Backend>;
  static_assert(is_backend,
                "the backend that these Params name needs name, version(), remarks(const Physics&), Params that name it and list "
                "their fields(), a State that can be saved, a constructor from (const RobotModel&, const Arena&, std::span<const "
                "Pose>, const Physics&, const Params&), advance_to, robots, time_s, pose, joint_angles, save and restore; see "
                "trophic/backend/contract.hpp");
  if constexpr (is_backend) choice_ = std::make_unique<Of<typename Params::Backend>>(std::move(params));
}

}  // namespace trophic
