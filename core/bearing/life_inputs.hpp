#pragma once

#include "bearing/grade_oil.hpp"

#include <array>
#include <optional>

/// Data of a deck and the run options on fatigue life. An empty value means "not given": the
/// life library then takes its constant and prints the origin.
namespace adore::bearing {

/// One stress-capacity model on one component (records 8.6.1 to 8.6.3).
struct LifeModelInput {
  std::optional<double> factor;           ///< multiplies the dynamic stress capacity (a pressure)
  std::optional<double> stress_exponent;  ///< hazard exponent; Gupta-Zaretsky: life exponent
  std::optional<double> depth_exponent;   ///< not part of Gupta-Zaretsky
};

/// Outer race, inner race or the set of rolling elements.
struct LifeComponentInput {
  std::optional<double> original_factor;  ///< fco, multiplies the load capacity; races only
  LifeModelInput updated, zaretsky, harris;
  std::optional<double> weibull_slope;
  // Records 8.6.4 to 8.6.6; empty: by the material's code.
  std::optional<double> stle_material, stle_process, stle_hardness;
  std::optional<double> tallian_material, tallian_process, tallian_contamination;
  std::optional<double> asperity_slope;     ///< composite rms slope [rad]; races only
  std::optional<double> asperity_traction;  ///< [-]; races only
  double residual_stress = 0.0;             ///< [Pa], tension positive; races only
};

enum LifePart : int { kOuterRacePart = 0, kInnerRacePart = 1, kElementPart = 2 };

/// Which rolling elements count in the life of the bearing.
enum class ElementLife : unsigned char {
  Zaretsky,  ///< in Gupta-Zaretsky only, and not when they are ceramic
  All,       ///< in every model that has them, ceramic too
  None
};
enum class LimitForm : unsigned char {
  Peak,     ///< largest von Mises stress below each contact minus the limit
  Integral  ///< depth integral of the orthogonal shear amplitude above its limit
};

enum class LifeModel : unsigned char { Original, Updated, Zaretsky, Harris };
enum class LifeModification : unsigned char { None, Stle, Tallian };

/// Run options of the life models: what no record holds.
/// Ratings that the maker of a bearing publishes (record X1) [N, -]. Empty: the estimate of
/// ISO 281 and ISO 76.
struct MakerRatings {
  std::optional<double> C, C0, C_u, e, X, Y;
};

struct LifeChoices {
  /// The life that SOL7, terminal and sweeps show (decision 145).
  LifeModel stored_model = LifeModel::Original;
  LifeModification stored_modification = LifeModification::None;
  ElementLife elements = ElementLife::Zaretsky;
  bool shared_track = false;  ///< both races stress the same volume of a rolling element
  LimitForm limit_form = LimitForm::Peak;
  std::optional<double> film_parameter;   ///< Λ assumed at every contact; empty: no film known
  std::optional<double> filter;           ///< filter rating [µm] at beta 200; empty: no factor
  std::optional<double> viscosity_ratio;  ///< κ of ISO 281
  std::optional<double> contamination;    ///< e_C of ISO 281
  MakerRatings ratings;
  std::optional<OilByGrade> oil;  ///< record X2
  double skip_turns = 0.0;        ///< shaft turns left out at the start of the run life
};

struct LifeInputs {
  std::array<LifeComponentInput, 3> part;  ///< indexed by LifePart
  std::optional<double> survival;          ///< sProb
  std::optional<double> bearing_slope;     ///< brgWbDis
  std::optional<double> race_limit;        ///< ratingVM, von Mises fatigue limit of the races [Pa]
  double limit_factor = 1.0;  ///< facStrLimit, multiplies the fatigue limit of each material
  LifeChoices choices;
};

}  // namespace adore::bearing
