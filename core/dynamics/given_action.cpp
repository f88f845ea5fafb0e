#include "dynamics/given_action.hpp"

#include "dynamics/effects/pockets.hpp"
#include "dynamics/effects/races.hpp"

#include <memory>
#include <utility>

namespace adore::dynamics {
namespace {

class Acting final : public EffectBlock {
 public:
  Acting(const CustomSceneAction::Act& act, const RaceModels& races) : act_(act), races_(races) {}
  void apply(Evaluation& e) noexcept override { act_(e, races_); }

 private:
  const CustomSceneAction::Act& act_;
  const RaceModels& races_;
};

class GivenEffect final : public SceneEffect {
 public:
  explicit GivenEffect(CustomSceneAction action) : action_(std::move(action)) {}
  void declare(SceneBuilder& scene) override {
    const RaceModels& races = scene.find<Races>()->contacts();
    if (action_.act) scene.block<Acting>(Phase::Force, "given", {}, action_.act, races);
    if (action_.account) scene.block<Acting>(Phase::Account, "given", {}, action_.account, races);
    for (const CustomSceneAction::PowerIntegral& book : action_.books)
      scene.integral(unused_, book.name, "J", book.rate);
  }

 private:
  CustomSceneAction action_;
  int unused_ = -1;
};

class View final : public SceneEffect {
 public:
  explicit View(SceneView& view) : view_(view) {}
  void declare(SceneBuilder& scene) override {
    view_ = {&scene.e, &scene.find<Races>()->contacts(), scene.find<PocketContact>()};
  }

 private:
  SceneView& view_;
};

}  // namespace

EffectMaker make_action_effect(CustomSceneAction action) {
  auto shared = std::make_shared<CustomSceneAction>(std::move(action));
  return [shared](const ScenePlan&) { return std::make_unique<GivenEffect>(*shared); };
}

EffectMaker make_view_effect(SceneView& view) {
  return [&view](const ScenePlan&) { return std::make_unique<View>(view); };
}

double SceneView::pocket_gap() const noexcept { return pockets->set().wall_point(0).gap; }

Vec3 SceneView::pocket_normal() const noexcept {
  const PocketSet& set = pockets->set();
  return set.round_pocket_to_base(0, set.wall_point(0).m, set.body(*e, 0).to_base);
}

WallContact wall_contact(const Evaluation& e, std::size_t element, const BodyState& body,
                         const Vec3& m, double radius, const contact::CappedHertz& normal,
                         double overlap, const tribology::TractionLaw& law) noexcept {
  const PocketAction action = law.visit_regularized([&](const auto& friction) {
    return pocket_action(normal, {}, friction, e, element, body, radius, m, overlap);
  });
  return {action.N,     action.rate,    action.heat,    action.arm,
          action.point, action.on_ball, action.friction};
}

void apply(Evaluation& e, std::size_t element, const WallContact& contact) noexcept {
  e.add_force(element, e.to_cylindrical(element, contact.on_element));
  e.add_moment(element, e.to_cylindrical(element, contact.arm.cross(contact.friction)));
}

}  // namespace adore::dynamics
