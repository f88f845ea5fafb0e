#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Pictures of studies, as plain data and as PNG files of 1280 by 800.
namespace adore::desktop {

/// A number per cell over two lists of values, with a mark in each cell.
struct HeatMap {
  std::string title, x_title, y_title, legend, unit;
  std::vector<double> x, y;
  std::vector<std::vector<double>> values;      ///< [y][x]; NaN: no value
  std::vector<std::vector<std::string>> marks;  ///< [y][x]; a word below the number; may be empty
};

/// One line per run across an axis for each column; the colour goes with the last one.
struct ParallelLines {
  std::string title;
  std::vector<std::string> axes;
  std::vector<std::vector<double>> rows;  ///< [run][axis]
  int heavy = -1;                         ///< a run that is drawn above the others
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

/// Curves over a number, each with a band around it where it has one.
struct BandCurves {
  std::string title, x_title, y_title;
  std::string x_unit, y_unit;
  struct Curve {
    std::string name;
    std::vector<double> x, y, low, high;  ///< low, high: empty, or as long as y
  };
  std::vector<Curve> curves;
};

/// False, and no file, when there is nothing to draw.
bool save_picture(const HeatMap& map, const std::filesystem::path& file);
bool save_picture(const ParallelLines& lines, const std::filesystem::path& file);
bool save_picture(const Tornado& tornado, const std::filesystem::path& file);
bool save_picture(const BandCurves& curves, const std::filesystem::path& file);

}  // namespace adore::desktop
