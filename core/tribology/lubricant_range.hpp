#pragma once

#include <optional>
#include <string>

/// To which pressure a lubricant's traction was measured ("measuredTo" of
/// resources/lubricants.json): beyond it the laws of viscosity and stress under pressure are
/// extrapolations. Films are made in the inlet, at low pressure, and do not ask for it. SI.
namespace adore::tribology {

struct PressureRange {
  std::optional<double> measured_to;  ///< [Pa]; none: not known
  std::string provenance;             ///< "seen", "recalled", "estimated"
  std::string source;                 ///< its sentence; why it is not known
};

/// Of kTrac 1 to 20 but 9: the user's lubricant has none.
/// @throws InputError naming the codes of the table
[[nodiscard]] const PressureRange& pressure_range(int code);

/// Note on traction and viscosity at a pressure [Pa]: "extrapolated beyond 1 GPa, the
/// highest measured pressure", or that this is unknown; empty within the range.
[[nodiscard]] std::string extrapolation_note(const PressureRange& range, double pressure);

}  // namespace adore::tribology
