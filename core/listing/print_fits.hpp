#pragma once

#include "bearing/bearing.hpp"
#include "listing/report.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

/// Operating fits, clearances and growths of a bearing: page of PRINT.txt, object of RUN.json,
/// columns of a sweep.
namespace adore::listing {

/// Of a bearing that has its operating report.
void print_fits(Report& report, const bearing::Bearing& bearing);

/// The same in SI; every key ends in its unit.
[[nodiscard]] nlohmann::ordered_json fits_json(const bearing::OperatingFits& fits);

/// The few numbers that a study compares, by name and SI unit.
[[nodiscard]] std::vector<std::pair<std::string, double>> fits_summary(
    const bearing::OperatingFits& fits);

}  // namespace adore::listing
