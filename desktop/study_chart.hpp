#pragma once

#include "base/write_folder.hpp"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

class QPainter;
class QPointF;
class QSizeF;

/// Pictures of studies: plain data, drawn by the command line and by AdrPlot alike.
namespace adore::desktop {

struct Theme;

/// Numbers of the runs behind a point; empty: not known.
using Runs = std::vector<long>;

/// A number per cell over two lists of values, with a mark in each cell.
struct HeatMap {
  std::string title, x_title, y_title, legend, unit;
  std::vector<double> x, y;
  std::vector<std::vector<double>> values;      ///< [y][x]; NaN: no value
  std::vector<std::vector<std::string>> marks;  ///< [y][x]; a word below the number; may be empty
  std::vector<std::vector<Runs>> runs;          ///< [y][x]; may be empty
};

/// One line per run across an axis for each column; the color goes with the last one.
struct ParallelLines {
  std::string title;
  std::vector<std::string> axes;
  std::vector<std::vector<double>> rows;  ///< [run][axis]
  int heavy = -1;                         ///< a run that is drawn above the others
  Runs runs;                              ///< one per row; may be empty
};

/// Bars to both sides of zero, the largest on top.
struct Tornado {
  std::string title, x_title;
  struct Bar {
    std::string name;
    double value = 0.0, doubt = 0.0;  ///< drawn as a whisker
  };
  std::vector<Bar> bars;
};

/// Curves over a number, each with a band if it has one.
struct BandCurves {
  std::string title, x_title, y_title;
  std::string x_unit, y_unit;
  struct Curve {
    std::string name;
    std::vector<double> x, y, low, high;  ///< low, high: empty, or as long as y
    std::vector<Runs> runs;               ///< one per x; may be empty
  };
  std::vector<Curve> curves;
};

struct StudyChart {
  std::string name;  ///< of its file, without ending
  std::variant<BandCurves, HeatMap, ParallelLines, Tornado> of;

  [[nodiscard]] const std::string& title() const;
  /// Is there anything to draw?
  [[nodiscard]] bool has_content() const;
};

/// Parses the text of CHARTS.json. @throws InputError if invalid
[[nodiscard]] std::vector<StudyChart> parse_study_charts(const std::string& text,
                                                         const std::string& name);
[[nodiscard]] std::vector<StudyChart> read_study_charts(const std::filesystem::path& file);

/// Fills a page of `size` pixels. Letters shrink with it, down to a size that is read.
void paint_study(const StudyChart& chart, QPainter& painter, const QSizeF& size,
                 const Theme& theme);

/// Runs behind a position of the page: those of the nearest point, line or cell; empty: none is
/// near.
[[nodiscard]] Runs runs_at(const StudyChart& chart, const QSizeF& size, const QPointF& at);

/// PNG of 1280 by 800, light. False, without a file, if there is nothing to draw.
bool save_picture(const StudyChart& chart, const WritePath& file);

/// The numbers of a picture as a table.
[[nodiscard]] std::string study_chart_csv(const StudyChart& chart);

}  // namespace adore::desktop
