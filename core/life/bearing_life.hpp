#pragma once

#include "base/finding.hpp"
#include "life/contact_shape.hpp"
#include "life/contacts.hpp"
#include "life/factors.hpp"
#include "life/iso16281.hpp"
#include "life/parameters.hpp"
#include "life/stress_life.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Fatigue life of one bearing by all models, from its contacts. Lives in 1e6 revolutions of one
/// ring relative to the other; infinity where nothing is damaged.
namespace adore::life {

using bearing::LifeModification;

inline constexpr std::size_t kModels = 4;         ///< LifeModel: original, updated, GZ, IH
inline constexpr std::size_t kModifications = 3;  ///< LifeModification: none, STLE, Tallian-type

/// Lives of the parts at 90 % survival and of the bearing.
struct PartLives {
  std::array<double, 3> part{};  ///< LifePart; elements NaN where the model has none
  double L10 = 0.0;              ///< bearing at 90 %
  double L_S = 0.0;              ///< bearing at the deck's survival probability
  bool elements_counted = false;
};
struct ModelLives {
  std::array<bool, 2> line{};  ///< by race: counted as a line contact, not as a point
  std::array<PartLives, kModifications> modified;  ///< [0] basic
};
struct ModificationFactors {
  std::array<double, 3> stle{1.0, 1.0, 1.0};
  std::array<double, 3> film{1.0, 1.0, 1.0}, residual{1.0, 1.0, 1.0}, hazard{1.0, 1.0, 1.0};
  std::array<double, 3> asperity{1.0, 1.0, 1.0};
  std::array<double, 3> tallian{1.0, 1.0, 1.0};  ///< φ^(-1/e)
  double filter = 1.0;
  std::array<std::optional<double>, 3> film_parameter;  ///< Λ of races and elements; empty: unknown
  bool thin_film = false;
  std::array<bool, 2>
      residual_refused{};  ///< the residual stress is outside the range of its formula
};
/// Everything that changes with the loads.
struct LifeState {
  std::array<ModelLives, kModels> model;
  ModificationFactors factors;
  double relative_speed = 0.0;          ///< [rad/s]
  std::array<ContactShape, 2> shape{};  ///< by race
  std::array<double, 2> major_axis{};   ///< 2a of the heaviest roller's ellipse; 0: none [m]
  [[nodiscard]] const PartLives& of(LifeModel m, LifeModification f) const {
    return model[static_cast<std::size_t>(m)].modified[static_cast<std::size_t>(f)];
  }
};

/// Per race, for the print.
struct RaceReport {
  double angle = 0.0, gamma = 0.0;  ///< [rad, -]
  bool rotating = true;
  double Q_c = 0.0, Q_e = 0.0, Q_max = 0.0;  ///< LP capacity, equivalent and largest load [N]
  double p_max = 0.0;                        ///< [Pa]
  PeakStressRatios peaks;                    ///< below the heaviest contact
  std::array<double, 3> stress_capacity{};   ///< p_c: updated, GZ, IH [Pa]; NaN without load
  double major_axis =
      0.0;            ///< 2a that the heaviest roller's ellipse has or would have; NaN: none [m]
  bool line = false;  ///< all of these as a line contact; between line and point: the one that the
                      ///< original theory counts
};

struct IsoReport {
  IsoGeometry geometry;
  double C = 0.0;
  std::optional<double> C0, C_u;  ///< in use: the maker's where they are given
  bearing::MakerRatings maker;    ///< record X1
  double C_estimate = 0.0;
  std::optional<double> C0_estimate, C_u_estimate;
  std::string oil;                                      ///< of record X2; empty without it
  double oil_temperature = 0.0;                         ///< [K]
  std::optional<double> viscosity, required_viscosity;  ///< ν, ν1 [m²/s]
  double radial = 0.0, axial = 0.0;                     ///< [N]
  std::optional<EquivalentLoad> equivalent;
  std::optional<double> L10;  ///< [1e6 rev]
  double a1 = 1.0;
  std::string kappa_origin;                                 ///< "option", "oil", "film"
  std::optional<double> kappa, contamination, a_iso, L_nm;  ///< L_nm = a1 a_ISO L10
  bool outside = false;                                     ///< κ < 0.1
  std::optional<ReferenceLife> reference;                   ///< ISO 16281
  std::optional<double> L_nmr;
  std::vector<Finding> notes;
};

struct BearingLife {
  LifeState state;
  LifeParameters parameters;
  double effective_length = 0.0;  ///< of rollers; 0: balls [m]
  std::array<RaceReport, 2> race;
  std::array<std::array<double, 3>, 3> pressure_exponent{};  ///< [model - 1][part]
  std::optional<IsoReport> iso;
  std::vector<Finding> notes;
};

/// All models of one bearing, calibrated once; evaluated for any set of contacts.
class LifeCalculator {
 public:
  /// @throws InputError
  LifeCalculator(const LifeGeometry& geometry, LifeParameters parameters);

  /// About a µs per contact and model once its ellipticity is known. @param only this model; the
  /// lives of the others stay NaN
  [[nodiscard]] LifeState evaluate(const BearingContacts& contacts,
                                   const std::optional<LifeModel>& only = std::nullopt);
  /// The same with everything that is printed, but ISO.
  [[nodiscard]] BearingLife report(const BearingContacts& contacts);
  [[nodiscard]] const LifeParameters& parameters() const noexcept { return parameters_; }

 private:
  /// Contacts of one race, taken as lines or as points.
  struct Contacts {
    const std::vector<ContactPatch>& patches;
    std::size_t slices;
    bool line;
  };
  [[nodiscard]] double gamma(double angle) const;
  [[nodiscard]] Contacts contacts_by_shape(const BearingContacts& contacts, std::size_t race,
                                           bool line) const;
  [[nodiscard]] const StressLife& law(std::size_t model, std::size_t part, bool line) const;
  [[nodiscard]] double slope(std::size_t part, bool line) const;
  void set_shapes(const BearingContacts& contacts, LifeState& out) const;
  [[nodiscard]] double capacity(const RaceContacts& race, std::size_t index, double length,
                                bool line) const;
  [[nodiscard]] double lundberg_palmgren_race_life(const BearingContacts& contacts,
                                                   std::size_t race, bool line) const;
  [[nodiscard]] double stress_race_life(const BearingContacts& contacts, std::size_t race,
                                        std::size_t model, bool line);
  /// Of the race by its shape; sets whether that took it as a line. @param model 0: original
  [[nodiscard]] double race_life_for_shape(const BearingContacts& contacts, std::size_t race,
                                           std::size_t model, ContactShape shape, bool& line);
  [[nodiscard]] double element_life(const BearingContacts& contacts, std::size_t model,
                                    const std::array<bool, 2>& line);
  [[nodiscard]] ModificationFactors factors(const BearingContacts& contacts,
                                            const std::array<bool, 2>& line);

  LifeGeometry geometry_;
  LifeParameters parameters_;
  std::vector<StressLife> models_;  ///< [point, line][model - 1][part]; no lines for balls
  PeakStressCache peak_stress_cache_;
};

/// ISO companions; of a roller bearing from its slices as laminae (without them no ISO 16281 life).
/// @param load what the shaft applies: x, y, z [N]
[[nodiscard]] IsoReport iso_report(const bearing::Bearing& bearing, const BearingContacts& contacts,
                                   const std::array<double, 3>& load,
                                   const LifeParameters& parameters);

/// Quasi-static life of a roller bearing in operation; each race as lines or points by
/// contact_shape.
[[nodiscard]] BearingLife roller_bearing_life(const bearing::Bearing& bearing,
                                              const bearing::LifeInputs& inputs,
                                              const statics::RollerSolution& solution);

/// Quasi-static life of a ball bearing.
[[nodiscard]] BearingLife ball_bearing_life(const bearing::Bearing& bearing,
                                            const bearing::LifeInputs& inputs,
                                            const statics::StaticSolution& solution);

}  // namespace adore::life
