#pragma once

#include "agore/view_options.hpp"
#include "desktop/chart_page.hpp"
#include "desktop/theme.hpp"

#include <QPainter>

/// The pictures and their data curves, as functions of a frame: no state, no window.
namespace adore::agore {

struct Kept;

/// Draws the picture area of one frame into `area`. `kept` may be nothing: then all is made anew.
void paint_picture(QPainter& painter, const QRectF& area, const Animation& animation,
                   std::size_t frame, const ViewOptions& options, Kept* kept = nullptr);

/// Where in `area` the middle of the picture is drawn that is neither zoomed nor moved.
QPointF picture_middle(const Animation& animation, const ViewOptions& options, const QRectF& area);

/// What the data area beside the picture plots over time.
desktop::ChartPage data_page(const Animation& animation, const ViewOptions& options);

/// The theme that the options ask for.
const desktop::Theme& theme_of(const ViewOptions& options);

}  // namespace adore::agore
