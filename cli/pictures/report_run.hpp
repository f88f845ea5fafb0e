#pragma once

#include "cli/pictures/report_template.hpp"

#include <QImage>

#include <filesystem>
#include <string>
#include <vector>

/// One run of a report: its RUN.json in words and tables, its charts and pictures of its motion.
namespace adore::cli {

struct ReportPicture {
  std::string name;  ///< as `src` of its <img>
  QImage image;
};

enum class ReportCharts : unsigned char { Main, All };

struct ReportRun {
  ReportParts parts;
  std::vector<ReportPicture> pictures;
  /// Key results for the table that compares runs: id, label with unit, text of the value.
  struct Value {
    std::string id, label, text;
  };
  std::vector<Value> values;
  std::string name;  ///< runID of the deck, else the folder
};

/// @param number of the run in the report, counted from 1: part of the names of its pictures
/// @throws InputError for a folder without a RUN.json of this program
[[nodiscard]] ReportRun report_run(const std::filesystem::path& folder, std::size_t number,
                                   ReportCharts charts);

/// Text as HTML.
[[nodiscard]] std::string escape_html(std::string_view text);
/// A table; cells are HTML, numbers (`numeric`) are right-aligned. "" without rows.
[[nodiscard]] std::string html_table(const std::vector<std::string>& header,
                                     const std::vector<std::vector<std::string>>& rows,
                                     const std::vector<bool>& numeric = {});

}  // namespace adore::cli
