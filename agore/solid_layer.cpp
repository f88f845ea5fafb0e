#include "agore/solid_model.hpp"
#include "agore/solid_view.hpp"

#include <cmath>
#include <utility>

/// The bodies of a frame on a canvas.
namespace adore::agore {

/// Center as drawn: the clearances magnified across the axis, to scale along it.
Vec3 drawn_element_center(const Scene& s, std::size_t k) {
  const QPointF centre = element_centre(s, k);
  return {s.frame.elements.at(k).x, centre.x(), centre.y()};
}

namespace {

/// Axis of a roller as drawn, its skew and tilt magnified.
Vec3 roller_axis(const results::Sol8Element& e, double nominal, double factor) {
  constexpr double kMost = 0.6;  // [rad]
  const AxisAngles angles = axis_angles(e);
  const double lean = nominal + std::clamp(factor * (angles.lean - nominal), -kMost, kMost);
  const double skew = std::clamp(factor * angles.skew, -kMost, kMost);
  return Vec3(Vec3(1.0, 0.0, 0.0) + std::tan(lean) * outward_direction(e.theta) +
              std::tan(skew) * azimuthal_direction(e.theta))
      .normalized();
}

void add_elements(SolidPainter& m, const Scene& s, double roller_factor) {
  const ElementColors colours =
      element_colors(s.animation, s.index, s.options.colour, s.options.scale);
  const desktop::Theme& t = s.sketch.theme();
  const bool balls = s.animation.file.bearing_type == 1;
  const Shades steel = shades_of(t.steel_light),
               plain_mark = shades_of(solid_rotation_mark_color(t));
  const double nominal = nominal_lean(s.animation);
  const RollerProfile roller = roller_profile(s.animation);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    const auto& e = s.frame.elements[k];
    const QColor tint = colours.of(k);
    const Shades shades = tint.isValid() ? shades_of(tint) : steel;
    const Shades paint =
        tint.isValid() ? shades_of(solid_rotation_mark_color(t, true)) : plain_mark;
    const bool followed = e.angles != std::array<double, 3>{};
    const Mat3 attitude = rotation(e.angles);
    const Vec3 centre = drawn_element_center(s, k);
    if (balls) {
      m.sphere(centre, s.geometry().element_radius,
               followed ? Vec3(attitude.col(2)) : Vec3(Vec3::Zero()), shades, paint);
      continue;
    }
    const Vec3 axis = roller_axis(e, nominal, roller_factor);
    Vec3 first = attitude.col(2) - attitude.col(2).dot(axis) * axis;
    if (!(first.norm() > 1e-6)) first = outward_direction(e.theta);
    add_roller(m, roller, centre - roller.mass_centre * axis, axis, first.normalized(), shades,
               followed ? paint : shades);
  }
}

void add_cage(SolidPainter& m, const Scene& s) {
  if (!s.animation.has_cage) return;
  const Shades shades = shades_of(s.sketch.theme().cage);
  CageProfile profile = cage_profile(s.animation);
  for (const CagePocket& pocket : cage_pockets(s.animation, s.pocket_radius(), profile)) {
    const auto& body = s.animation.part(s.index, pocket.part);
    const QPointF across = s.place(body);
    add_pocket_sector(m, profile, s.pitch_radius(), pocket.azimuth, pocket.mesh,
                      cage_attitude(s.animation, s.index, pocket.part, s.factor),
                      {body.position[0], across.x(), across.y()}, pocket.open_end, shades);
  }
}

}  // namespace

double SolidLayer::roller_factor(const Animation& animation) {
  if (roller_factor_) return *roller_factor_;
  double largest = 0.0;
  const double nominal = nominal_lean(animation);
  if (animation.file.bearing_type != 1) {
    constexpr std::size_t kLooks = 200;
    const std::size_t every = std::max<std::size_t>(1, animation.frames() / kLooks);
    for (std::size_t i = 0; i < animation.frames(); i += every)
      for (const auto& e : animation.frame(i).elements) {
        const AxisAngles angles = axis_angles(e);
        largest = std::max({largest, std::abs(angles.lean - nominal), std::abs(angles.skew)});
      }
  }
  constexpr double kShown = 0.12, kRounding = 1e-9;  // [rad]
  double factor = largest > kRounding ? 1.0 : 0.0;
  if (largest > kRounding)
    for (const double candidate : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0})
      if (candidate * largest <= kShown) factor = candidate;
  roller_factor_ = factor;
  return factor;
}

bool SolidLayer::hides(QPointF place, double depth) const {
  constexpr double kTouching = 0.75;  // pixels
  const QPointF at = (place - canvas_corner_) * canvas_pixel_size_;
  return canvas_.depth_at(at) > (depth + kTouching) * canvas_pixel_size_;
}

std::vector<RaceRotationMark> race_rotation_marks(const Scene& s, const Eye& eye) {
  std::vector<RaceRotationMark> out;
  for (std::size_t race = is_outer_mark_visible(s, eye) ? 0 : 1; race < 2; ++race) {
    const auto profile = ring_profile(s.animation, race, s.factor);
    const auto& at = s.frame.races.at(race).position;
    for (const RingRadii& face : {profile.front(), profile.back()})
      out.push_back({race, Vec3(Vec3(face.x, 0.0, 0.0) +
                                0.5 * (face.near + face.far) *
                                    outward_direction(s.animation.race_angle[race][s.index]) +
                                Vec3(at[0], at[1], at[2]))});
  }
  return out;
}

double race_rotation_mark_radius(const Scene& s) { return 0.16 * s.geometry().element_radius; }

void SolidLayer::draw(const Scene& s, int oversample, double pixel_ratio) {
  const double pixel = oversample * pixel_ratio;
  const QRectF& area = s.sketch.area();
  const QSize size(
      (QSizeF(std::round(area.width() * pixel_ratio), std::round(area.height() * pixel_ratio)) *
       oversample)
          .toSize());
  const Eye eye(s.options.yaw, s.options.elevation);
  const double scale = s.sketch.scale() * pixel;
  const QPointF middle = (s.sketch.at(0, 0) - area.topLeft()) * pixel;
  const auto shift = [&](std::size_t race) {
    const auto& p = s.frame.races.at(race).position;
    return Vec3(p[0], p[1], p[2]);
  };
  const desktop::Theme& t = s.sketch.theme();
  Key key{size,     scale, s.options.yaw,  s.options.elevation, middle.x(), middle.y(),
          s.factor, {},    s.options.dark, &s.animation};
  constexpr double kFar = 1e6;
  for (std::size_t race = 0; race < 2; ++race)
    for (int c = 0; c < 3; ++c)
      key.shift[3 * race + static_cast<std::size_t>(c)] =
          static_cast<int>(std::lround(std::clamp(2.0 * scale * shift(race)[c], -kFar, kFar)));
  if (!(key == key_)) {
    races_.reset(size, t.surface.rgb());
    canvas_ = DepthCanvas();
    SolidPainter m(races_, eye, scale, middle);
    const Shades steel = shades_of(t.steel_dark);
    const double towards = viewers_azimuth(eye);
    const std::array<std::pair<double, double>, 2> arcs{
        {{towards + kOpen, towards + 2.0 * kPi - kOpen}, {0.0, 2.0 * kPi}}};
    for (const std::size_t race : {0U, 1U})
      add_ring(m, ring_profile(s.animation, race, s.factor), shift(race), arcs[race].first,
               arcs[race].second, steel);
    for (const LandSection& land : land_sections(s.animation, s.factor))
      add_land_surface(m, land, shift(land.race), arcs[land.race], shades_of(t.red), 2.0 / scale);
    key_ = key;
  }
  canvas_.restore(races_);
  canvas_corner_ = area.topLeft();
  canvas_pixel_size_ = pixel;
  SolidPainter m(canvas_, eye, scale, middle);
  add_elements(m, s, roller_factor(s.animation));
  add_cage(m, s);
  for (const RaceRotationMark& spot : race_rotation_marks(s, eye)) {
    const Shades shades = shades_of(spot.race == 0 ? t.light_blue : t.blue);
    m.sphere(spot.centre, race_rotation_mark_radius(s), Vec3::Zero(), shades, shades);
  }
  // The rest is background.
  const QRect drawn = canvas_.drawn();
  if (drawn.isEmpty()) return;
  const QRect box(drawn.topLeft() / oversample - QPoint(1, 1),
                  drawn.bottomRight() / oversample + QPoint(1, 1));
  const QRect seen = box & QRect(QPoint(0, 0), size / oversample);
  QImage image = canvas_.image(oversample, seen);
  image.setDevicePixelRatio(pixel_ratio);
  s.sketch.painter().drawImage(area.topLeft() + QPointF(seen.topLeft()) / pixel_ratio, image);
}

}  // namespace adore::agore
