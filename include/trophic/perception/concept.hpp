// SPDX-License-Identifier: MIT
// The contracts of perception rules: who sees whom, what the brain is told, when a tag may change.
#pragma once

#include <concepts>
#include <optional>
#include <trophic/individual.hpp>
#include <trophic/rng.hpp>
#include <trophic/view.hpp>

namespace trophic::perception {

/// An individual's adversary: the closest opponent that it perceives (Sec. "Inputs").
struct Sighting {
  BodyIndex self = 0;
  BodyIndex adversary = 0;
  double distance_m = 0.0;
  double bearing_rad = 0.0;  ///< 0 ahead, positive to the right, in [-pi, pi)
};

/// What the cognitive brain is told, each in [-1, 1] (Sec. "Inputs").
struct BrainInputs {
  double angle = 0.0;
  double distance = 0.0;
  double tag_ratio = 0.0;
  friend bool operator==(const BrainInputs&, const BrainInputs&) = default;
};

/// `heading_rad(root, forward_rad)`: which way a robot faces on the floor, counter-clockwise from x, given its root frame and the
/// direction of its forward axis in that frame. Left and right of a robot refer to it.
template <class P>
concept Heading = requires(const P policy, const Pose& root, double forward_rad) {
  { policy.heading_rad(root, forward_rad) } -> std::same_as<double>;
};

/// `perceives(self, other)`: whether self can perceive other, whatever the distance. Species are checked elsewhere.
template <class P>
concept Visibility = requires(const P policy, const Individual& self, const Individual& other) {
  { policy.perceives(self, other) } -> std::same_as<bool>;
};

/// `input(sighting, view)`: one of the inputs that describe the adversary.
template <class P>
concept SightingInput = requires(const P policy, const Sighting& sighting, const View& view) {
  { policy.input(sighting, view) } -> std::same_as<double>;
};

/// `input(view)`: the input that describes the population.
template <class P>
concept PopulationInput = requires(const P policy, const View& view) {
  { policy.input(view) } -> std::same_as<double>;
};

/// `inputs(tag_ratio)`: what the brain is told when no adversary is perceivable; nothing: the brain is not run and its last
/// decision stays.
template <class P>
concept BlindRule = requires(const P policy, double tag_ratio) {
  { policy.inputs(tag_ratio) } -> std::same_as<std::optional<BrainInputs>>;
};

/// `may_switch(self, view)`: whether self's tag may change at this tick; `restarts(switched)`: whether its tag clock then starts
/// again, asked after the brain has chosen another tag (true) or the same (false).
template <class P>
concept TagSwitch = requires(const P policy, const Individual& self, const View& view, bool switched) {
  { policy.may_switch(self, view) } -> std::same_as<bool>;
  { policy.restarts(switched) } -> std::same_as<bool>;
};

/// `tag(body_tag, rng)`: the tag, one of the brain's, of an individual at birth; body_tag is that of the body's last owner, none
/// for a founder.
template <class P>
concept NewbornTag = requires(const P policy, std::optional<int> body_tag, Rng& rng) {
  { policy.tag(body_tag, rng) } -> std::same_as<int>;
};

}  // namespace trophic::perception
