#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "bearing/life_inputs.hpp"
#include "life/constants.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// The parameters that the life models of one bearing work with: the deck's where it gives them,
/// else the program's, each with its origin. Index: bearing::LifePart.
namespace adore::life {

struct ModelParameters {
  SourcedValue factor;  ///< of the stress capacity
  SourcedValue
      stress_exponent;          ///< as on the record: hazard exponent, Gupta-Zaretsky life exponent
  SourcedValue depth_exponent;  ///< 0 for Gupta-Zaretsky
};

struct PartParameters {
  std::string name;                      ///< "outer race"
  std::string material;                  ///< its name
  SourcedValue original_factor;          ///< races
  std::array<ModelParameters, 3> model;  ///< updated, Zaretsky, Harris
  SourcedValue slope;                    ///< of balls, or of rollers that count as lines
  SourcedValue point_slope;              ///< point contact or not
  SourcedValue fatigue_limit;            ///< von Mises, with facStrLimit [Pa]; 0: no limit known
  double poisson_ratio = 0.3;
  double elastic_modulus = 0.0;  ///< behind the pressures [Pa]
  double temperature = 0.0;      ///< of the part; 0: not said [K]
  // Modification factors.
  SourcedValue stle_material, stle_process, stle_hardness;
  SourcedValue tallian_material, tallian_process, tallian_contamination;
  SourcedValue asperity_slope, asperity_traction;  ///< races
  double residual_stress = 0.0;                    ///< tension positive [Pa]
};

struct LifeParameters {
  bool line = false;
  std::array<PartParameters, 3> part;
  SourcedValue survival, bearing_slope, point_bearing_slope;
  double limit_factor = 1.0;
  bool ceramic_elements = false;
  bool modulus_follows_temperature = false;  ///< material laws on (kMatPropMod = 1)
  bearing::LifeChoices choices;
  std::vector<Finding>
      notes;  ///< life.stle, life.fatigue_limit ...: assumptions for unknown values
};

/// @param element, race materials; code 1 is the deck's own
/// @throws InputError naming a value that no model can work with.
[[nodiscard]] LifeParameters life_parameters(const bearing::LifeInputs& inputs, bool line,
                                             const bearing::Material& element,
                                             const std::array<bearing::Material, 2>& race);

/// Does the element life count in the bearing's life of this model?
[[nodiscard]] bool includes_element_life(const LifeParameters& parameters,
                                         bearing::LifeModel model);

}  // namespace adore::life
