#pragma once

#include "contact/race_errors.hpp"
#include "contact/roller_race.hpp"
#include "dynamics/element_masses.hpp"
#include "dynamics/held_contacts.hpp"
#include "dynamics/roller_springs.hpp"
#include "statics/roller_model.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// Contacts of held rollers. Springs are exact: U(x', r', t, f) of each race with its flanges has a
/// gradient g and a Hessian H (statics/slice_potential.hpp); under a velocity v of the middle C and
/// ω of the roller, both relative to the race, with the axes (A, y', e) of statics/roller_pose.hpp,
///   ẋ' = v·A,  ṙ' = v·e,  ė = (v·y'/r') y',  ȧ = ω × a,  ṫ = ȧ·e + a·ė,  ḟ = ȧ·y' + a·ẏ',
///   ġ = H ṗ,  Ḟ = -(ġ_x A + ġ_r e + g_r ė + ṡ y' + s ẏ'),  s = (g_t f - g_f t)/r'   [derived].
/// Limit: the springs exclude the changes of a race with errors as it turns, and the curvature of
/// the gap of a flange (1/R of its contact against 1.5/δ): this affects only the way to balance.
namespace adore::dynamics {

class QuasiStaticRollers final : public QuasiStaticContacts {
 public:
  QuasiStaticRollers(
      statics::RollerModel model, const bearing::Imperfections& errors, ElementMasses masses,
      std::span<const std::shared_ptr<const bearing::SurfaceSeries>> out_of_round = {});

  void springs(const Evaluation& e, std::span<const std::size_t> held,
               std::span<ContactLinearization> out) noexcept override;
  [[nodiscard]] QuasiStaticPosition balanced(const Evaluation& e, std::size_t i,
                                             const Vec2& force) const override;
  [[nodiscard]] Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept override;
  /// About that of balls.
  [[nodiscard]] double max_free_displacement() const noexcept override {
    return 4e-4 * model_.rollers.diameter;
  }

 private:
  struct Contact;
  [[nodiscard]] Contact contact(const Evaluation& e, std::size_t i, std::size_t j,
                                const Vec3& centre) const noexcept;

  statics::RollerModel model_;
  /// By race, one for all rollers or one by roller.
  std::array<std::vector<contact::RollerRaceSlices>, 2> slices_;
  RollerSpringsKernel kernel_;
  std::array<std::optional<contact::WavyRace>, 2> wavy_;
  std::array<std::shared_ptr<const bearing::SurfaceSeries>, 2> surface_;  ///< tables in their place
  std::array<double, 2> max_approach_offset_{};  ///< contact::nearest of them
  std::array<std::vector<std::optional<contact::WavyRace>>, 2> lobes_;  ///< by roller, or none
  ElementMasses masses_;
};

}  // namespace adore::dynamics
