#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/rigid_body.hpp"
#include "dynamics/state_access.hpp"

#include <fmt/format.h>

/// Orientation of the balls that something reads: a perfect sphere moves without it.
namespace adore::dynamics {
namespace {

struct OrientedElement {
  std::size_t element = 0;  ///< 0-based
  double azimuth = 0.0;     ///< at the start [rad]
  Slice orientation;        ///< quaternion, body -> base
  Slice rotation;           ///< ∫ ω·(body x axis) dt
};

class OrientationMotion final : public EffectBlock {
 public:
  explicit OrientationMotion(const std::vector<OrientedElement>& elements) : elements_(elements) {}
  void apply(Evaluation& e) noexcept override;

 private:
  const std::vector<OrientedElement>& elements_;
};

/// q̇ = ½ (0, ω) ⊗ q with ω on the base frame, and ω·(body x axis), for q of any length.
void OrientationMotion::apply(Evaluation& e) noexcept {
  for (const OrientedElement& element : elements_) {
    const Quat q = quaternion_at(e.y, element.orientation);
    const Vec3 omega = e.element_omega(element.element), half = 0.5 * omega;
    store_at(e.dydt, element.orientation, multiply({0.0, half[0], half[1], half[2]}, q));
    const double w = q[0] * q[0], x = q[1] * q[1], y = q[2] * q[2], z = q[3] * q[3];
    e.dydt[element.rotation.first] =
        (omega[0] * (w + x - y - z) + 2.0 * omega[1] * (q[1] * q[2] + q[0] * q[3]) +
         2.0 * omega[2] * (q[1] * q[3] - q[0] * q[2])) /
        (w + x + y + z);
  }
}

class BallOrientation final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    for (const int index : scene.plan.oriented_elements) {
      demand(index >= 0 && index < scene.bearing.element_count(),
             "the orientation of an element is to be computed, but this element does not exist");
      const std::string name = fmt::format("element{}", index + 1);
      const auto i = static_cast<std::size_t>(index);
      elements_.push_back({i, scene.statics.balls[i].azimuth,
                           scene.quaternion(name + ".quaternion", index),
                           scene.state(name + ".rotation", "rad", 1, ScaleKind::Angle, index)});
    }
    if (!elements_.empty())
      scene.block<OrientationMotion>(Phase::Motion, "orientation of elements", {}, elements_);
  }

  void start(std::span<double> y) const override {
    for (const OrientedElement& one : elements_)  // body axes start along the azimuth frame
      store_at(y.data(), one.orientation, quaternion_about(Vec3::UnitX(), one.azimuth));
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (const OrientedElement& one : elements_) {
      ElementSnapshot& ball = snapshot.elements[one.element];
      ball.oriented = true;
      ball.orientation = quaternion_at(e.y, one.orientation);
      ball.total_rotation = e.y[one.rotation.first];
      const Vec3 axis = e.to_cylindrical(
          one.element, rotation_matrix(normalize_quaternion(ball.orientation)).col(0));
      ball.x_axis = Vec3(axis[0], -axis[2], axis[1]);
    }
  }

 private:
  std::vector<OrientedElement> elements_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_ball_orientation(const ScenePlan& plan) {
  if (!plan.has(Effect::ElementOrientation) || plan.rollers || plan.rigid_balls) return nullptr;
  return std::make_unique<BallOrientation>();
}

}  // namespace adore::dynamics
