#pragma once

#include "assembly/assembly.hpp"
#include "assembly/set_statics.hpp"

#include <functional>
#include <optional>
#include <vector>

/// Preload and unloading of a set of rows. SI.
///
/// Preload: the sum of the axial loads of the + rows without external load, equal to that of the -
/// rows. Offset of the set: mean offset g of the + rows plus mean offset of the - rows, the gap
/// that clamping closes. Unloading: the external axial force, with no other load, at which no
/// element of a row has a load at the inner race any more; the others carry it alone. A force along
/// +X unloads - rows, one along -X unloads + rows. Of identical rows without change of the contact
/// angle, δ ~ F^(2/3) for balls gives 2^1.5 = 2.83 times the preload of a pair.
/// Limits: unloading and the axial curve are computed without speed (RowCondition::Mounted).
/// Centrifugal forces hold elements at both races until the contact angle of the outer one is zero,
/// far from the displacement at which the preload ends.
namespace adore::assembly {

/// Both orientations are there.
[[nodiscard]] bool has_opposed_rows(const BearingSet& set);
/// Offsets of rows and spacers of the assembly, and `more` as half of it at each row.
void set_offsets(BearingSet& set, const Assembly& assembly, double more);
/// Offset of the set [m]. @pre has_opposed_rows()
[[nodiscard]] double total_offset(const BearingSet& set);
/// @pre has_opposed_rows()
[[nodiscard]] double preload_force(const BearingSet& set, const BearingSetState& state);

/// `more` of set_offsets() for this preload [m]. @throws SolverError
[[nodiscard]] double offset_for_force(BearingSet set, const Assembly& assembly, double force);

struct Unloading {
  std::size_t row = 0;        ///< from 0
  double force = 0.0;         ///< external force along X [N]
  double displacement = 0.0;  ///< of the shaft from the unloaded set [m]
};
/// Of each row that is loaded in the unloaded set and that an axial force unloads.
/// @pre rows that are not in operation
/// @param poll called between solutions; may throw
[[nodiscard]] std::vector<Unloading> unloading_forces(const BearingSet& set,
                                                      const BearingSetState& unloaded,
                                                      const std::function<void()>& poll);

struct AxialCurvePoint {
  double displacement = 0.0;     ///< of the shaft from the unloaded set [m]
  double force = 0.0;            ///< external, along X [N]
  double stiffness = 0.0;        ///< d force / d displacement, all other directions held [N/m]
  std::vector<double> row_load;  ///< axial load of each row, along its own +x [N]
};
/// Force over displacement, a quarter beyond the unloading of the first row to either side.
[[nodiscard]] std::vector<AxialCurvePoint> axial_curve(const BearingSet& set,
                                                       const BearingSetState& unloaded,
                                                       const std::vector<Unloading>& unloading,
                                                       int points,
                                                       const std::function<void()>& poll);

struct PreloadPoint {
  double offset = 0.0;     ///< of the set [m]
  double force = 0.0;      ///< preload [N]
  double stiffness = 0.0;  ///< axial, of the unloaded set [N/m]
};
/// Preload over offset, from touching rows to 1.5 times the offset of the set.
[[nodiscard]] std::vector<PreloadPoint> preload_curve(const BearingSet& set, int points,
                                                      const std::function<void()>& poll);

}  // namespace adore::assembly
