#pragma once

#include "studies/study_table.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

/// Report of a study, as text and as charts.
namespace adore::studies {

struct Report {
  std::string text;
  /// A list of charts as plain data, drawn by the picture program: {"kind": "curves", "heat-map",
  /// "parallel" or "tornado", "name": file name without ending, "title", ...}; see
  /// desktop/study_chart.hpp.
  std::string charts;
};

[[nodiscard]] Report make_report(const Study& study, const Results& results,
                                 const StudyTable& table);

/// Tables, REPORT.txt and CHARTS.json of the runs that are finished, in the study's folder.
/// @throws InputError when it was never started; WriteError
Report write_report(const Study& study);

}  // namespace adore::studies
