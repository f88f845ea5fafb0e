#pragma once

#include "adrplot/own_chart.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Session files (*.adrplot): open files, charts, formulas and the view of an AdrPlot window, as
/// JSON. Paths are relative to the session file where possible.
namespace adore::adrplot {

struct SessionFile {
  std::filesystem::path path;
  results::SolRange range = {};
};

/// A curve by the number of its file; -1: a formula, by its page.
struct SessionCurve {
  int file = 0, page = 1;
  std::size_t panel = 0;
  std::string curve;
  int group = -1;
  std::string name = {};  ///< in a formula
};

struct SessionFormula {
  std::string title, formula, unit;
  std::vector<SessionCurve> inputs;
};

struct SessionChart {
  Combine how = Combine::Overlay;
  std::vector<SessionCurve> curves;
};

struct Session {
  std::vector<SessionFile> files;
  std::vector<SessionFormula> formulas;
  std::vector<SessionChart> charts;
  PageOptions view = {};
  std::optional<bool> log_x = {}, log_y = {};
  int document = 0, page = 1;  ///< that is shown: files, formulas, charts in this order
};

/// Is it a session, by its name?
[[nodiscard]] bool is_session(const std::filesystem::path& path);

/// Replaces the file atomically. @throws InputError
void save_session(const Session& session, const std::filesystem::path& path);

/// @throws InputError for a damaged file or one of a newer version
[[nodiscard]] Session read_session(const std::filesystem::path& path);

}  // namespace adore::adrplot
