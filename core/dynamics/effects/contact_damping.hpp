#pragma once

#include "dynamics/effect.hpp"
#include "scene/user_laws.hpp"

#include <algorithm>
#include <array>
#include <string_view>

/// Effect "contact damping" (contact_damping.cpp has the law), and how the effects whose normal
/// forces may be another's ask for it.
namespace adore::dynamics {

/// Hunt and Crossley's law where a routine of the user could stand (user_forces.hpp).
class DampedForce final : public scene::UserForce {
 public:
  void set(double d) noexcept { d_ = d; }
  bool forces(double, const Contacts& c) noexcept override {
    for (std::size_t k = 0; k < c.n; ++k)
      c.force[k] = c.built_in[k] * std::max(1.0 - d_ * c.gap_rate[k], 0.0);
    return true;
  }

 private:
  double d_ = 0.0;  ///< [s/m]
};

class ContactDamping final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  /// Of pockets, guide lands and flanges, and what it takes of them all now [W].
  [[nodiscard]] scene::UserForce& law() noexcept { return law_; }
  [[nodiscard]] double& heat_beside_races() noexcept { return heat_beside_races_; }

 private:
  DampedForce law_;
  std::array<double, 2> heat_{};  ///< on races now [W]
  double heat_beside_races_ = 0.0;
};

/// What makes the normal forces of a kind of contact beside the built-in law.
struct OtherForce {
  scene::UserForce* routine = nullptr;  ///< null: nothing
  double* elsewhere = nullptr;  ///< takes its power along the normal, an item of its own in the
                                ///< ledger (damping); null: heat of the kind of contact [W]
  bool of_user = false;
  std::string_view cost;  ///< where the cost ledger books it
};
/// A routine of the user, or else damping.
/// @param user routine of the user, or null; cost: of such a routine
[[nodiscard]] OtherForce other_force(const SceneBuilder& scene, scene::UserForce* user,
                                     std::string_view cost);

}  // namespace adore::dynamics
