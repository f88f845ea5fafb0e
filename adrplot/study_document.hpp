#pragma once

#include "adrplot/plot_document.hpp"

/// Results of `adore study` as pages: the pictures of its report.
namespace adore::adrplot {

/// A study's folder, or one of RUNS.csv, STUDY.h5 and CHARTS.json, wherever it is.
[[nodiscard]] bool is_study(const std::filesystem::path& path);

/// With CHARTS.json in the same folder its charts; else those that the table allows.
/// @throws InputError
[[nodiscard]] PlotDocument open_study(const std::filesystem::path& path);

}  // namespace adore::adrplot
