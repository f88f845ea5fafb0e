#include "results/key_results.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>

namespace adore::results {
namespace {

constexpr KeyResultSpec kSpecs[] = {
    // Lives: by model as bearing::LifeModel counts, in each by bearing::LifeModification.
    {"life_lp_hours", "Life, original Lundberg-Palmgren", "", &unit::kLife},
    {"life_lp_stle_hours", "Life, original Lundberg-Palmgren with STLE factors", "", &unit::kLife},
    {"life_lp_tallian_hours", "Life, original Lundberg-Palmgren with Tallian-type factors", "",
     &unit::kLife},
    {"life_lpu_hours", "Life, updated Lundberg-Palmgren", "", &unit::kLife},
    {"life_lpu_stle_hours", "Life, updated Lundberg-Palmgren with STLE factors", "", &unit::kLife},
    {"life_lpu_tallian_hours", "Life, updated Lundberg-Palmgren with Tallian-type factors", "",
     &unit::kLife},
    {"life_gz_hours", "Life, Gupta-Zaretsky type", "", &unit::kLife},
    {"life_gz_stle_hours", "Life, Gupta-Zaretsky type with STLE factors", "", &unit::kLife},
    {"life_gz_tallian_hours", "Life, Gupta-Zaretsky type with Tallian-type factors", "",
     &unit::kLife},
    {"life_ih_hours", "Life, Ioannides-Harris type", "", &unit::kLife},
    {"life_ih_stle_hours", "Life, Ioannides-Harris type with STLE factors", "", &unit::kLife},
    {"life_ih_tallian_hours", "Life, Ioannides-Harris type with Tallian-type factors", "",
     &unit::kLife},
    {"life_iso281_hours", "Life, ISO 281", "", &unit::kLife},
    {"life_iso16281_hours", "Life, ISO/TS 16281", "", &unit::kLife},
    {"life_iso281_modified_hours", "Life, ISO 281 with a_ISO and a1", "", &unit::kLife},
    {"run_life_hours", "Life from the loads of the run", "", &unit::kLife},
    {"run_life_samples", "Life from the loads of the run", "number of samples", &unit::kNone},
    {"run_life_spread", "Life from the loads of the run", "relative standard error", &unit::kNone},
    {"life_stored_hours", "Life, with the life model of the plot files", "",
     &unit::kLife},  // of older tables

    // Of the equilibrium.
    {"displacement_x_m", "Displacement", "x", &unit::kLength},
    {"displacement_y_m", "Displacement", "y", &unit::kLength},
    {"displacement_z_m", "Displacement", "z", &unit::kLength},
    {"displacement_about_y_rad", "Displacement", "about y", &unit::kRadian},
    {"displacement_about_z_rad", "Displacement", "about z", &unit::kRadian},
    {"load_x_N", "Load", "x", &unit::kForce},
    {"load_y_N", "Load", "y", &unit::kForce},
    {"load_z_N", "Load", "z", &unit::kForce},
    {"load_about_y_Nm", "Load", "about y", &unit::kMoment},
    {"load_about_z_Nm", "Load", "about z", &unit::kMoment},
    {"largest_contact_load_N", "Largest contact load", "", &unit::kForce,
     "Largest contact load at the end"},  // the peak has a separate line
    {"least_element_load_N", "Least element load", "", &unit::kForce, "",
     "the smaller of the two race loads of the least loaded element; 0 if any element is unloaded"},
    {"largest_approach_m", "Largest approach", "", &unit::kLength, "",
     "largest elastic approach between an element and a race"},
    {"largest_pressure_Pa", "Largest pressure", "", &unit::kPressure},
    {"stiffness_x_N_per_m", "Stiffness", "x", &unit::kStiffness},
    {"stiffness_y_N_per_m", "Stiffness", "y", &unit::kStiffness},
    {"stiffness_z_N_per_m", "Stiffness", "z", &unit::kStiffness},
    {"stiffness_about_y_Nm_per_rad", "Stiffness", "about y", &unit::kRotationalStiffness},
    {"stiffness_about_z_Nm_per_rad", "Stiffness", "about z", &unit::kRotationalStiffness},
    {"set_offset_m", "Axial offset of the set", "", &unit::kLength, "",
     "axial gap between rows of opposite orientation, closed by clamping"},
    {"preload_unmounted_N", "Preload of the set", "unmounted", &unit::kForce, "",
     "preload at rest and room temperature, before mounting"},
    {"preload_N", "Preload of the set", "in operation", &unit::kForce, "",
     "preload with fits, temperatures and speed, but without external load"},
    {"unloading_force_plus_N", "Unloading force", "towards +x", &unit::kForce, "",
     "smallest axial force that unloads a row of an assembly"},
    {"unloading_force_minus_N", "Unloading force", "towards -x", &unit::kForce},
    {"gyroscopic_ratio", "Gyroscopic friction ratio", "", &unit::kNone, "",
     "friction coefficient that is needed to prevent gyroscopic pivoting (largest value of all "
     "balls), divided by the friction coefficient of the traction law (0.06 without a traction "
     "law); a ball pivots if this ratio is above 1"},
    {"viscosity_ratio", "Viscosity ratio kappa", "", &unit::kNone, "",
     "kinematic viscosity divided by the ISO 281 reference viscosity; for an oil specified by "
     "grade, at the bearing temperature; otherwise, at the contact inlet of the hotter race"},
    {"variable_compliance_m", "Variable compliance",
     "load between two elements minus load on an element", &unit::kLength, "",
     "displacement along the radial load if the load acts between two elements, minus the "
     "displacement if it acts on an element; computed only by \"adore find\""},
    {"variable_compliance_span_m", "Variable compliance", "peak to peak", &unit::kLength, "",
     "range of the displacement along the radial load while the elements move by one pitch (12 "
     "positions); computed only by \"adore find\""},
    {"friction_torque_Nm", "Friction torque", "", &unit::kMoment},
    {"friction_power_W", "Friction power", "", &unit::kPower},
    {"outer_race_temperature_K", "Temperature", "outer race", &unit::kTemperature},
    {"inner_race_temperature_K", "Temperature", "inner race", &unit::kTemperature},
    {"element_temperature_K", "Temperature", "rolling elements", &unit::kTemperature},
    {"coolant_exit_temperature_K", "Temperature", "coolant exit", &unit::kTemperature},
    {"operating_clearance_m", "Operating clearance", "", &unit::kLength},
    {"operating_contact_angle_rad", "Operating contact angle", "", &unit::kRadian},
    {"outer_fit_pressure_Pa", "Fit pressure", "outer", &unit::kPressure},
    {"inner_fit_pressure_Pa", "Fit pressure", "inner", &unit::kPressure},
    {"bpfo_nominal_Hz", "Nominal passing frequency", "outer race (BPFO)", &unit::kFrequency},
    {"bpfi_nominal_Hz", "Nominal passing frequency", "inner race (BPFI)", &unit::kFrequency},
    {"bsf_nominal_Hz", "Nominal passing frequency", "element spin (BSF)", &unit::kFrequency},
    {"ftf_nominal_Hz", "Nominal passing frequency", "cage (FTF)", &unit::kFrequency},
    {"bpfo_Hz", "Passing frequency", "outer race (BPFO)", &unit::kFrequency},
    {"bpfi_Hz", "Passing frequency", "inner race (BPFI)", &unit::kFrequency},
    {"bsf_Hz", "Passing frequency", "element spin (BSF)", &unit::kFrequency},
    {"ftf_Hz", "Passing frequency", "cage (FTF)", &unit::kFrequency},

    // Of a motion.
    {"time_s", "Time", "", &unit::kTime},
    {"revolutions", "Revolutions", "", &unit::kNone},
    {"largest_slip_m_per_s", "Largest slip at the end", "", &unit::kSpeed},
    {"power_loss_W", "Power loss at the end", "", &unit::kPower},
    {"mean_power_loss_W", "Mean power loss", "", &unit::kPower},
    {"mean_heat_outer_race_W", "Mean heat", "outer race", &unit::kPower},
    {"mean_heat_inner_race_W", "Mean heat", "inner race", &unit::kPower},
    {"mean_heat_elsewhere_W", "Mean heat", "elsewhere", &unit::kPower},
    {"mean_orbital_ratio", "Mean orbital speed / relative race speed", "", &unit::kNone},
    {"mean_cage_ratio", "Mean cage speed / relative race speed", "", &unit::kNone},
    {"mean_whirl_ratio", "Mean whirl ratio", "by revolutions", &unit::kNone},
    {"mean_swept_whirl_ratio", "Mean whirl ratio", "by swept area", &unit::kNone},
    {"mean_load_x_N", "Mean load", "x", &unit::kForce},
    {"mean_load_y_N", "Mean load", "y", &unit::kForce},
    {"mean_load_z_N", "Mean load", "z", &unit::kForce},
    {"mean_largest_load_N", "Mean of the largest contact load", "", &unit::kForce},
    {"peak_load_N", "Peak contact load", "", &unit::kForce},
    {"load_departure", "Deviation of the mean load from the specified load", "", &unit::kNone},
    {"energy_residual_J", "Energy residual", "", &unit::kEnergy},
};

}  // namespace

std::span<const KeyResultSpec> key_result_specs() { return kSpecs; }

KeyResultSpec find_key_result(std::string_view id) {
  const auto* const found = std::find_if(std::begin(kSpecs), std::end(kSpecs),
                                         [id](const KeyResultSpec& spec) { return spec.id == id; });
  return found == std::end(kSpecs) ? KeyResultSpec{} : *found;
}

KeyResult key_result(std::string_view id, double value) {
  const KeyResultSpec spec = find_key_result(id);
  if (spec.id.empty()) throw std::out_of_range("no key result " + std::string(id));
  return {spec, value};
}

KeyResult life_result(bearing::LifeModel model, bearing::LifeModification modification,
                      double hours) {
  constexpr std::size_t kModifications = 3;
  return {kSpecs[kModifications * static_cast<std::size_t>(model) +
                 static_cast<std::size_t>(modification)],
          hours};
}

double value_of(const KeyResults& results, std::string_view id) {
  for (const KeyResult& result : results)
    if (result.of.id == id) return result.value;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace adore::results
