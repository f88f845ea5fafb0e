#pragma once

#include "desktop/chart_scene.hpp"
#include "desktop/image_export.hpp"

#include <QImage>
#include <QSizeF>

#include <filesystem>
#include <string>

/// Charts for print: of a given width on paper, with letters of a given size, in light colors.
namespace adore::desktop {

struct Figure {
  double width = 0.0;     ///< [mm]; 0: no figure, but a picture for screens
  double height = 0.0;    ///< [mm]; 0: as with_height()
  double letters = 8.0;   ///< size of axis titles and legends [pt]
  std::string font = {};  ///< family; empty: font of the program
  bool gray = false;      ///< gray lines with different dashes

  [[nodiscard]] bool is_for_print() const { return width > 0.0; }
  [[nodiscard]] QSizeF paper() const { return {width, height}; }
};

/// ChartPage::about of pages of several bodies, which is not part of the title.
inline constexpr const char* kAllChannels = "all channels";

/// Limits of the values of a figure.
inline constexpr double kLeastFigure = 30.0, kLargestFigure = 500.0;  ///< [mm]
inline constexpr double kLeastLetters = 4.0, kLargestLetters = 24.0;  ///< [pt]
inline constexpr double kFigureDpi = 600.0;  ///< dots per inch of figures as PNG or JPEG

/// The figure with a height for a page, if it has none: three quarters of the width for one panel,
/// a fifth of the width more for each further panel.
[[nodiscard]] Figure with_height(Figure figure, const ChartPage& page);

/// @throws InputError for sizes outside the limits, letters that are too large for the size, and
/// fonts that are not installed. @pre with a height
void check_figure(const Figure& figure);

/// A page as it is printed, with `dpi` dots per inch.
/// @param zoom visible part; nullptr: all of it
[[nodiscard]] QImage figure_image(const ChartPage& page, const Figure& figure, double dpi,
                                  const ChartZoom* zoom = nullptr);

/// The page by the suffix of the name: .pdf and .svg of exactly this size, .png or .jpg with
/// kFigureDpi dots per inch.
/// @param zoom visible part; nullptr: all of it
/// @throws InputError as check_figure(), for another suffix, or when the file cannot be written
void save_figure(const ChartPage& page, const std::filesystem::path& path, const Figure& figure,
                 Replace replace, const ChartZoom* zoom = nullptr);

}  // namespace adore::desktop
