#pragma once

#include "results/sol_file.hpp"

#include <string>
#include <vector>

/// The plot pages of each kind of result file, as a table without Qt. Curves name columns by id
/// (results::sol_columns); position and unit of a value in the file are defined by the results.
namespace adore::adrplot {

enum class PageKind : unsigned char {
  History,   ///< panels over revolutions or time
  Orbit,     ///< one coordinate of the mass center against another
  Spectrum,  ///< amplitude over frequency of the mass center coordinates
  Chart      ///< of a file without steps: the same in every view
};

struct CurveSpec {
  std::string name;
  std::string column;  ///< "contact.load.outer"
};

/// Curves of one unit: that of the first column.
struct PanelSpec {
  std::string title;
  std::vector<CurveSpec> curves;
  bool wraps = false;  ///< an angle that restarts after each revolution
};

struct PageSpec {
  std::string title;
  PageKind kind = PageKind::History;
  std::vector<PanelSpec> panels;  ///< of an orbit or spectrum: one panel per coordinate x, y, z
  std::string note;               ///< part of a full page that this file does not have
};

/// Pages of a file, in the order of their numbers.
std::vector<PageSpec> plot_pages(results::SolKind kind, const results::SolHeader& header);

/// "rolling element 3", "cage segment 2", "outer race", "power and life".
std::string subject(results::SolKind kind, const results::SolHeader& header);

}  // namespace adore::adrplot
