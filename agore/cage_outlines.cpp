#include "agore/cage_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::agore {

namespace {

QPointF polar(double radius, double angle) {
  return {-radius * std::sin(angle), radius * std::cos(angle)};
}

QPainterPath cut_outline(const Animation& animation, double pocket_radius, int segment) {
  // Cutting works to absolute distances, made for pixels: so in thousands of them.
  auto g = animation.file.geometry;
  const double enlargement = CageOutlines::kRadius / g.cage_outer_radius;
  for (double* length : {&g.cage_outer_radius, &g.cage_inner_radius, &g.pitch_diameter})
    *length *= enlargement;
  pocket_radius *= enlargement;
  const double pitch_radius = 0.5 * g.pitch_diameter;
  QPainterPath body;
  body.addEllipse(QPointF(0, 0), g.cage_outer_radius, g.cage_outer_radius);
  body.addEllipse(QPointF(0, 0), g.cage_inner_radius, g.cage_inner_radius);
  QPainterPath holes;
  holes.setFillRule(Qt::WindingFill);
  for (std::size_t k = 0; k < animation.pocket_angle.size(); ++k) {
    if (animation.pocket_part[k] != segment) continue;
    const double pocket = animation.pocket_angle[k];
    holes.addEllipse(polar(pitch_radius, pocket), pocket_radius, pocket_radius);
  }
  if (animation.segments > 1) {
    QPolygonF sector{QPointF(0, 0)};
    const auto [begin, end] = segment_sector(animation, segment);
    constexpr int kParts = 90;
    for (int i = 0; i <= kParts; ++i)
      sector.append(polar(2.0 * g.cage_outer_radius, begin + (end - begin) * i / kParts));
    QPainterPath arc;
    arc.addPolygon(sector);
    arc.closeSubpath();
    body = body.intersected(arc);
  }
  return body.subtracted(holes);
}

CageOutlines::Outline in_pieces(const QPainterPath& path) {
  CageOutlines::Outline out;
  for (const QPolygonF& piece : path.toSubpathPolygons()) out.pieces.push_back(piece);
  for (const QPolygonF& piece : out.pieces)
    for (const QPolygonF& other : out.pieces)
      if (&piece != &other && piece.boundingRect().contains(other.boundingRect()))
        out.nested = true;
  return out;
}

/// Square of the distance of `p` from the stretch between `a` and `b`.
double apart(QPointF p, QPointF a, QPointF b) {
  const QPointF way = b - a, here = p - a;
  const double length = QPointF::dotProduct(way, way);
  const double part =
      length > 0.0 ? std::clamp(QPointF::dotProduct(here, way) / length, 0.0, 1.0) : 0.0;
  const QPointF off = here - part * way;
  return QPointF::dotProduct(off, off);
}

}  // namespace

Sector segment_sector(const Animation& animation, int segment) {
  double first = 0.0, last = 0.0, reference = 0.0;
  bool any = false;
  for (std::size_t k = 0; k < animation.pocket_angle.size(); ++k) {
    if (animation.pocket_part[k] != segment) continue;
    const double pocket = animation.pocket_angle[k];
    if (!any) reference = pocket;
    any = true;
    const double beside = std::remainder(pocket - reference, 2.0 * std::numbers::pi);
    first = std::min(first, beside), last = std::max(last, beside);
  }
  constexpr double kGap = 0.012;
  const double half = std::numbers::pi / animation.file.elements - kGap;
  return {reference + first - half, reference + last + half};
}

QPolygonF thinned(const QPolygonF& closed, double tolerance) {
  const qsizetype last = closed.size() - 1;
  if (last < 3) return closed;
  const auto farthest = [&](qsizetype from, qsizetype to, QPointF a, QPointF b) {
    std::pair<double, qsizetype> out{-1.0, from};
    for (qsizetype i = from + 1; i < to; ++i) out = std::max(out, {apart(closed[i], a, b), i});
    return out;
  };
  std::vector<bool> kept(static_cast<std::size_t>(closed.size()), false);
  const qsizetype opposite = farthest(0, last, closed[0], closed[0]).second;
  std::vector<std::pair<qsizetype, qsizetype>> open{{0, opposite}, {opposite, last}};
  for (const qsizetype i : {qsizetype{0}, opposite, last}) kept[static_cast<std::size_t>(i)] = true;
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const auto [distance, at] = farthest(from, to, closed[from], closed[to]);
    if (distance <= tolerance * tolerance) continue;
    kept[static_cast<std::size_t>(at)] = true;
    open.emplace_back(from, at), open.emplace_back(at, to);
  }
  QPolygonF out;
  for (qsizetype i = 0; i <= last; ++i)
    if (kept[static_cast<std::size_t>(i)]) out.append(closed[i]);
  return out;
}

const CageOutlines::Outline& CageOutlines::of(const Animation& animation, double pocket_radius,
                                              int segment, double outside) {
  if (animation_ != &animation || pocket_radius_ != pocket_radius) {
    full_outlines_.clear(), simplified_outlines_.clear();
    animation_ = &animation;
    pocket_radius_ = pocket_radius;
  }
  auto found = full_outlines_.find(segment);
  if (found == full_outlines_.end())
    found =
        full_outlines_.emplace(segment, in_pieces(cut_outline(animation, pocket_radius, segment)))
            .first;
  auto& [size, outline] = simplified_outlines_[segment];
  if (size == outside) return outline;
  size = outside;
  outline = found->second;
  const double tolerance = kTolerance * kRadius / std::max(outside, 1.0);
  for (QPolygonF& piece : outline.pieces) piece = thinned(piece, tolerance);
  return outline;
}

}  // namespace adore::agore
