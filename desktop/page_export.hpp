#pragma once

#include "desktop/chart_page.hpp"
#include "desktop/image_export.hpp"

#include <QSizeF>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

class QPainter;
class QRectF;

namespace adore::desktop {

class ChartScene;

/// Values of a page as a table: abscissa and curves with their units, one row per value. Curves of
/// pages with equal axes have two columns each. A curve with interpolated values has a column that
/// marks them. Empty fields are missing values; 17 digits, so that values are restored exactly.
[[nodiscard]] std::string page_csv(const ChartPage& page);

/// Visible part of a page: the values inside the view, of the visible curves.
[[nodiscard]] ChartPage visible_part(const ChartScene& scene);

/// Paints a page, laid out for `page` pixels, as lines and text into `target` of any device.
void paint_vector(ChartScene& scene, QPainter& painter, const QRectF& target, QSizeF page);

/// Several pages into one PDF file, each laid out for `size` pixels. `show(i)` puts page i into the
/// scene. The file appears when it is complete.
/// @throws InputError if it cannot be written
void save_pdf(ChartScene& scene, const std::filesystem::path& path, std::size_t pages, QSizeF size,
              const std::function<void(std::size_t)>& show);

/// The scene's page by the name's suffix: .png, .jpg, .jpeg, .svg, .pdf or .csv.
/// @throws InputError for another suffix, when it cannot be written, or for a file that may not be
/// replaced
void save_page(ChartScene& scene, const std::filesystem::path& path, QSizeF size,
               Replace replace = Replace::Anything);

}  // namespace adore::desktop
