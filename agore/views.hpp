#pragma once

#include "agore/view_options.hpp"
#include "desktop/chart_page.hpp"
#include "desktop/theme.hpp"

#include <QPainter>

#include <array>

/// The pictures and their data curves, as functions of a frame: no state, no window.
namespace adore::agore {

struct Kept;

/// Of a picture: what lies below and stays as it is from frame to frame while the races do not
/// move, and what moves over it.
enum class Layers : unsigned char { All, Still, Moving };

/// Draws the picture area of one frame into `area`. `kept` may be nothing: then all is made anew.
void paint_picture(QPainter& painter, const QRectF& area, const Animation& animation,
                   std::size_t frame, const ViewOptions& options, Kept* kept = nullptr,
                   Layers layers = Layers::All);

/// What the still layer of a picture depends on: where its sketch is and how large it draws, which
/// every option may change that changes the key's room, and the places of the races to a quarter
/// of a pixel.
struct StillKey {
  QRectF area;
  QPointF centre;
  double scale = 0.0, factor = 0.0;
  View view{};
  bool dark = false, clipped = false;
  std::array<long, 4> races{};
  bool operator==(const StillKey&) const = default;
};
StillKey still_key(const QRectF& area, const Animation& animation, std::size_t frame,
                   const ViewOptions& options);

/// Where in `area` the middle of the picture is drawn that is neither zoomed nor moved.
QPointF picture_middle(const Animation& animation, const ViewOptions& options, const QRectF& area);

/// What the data area beside the picture plots over time.
desktop::ChartPage data_page(const Animation& animation, const ViewOptions& options);

/// The theme that the options ask for.
const desktop::Theme& theme_of(const ViewOptions& options);

}  // namespace adore::agore
