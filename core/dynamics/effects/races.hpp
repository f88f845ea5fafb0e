#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/effects/kept_elements.hpp"
#include "dynamics/effects/race_account.hpp"
#include "dynamics/effects/roller_races.hpp"
#include "dynamics/normal_contacts.hpp"

#include <optional>
#include <span>

/// Both races: bodies that are prescribed unless an effect integrates them, and the contacts of the
/// elements with them (effects "race contact" and "race traction"). Not valid when an element is
/// pressed into a race by more than its radius.
namespace adore::dynamics {

/// Contacts of balls with a split race. Evaluation::load, heat and load_slip are those of the half
/// that carries more of the ball, these of the other one.
struct OtherHalfLoads {
  std::vector<double> load, heat, load_slip;
  std::vector<char> swapped;  ///< the second half carries more
};

class Races final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  void prescribe(double t, PrescribedRaces& races) const override;
  void go_on(const PrescribedRaces& before, const PrescribedRaces& now,
             std::span<double> y) override;
  [[nodiscard]] double stiffness(double force) const override;
  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;
  void look(const Evaluation& e, Look& out) const override;
  /// A contact whose rolling speed u passes zero while it slides loses its film (h ~ u^0.67) where
  /// |u| is below some u_c. Its friction rises there from that of the film to that of metal (0.002
  /// to 0.06 in 240 K cold oil), and can hold the element at that speed for a long time. u_c is
  /// found from the film now and that exponent.
  [[nodiscard]] double speed_to_resolve(const Evaluation& e, double near) const override;
  [[nodiscard]] std::string approximation_note() const override { return approximation_note_; }
  void add_quadrature_error(const Evaluation& e, scene::QuadratureError& error) const override;
  [[nodiscard]] bool has_stiff_part() const noexcept override {
    return normal_contacts_.has_value();
  }
  bool stiff_part(const Evaluation& e, const double* y, double* dydt, int size) noexcept override {
    return normal_contacts_->evaluate(e.race, y, dydt, size);
  }

  /// Of balls.
  [[nodiscard]] const std::array<RaceContactModel, 2>& contacts() const noexcept {
    return contacts_;
  }
  /// Of the second half of split races, whose first is in contacts(); empty: no race is split.
  [[nodiscard]] const std::array<std::optional<RaceContactModel>, 2>& second() const noexcept {
    return second_half_model_;
  }
  [[nodiscard]] std::array<std::array<contact::SplitRaceHalf, 2>, 2> halves() const noexcept;
  /// Loads of second contacts at this evaluation; empty: the race is not split.
  [[nodiscard]] std::span<const double> other_half_loads(std::size_t j) const noexcept {
    return other_half_loads_[j].load;
  }
  /// Of rollers; null: the elements are balls.
  [[nodiscard]] const std::array<RollerRaceModel, 2>* roller_contacts() const noexcept {
    return rollers_ ? &*rollers_ : nullptr;
  }
  /// Of the oil on balls, where the scene has it.
  [[nodiscard]] const std::array<tribology::RollingResistance, 2>& rolling() const noexcept {
    return rolling_resistance_;
  }
  /// Sums over all elements of race j at this evaluation.
  [[nodiscard]] const RaceContactTotals& account(std::size_t j) const noexcept {
    return contact_totals_[j];
  }
  /// For the effect that moves that race.
  [[nodiscard]] RaceContactTotals& account(std::size_t j) noexcept { return contact_totals_[j]; }
  /// Places of the race centres in the unloaded bearing [m].
  [[nodiscard]] const std::array<Vec3, 2>& unloaded_race_centers() const noexcept {
    return unloaded_race_centers_;
  }
  /// Both at t = 0: static place, misalignment and spin.
  [[nodiscard]] const std::array<RaceBody, 2>& initial_races() const noexcept {
    return initial_races_;
  }

 private:
  void place(const SceneBuilder& scene, const std::array<double, 2>& centre_x);
  void set_up_balls(const SceneBuilder& scene);
  void declare_contacts(SceneBuilder& scene);
  /// @param load_slip it is wanted
  void declare_contact(SceneBuilder& scene, std::size_t j, bool load_slip);
  /// Of race j to slip_.
  void sample_slips(const Evaluation& e, std::size_t j) const noexcept;
  /// @param second the contact with the other half of a split race
  [[nodiscard]] RaceContactSnapshot detail(const Evaluation& e, std::size_t j, std::size_t i,
                                           bool second = false) const;
  /// Films, temperatures and rise of a contact that detail() has found.
  void complete(RaceContactSnapshot& contact, std::size_t j, bool in_oil) const;
  /// Contact of ball i with race j, of split ones with the half that carries more; `other`: less.
  [[nodiscard]] const RaceContactModel& model_of(std::size_t j, std::size_t i,
                                                 bool other = false) const noexcept;

  /// Whose numbers wavy grooves read; null: no routine ADRX6.
  std::array<std::shared_ptr<const bearing::SurfaceSeries>, 2> user_race_surfaces_;
  std::array<RaceContactModel, 2> contacts_;  ///< of balls
  std::array<std::optional<RaceContactModel>, 2>
      second_half_model_;                           ///< other halves of split races
  std::array<OtherHalfLoads, 2> other_half_loads_;  ///< of split races, as evaluated last
  std::array<tribology::RollingResistance, 2> rolling_resistance_;  ///< likewise
  std::optional<std::array<RollerRaceModel, 2>> rollers_;           ///< else
  std::array<std::optional<RollersOnRace>, 2> rollers_on_race_;  ///< of rollers, as evaluated last
  mutable std::array<std::optional<RollerRaceReport>, 2> roller_report_;  ///< likewise
  std::array<std::vector<double>, 2> fastest_;               ///< likewise, by roller [m²/s²]
  LastElementStates kept_;                                   ///< of balls, likewise
  mutable std::vector<double> slip_, other_slip_, scratch_;  ///< of look()
  std::array<Vec3, 2> unloaded_race_centers_;  ///< free positions of the race centres [m]
  std::array<RaceBody, 2> initial_races_;      ///< at t = 0: they stand still but for their spin
  /// Turn of prescribed races beyond speed times time: of earlier speeds [rad].
  std::array<double, 2> prior_rotation_{};
  std::string approximation_note_;  ///< of the outer race's films
  std::array<double, 2> temperature_{}, roughness_{};
  std::array<bearing::Material, 3> material_;  ///< of races and elements
  bool has_race_contact_ = false;
  bool has_rolling_resistance_ = false;            ///< in oil that resists
  bool has_contact_sums_ = false;                  ///< of each contact, by the right-hand side
  std::optional<NormalContacts> normal_contacts_;  ///< with race contact of balls
  std::array<RaceContactTotals, 2> contact_totals_;
  std::array<int, 2> load_slip_index_{-1, -1}, load_slip_element1_index_{-1, -1};  ///< in the state
};

}  // namespace adore::dynamics
