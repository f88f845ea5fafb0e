#pragma once

#include "contact/conformal.hpp"
#include "dynamics/bodies.hpp"
#include "dynamics/system.hpp"
#include "tribology/traction_law.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

/// Additional loads of reference cases on the scene of a System, and their access to it after an
/// evaluation: the only way from outside of the dynamics to Evaluation. SI, base axes.
namespace adore::dynamics {

struct Evaluation;
class PocketContact;

/// Both races, where the elements are balls.
using RaceModels = std::array<RaceContactModel, 2>;

/// Acts in a scene: `act` in the phase of the forces, behind the effects of the catalogue,
/// `account` once all forces are known; `books` are integrals of powers that they leave [J].
struct CustomSceneAction {
  using Act = std::function<void(Evaluation&, const RaceModels&)>;
  struct PowerIntegral {
    std::string name;
    const double* rate;
  };
  Act act, account;
  std::vector<PowerIntegral> books;
};
[[nodiscard]] EffectMaker make_action_effect(CustomSceneAction action);

/// Inside of a System, which outlives it.
struct SceneView {
  Evaluation* e = nullptr;
  const RaceModels* races = nullptr;
  PocketContact* pockets = nullptr;  ///< null: no pockets
  /// Of element 0 in its pocket, from the last evaluation [m]; identical round pockets.
  [[nodiscard]] double pocket_gap() const noexcept;
  /// Into the wall where it is nearest.
  [[nodiscard]] Vec3 pocket_normal() const noexcept;
};
/// Fills the view when the System is made.
[[nodiscard]] EffectMaker make_view_effect(SceneView& view);

/// An element against a wall of a body (effects/pockets.hpp).
struct WallContact {
  double N = 0.0, rate = 0.0, heat = 0.0;         ///< normal force, of approach [N, m/s, W]
  Vec3 arm = Vec3::Zero(), point = Vec3::Zero();  ///< element center -> contact; contact [m]
  Vec3 on_element = Vec3::Zero(), friction = Vec3::Zero();  ///< whole force, its friction part [N]
};
/// @param m unit vector into the wall; overlap along it [m]
[[nodiscard]] WallContact wall_contact(const Evaluation& e, std::size_t element,
                                       const BodyState& body, const Vec3& m, double radius,
                                       const contact::CappedHertz& normal, double overlap,
                                       const tribology::TractionLaw& law) noexcept;
/// Adds it to what acts on the element.
void apply(Evaluation& e, std::size_t element, const WallContact& contact) noexcept;

}  // namespace adore::dynamics
