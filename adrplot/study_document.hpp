#pragma once

#include "adrplot/plot_document.hpp"

/// Results of `adore study` as pages: the pictures of its report.
namespace adore::adrplot {

/// The folder of a study, or its RUNS.csv, STUDY.h5 or CHARTS.json, at any place.
[[nodiscard]] bool is_study(const std::filesystem::path& path);

/// With CHARTS.json in the same folder its charts; else those that the table allows.
/// @throws InputError
[[nodiscard]] PlotDocument open_study(const std::filesystem::path& path);

}  // namespace adore::adrplot
