#pragma once

#include "bearing/bearing.hpp"
#include "listing/report.hpp"

#include <nlohmann/json_fwd.hpp>

/// Operating fits, clearances and growths of a bearing: page of PRINT.txt, object of RUN.json.
namespace adore::listing {

/// Of a bearing that has its operating report.
void print_fits(Report& report, const bearing::Bearing& bearing);

/// The same in SI; every key ends in its unit.
[[nodiscard]] nlohmann::ordered_json fits_json(const bearing::OperatingFits& fits);

}  // namespace adore::listing
