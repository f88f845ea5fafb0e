#pragma once

#include "base/finding.hpp"
#include "deck/deck.hpp"
#include "results/static_tables.hpp"

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// Values by which a bearing is chosen, from the quasi-static equilibrium of a deck of any mode:
/// for a page, a report and scripts.
///
/// Static safety by the largest pressure p of the solution,
///   s0 = (4200 MPa/p)^3 at points of contact, (4000 MPa/p)^2 along lines,
/// since the load of a point contact grows with p^3, of a line with p^2. Limits of ISO 76 for a
/// permanent deformation of 1e-4 of the element's diameter [recalled high; 4600 MPa of
/// self-aligning ball bearings is not used, which no deck describes]. It judges the contact that
/// carries most, where C0/P0 assumes a load distribution. Pressure of an edge (`at_edge` of a
/// roller) is not in it. Frequencies: pure rolling at the mean of both contact angles of the most
/// loaded element (statics/kinematics.hpp).
namespace adore::design {

/// One value of the summary.
struct DesignValue {
  std::string id;                     ///< "life_iso281": the same in every release
  std::string group, label;           ///< "Life", "L10h, ISO 281"
  std::optional<double> value;        ///< SI, of lives hours; empty: not computed
  std::string si_unit;                ///< of `value`; empty: a pure number
  std::string unit;                   ///< in which people read it
  double factor = 1.0, offset = 0.0;  ///< number in `unit` = value * factor + offset
  std::string note;  ///< of a value: its basis; without value: the reason, a clause
};

struct DesignSummary {
  std::string bearing;  ///< "ball bearing with 14 elements"
  std::vector<DesignValue> values;
  std::vector<Finding> findings;  ///< of the deck and of the equilibrium
  results::StaticTables tables;   ///< those of RUN.json: "elements", "slices", "friction" ...
  double seconds = 0.0;           ///< computing time

  /// nullptr: no value of this name.
  [[nodiscard]] const DesignValue* find(std::string_view id) const;
};

/// "not computed", "> 1 000 000", or up to four significant digits without power of ten.
[[nodiscard]] std::string number_text(const DesignValue& value);
/// The same with the unit: "1.87 GPa".
[[nodiscard]] std::string quantity_text(const DesignValue& value);

/// @param deck without errors. Its mode becomes -1 and its stiffness table (kStif) is left out
/// @param options run options as given
/// @throws InputError, SolverError (no equilibrium), Interrupted
[[nodiscard]] DesignSummary design_summary(deck::Deck deck,
                                           const std::map<std::string, std::string>& options = {},
                                           std::stop_token stop = {});

}  // namespace adore::design
