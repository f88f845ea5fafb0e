#pragma once

#include "cli/picture_commands.hpp"

namespace adore::cli {

/// `adore report`: report.html (one file, pictures inside) and report.pdf in a folder. The same
/// runs, program and template give the same bytes. Prints the names of both files.
/// @throws InputError for a folder without a run, a template with unknown parts, or a report.html
/// of another program in the folder
void draw_report(const ReportRequest& request);

}  // namespace adore::cli
