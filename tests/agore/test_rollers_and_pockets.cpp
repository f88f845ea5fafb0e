#include "agore/example_run.hpp"
#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/picture_words.hpp"
#include "agore/pocket_outline.hpp"
#include "agore/render.hpp"
#include "agore/ring_profile.hpp"
#include "agore/view_scene.hpp"
#include "agore/views.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QPainter>
#include <catch2/catch.hpp>

#include <array>
#include <numbers>

/// Shapes of rollers and pockets as they are drawn, and how a roller lies in its pocket and between
/// its flanges.
using namespace adore;
using namespace adore::agore;
using test::write_run;
using test::write_sizes;

TEST_CASE("pocket outlines have the clearances of their shape", "[unit][agore][pocket]") {
  using agore::PocketOutline;
  const auto half = [](PocketOutline p) { return agore::pocket_half_size(p); };
  const PocketOutline ball{.radius = 5.0, .clearance_1 = 1.0, .clearance_2 = 2.0};
  const auto with = [&](int code) {
    PocketOutline p = ball;
    p.code = code;
    return p;
  };
  CHECK(half(with(0)) == QSizeF(5.5, 5.5));
  CHECK(half(with(2)) == QSizeF(6.5, 5.5));  // round the bearing
  CHECK(half(with(3)) == QSizeF(5.5, 6.0));
  CHECK(half(with(4)) == QSizeF(6.0, 6.0));
  for (const int code : {0, 1, 2, 3, 4}) {
    const QRectF box = agore::pocket_hole(with(code)).boundingRect();
    CHECK(box.width() == Approx(2.0 * half(with(code)).width()));
    CHECK(box.height() == Approx(2.0 * half(with(code)).height()));
  }
  // A roller has half of clearance I at its sides and at its ends (decision 213).
  PocketOutline roller = ball;
  roller.roller_length = 14.0;
  CHECK(half(roller) == QSizeF(5.5, 7.5));
  agore::RollerProfile shape{.half = 7.0, .radius = 5.0};
  shape.corner = {0.5, 1.0};
  const QPainterPath upright = QTransform().rotate(90).map(shape.outline());
  CHECK(agore::pocket_hole(roller).contains(upright));
  CHECK(upright.boundingRect().width() == Approx(10.0));
  CHECK(upright.boundingRect().height() == Approx(14.0));
  // Its window has its taper: as wide as the roller and the clearance at both ends.
  roller.taper = -0.1;
  const QPainterPath window = agore::pocket_hole(roller);
  CHECK(window.contains(QPointF(6.2, -7.4)));
  CHECK_FALSE(window.contains(QPointF(4.9, 7.4)));
  CHECK(window.contains(QPointF(4.7, 7.4)));
}

TEST_CASE("pocket view: arrow points to the loaded wall", "[unit][agore][pocket]") {
  using agore::wall_contact_direction;
  const QPointF down(0.1, -5.0);  // far along the axis
  for (const double direction : {1.0, -1.0}) {
    // The roller drives: the wall before it, whichever way the cage turns; and behind it.
    CHECK(wall_contact_direction(true, down, adore::kPi, direction) == QPointF(direction, 0.0));
    CHECK(wall_contact_direction(true, down, 0.0, direction) == QPointF(-direction, 0.0));
    CHECK(wall_contact_direction(false, {0.0, 0.0}, 0.0, direction) == QPointF(-direction, 0.0));
    CHECK(wall_contact_direction(false, {0.0, -5.0}, 0.0, direction) == QPointF(0.0, -1.0));
  }
}

TEST_CASE("a roller meets its wall where the run says, or where it is drawn next to it",
          "[unit][agore][pocket]") {
  using agore::wall_contact_point, agore::upright;
  const agore::RollerProfile shape{.half = 7.0, .radius = 5.0};
  const auto near = [](QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y()) < 0.02;
  };
  const QPolygonF straight = upright(shape.outline(), 0.0);
  for (const std::size_t side : {0U, 1U}) {
    const double x = side == 0 ? -5.0 : 5.0;
    CHECK(near(wall_contact_point(straight, 0.0, side, {}), {x, 0.0}));
    CHECK(near(wall_contact_point(straight, 0.0, side, 3.0), {x, 3.0}));
    CHECK(near(wall_contact_point(straight, 0.0, side, 99.0), {x, 7.0}));
    // A skew to the right brings its upper end to the right wall, its lower one to the left.
    const QPolygonF skewed = upright(shape.outline(), 0.1);
    const QPointF touch = wall_contact_point(skewed, 0.0, side, {});
    CHECK((side == 0 ? -1.0 : 1.0) * touch.y() > 6.0);
    CHECK(std::abs(touch.x()) == Approx(5.0 * std::cos(0.1) + 7.0 * std::sin(0.1)).epsilon(0.01));
    // A cone lies along the walls of its window.
    const agore::RollerProfile cone{.half = 7.0, .radius = 5.0, .slope = -0.1};
    const QPointF on_cone = wall_contact_point(upright(cone.outline(), 0.0), -0.1, side, 4.0);
    CHECK(std::abs(on_cone.x()) == Approx(4.6).epsilon(0.01));
    CHECK(on_cone.y() == Approx(4.0));
  }
}

TEST_CASE("the wall that carries by the stored angle is the one that is pressed in by its gap",
          "[agore][pocket][h5][slow]") {
  int contacts = 0;
  for (const std::string& type : test::kTypes) {
    const Animation a = open_motion(test::example_run(type) / "RESULTS.h5");
    const auto& force = *a.motion->channel("pocket.force");
    const auto& gap = *a.motion->channel("pocket.gap");
    const auto& theta = *a.motion->channel("pocket.theta");
    const bool balls = a.file.bearing_type == 1;
    const std::size_t surfaces = a.motion->pocket_surfaces();
    for (std::size_t frame = 0; frame < a.frames(); ++frame)
      for (std::size_t k = 0; k < static_cast<std::size_t>(a.file.elements); ++k)
        for (std::size_t i = k * surfaces; i < (k + 1) * surfaces; ++i) {
          if (!(force.at(frame, i) > 0.0)) continue;
          ++contacts;
          INFO(type << ", frame " << frame << ", element " << k + 1);
          CHECK(gap.at(frame, i) < 0.0);
          if (!balls) {  // the first of a pair drives the roller
            CHECK((std::cos(theta.at(frame, i)) > 0.0) == ((i - k * surfaces) % 2 == 0));
            continue;
          }
          // A ball has gone towards the wall that its angle names.
          const auto& way = a.frame(frame).elements[k].pocket_vector;
          const double turns = a.cage_angle.back() >= a.cage_angle.front() ? 1.0 : -1.0;
          const QPointF wall = wall_contact_direction(false, {}, theta.at(frame, i), turns);
          CHECK(-way[1] * wall.x() + way[0] * wall.y() > 0.0);
        }
  }
  CHECK(contacts > 3);
}

TEST_CASE("pocket view: tilted roller is foreshortened, its clearance is kept",
          "[unit][agore][pocket]") {
  agore::RollerProfile shape{.half = 7.0, .radius = 5.0};
  CHECK(shape.outline(0.0) == shape.outline());
  CHECK(shape.visible_end_rim(0.0).isEmpty());
  for (const double lean : {0.2, -0.35}) {
    const double sine = std::abs(std::sin(lean)), cosine = std::cos(lean);
    const QRectF seen = shape.outline(lean).boundingRect(),
                 end = shape.visible_end_rim(lean).boundingRect();
    CHECK(seen.height() == Approx(10.0));
    CHECK(seen.right() == Approx(7.0 * cosine + 5.0 * sine));
    CHECK(seen.left() == Approx(-seen.right()));
    // The end at +u is seen when that leans towards the viewer.
    CHECK(end.center().x() == Approx((lean > 0.0 ? 7.0 : -7.0) * cosine));
    CHECK(end.width() == Approx(10.0 * sine));
  }
  // The drawn end of a roller is never outside of the roller, as the rim of a dome once was; no
  // line marks an invisible end.
  for (const double bulge : {0.0, 6.0, 12.0, 120.0})
    for (const double lean : {0.01, 0.03, 0.1, 0.4, -0.05, -0.4}) {
      const agore::RollerProfile domed{
          .half = 7.0, .radius = 5.0, .corner = {0.5, 0.5}, .dome = {bulge, bulge}};
      const QRectF seen = domed.outline(lean).boundingRect(),
                   end = domed.visible_end_rim(lean).boundingRect();
      INFO("dome " << bulge << ", lean " << lean);
      CHECK(end.isEmpty() == (lean == 0.01));
      if (!end.isEmpty()) CHECK(seen.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(end));
    }
  // Cones with corners: the space between the walls of the section equals the drawn roller.
  shape.slope = -0.1;
  shape.corner = {0.5, 1.0};
  for (const double lean : {0.0, 0.15, -0.3}) {
    const auto walls = agore::end_wall_offsets(shape, lean);
    const QRectF seen = shape.outline(lean).boundingRect();
    CHECK(seen.left() == Approx(-7.0 - walls[0]).epsilon(1e-3));
    CHECK(seen.right() == Approx(7.0 + walls[1]).epsilon(1e-3));
    agore::PocketOutline pocket{.radius = 5.0, .roller_length = 14.0, .taper = -0.1};
    pocket.clearance_1 = 1.0;
    pocket.leaning = walls;
    const QRectF hole = agore::pocket_hole(pocket).boundingRect();
    CHECK(hole.top() == Approx(seen.left() - 0.5).epsilon(1e-3));
    CHECK(hole.bottom() == Approx(seen.right() + 0.5).epsilon(1e-3));
    CHECK(agore::pocket_half_size(pocket).height() == Approx(std::max(-hole.top(), hole.bottom())));
    CHECK(2.0 * agore::pocket_half_size(pocket).width() == Approx(hole.width()));
  }
}

TEST_CASE("a roller is drawn with its cone, its arc, its corners and its domes", "[unit][agore]") {
  agore::RollerProfile r{.half = 7.0, .radius = 5.0, .slope = -0.1};
  CHECK(r.side(-7.0) == Approx(5.7));
  CHECK(r.side(7.0) == Approx(4.3));
  r.corner = {0.5, 1.0};
  CHECK(r.side(-6.5) == Approx(5.65));
  CHECK(r.side(-7.0) == Approx(5.2));
  CHECK(r.side(6.0) == Approx(4.4));
  CHECK(r.side(6.5) == Approx(4.35 - (1.0 - std::sqrt(0.75))));
  CHECK(r.side(7.0) == Approx(3.3));
  // Points of the outline: on the side, and at the middle of its ends.
  const auto rightmost = [](const agore::RollerProfile& of) { return of.outline().boundingRect(); };
  CHECK(rightmost(r).left() == Approx(-7.0));
  CHECK(rightmost(r).right() == Approx(7.0));
  CHECK(r.outline().contains(QPointF(-6.9, 0.99 * r.side(-6.9))));
  CHECK_FALSE(r.outline().contains(QPointF(-6.9, 1.01 * r.side(-6.9))));
  // A barrel of radius 10 over 6 from its middle: 10 - 8.
  agore::RollerProfile barrel{.half = 6.0, .radius = 5.0, .crown = 10.0};
  CHECK(barrel.side(6.0) == Approx(3.0));
  CHECK(barrel.side(-6.0) == Approx(3.0));
  barrel.central = 4.0;  // straight as far as 2
  CHECK(barrel.side(2.0) == Approx(5.0));
  CHECK(barrel.side(6.0) == Approx(5.0 - (10.0 - std::sqrt(84.0))));
  // A dome of radius 13 has fallen by 1 at 5 from its crest.
  agore::RollerProfile domed{.half = 7.0, .radius = 5.0};
  domed.dome = {0.0, 13.0};
  CHECK_FALSE(domed.outline().contains(QPointF(6.1, 4.9)));
  CHECK(domed.outline().contains(QPointF(5.9, 4.9)));
  CHECK(domed.outline().contains(QPointF(6.95, 0.1)));
  CHECK(domed.outline().contains(QPointF(-6.95, 4.9)));
  // The meridian never runs backward, for any dome and corner.
  for (const double slope : {-0.1, 0.0, 0.1})
    for (const double dome : {0.0, 5.8, 8.0, 13.0, 60.0})
      for (const double corner : {0.0, 0.1, 0.5, 2.0})
        for (const double crown : {0.0, 20.0}) {
          INFO("slope " << slope << ", dome " << dome << ", corner " << corner << ", crown "
                        << crown);
          agore::RollerProfile any{.half = 7.0, .radius = 5.0, .slope = slope, .crown = crown};
          any.dome = {dome, dome}, any.corner = {corner, corner};
          const std::vector<QPointF> way = any.meridian();
          for (std::size_t i = 1; i < way.size(); ++i) CHECK(way[i].x() >= way[i - 1].x() - 1e-12);
        }
}

TEST_CASE("pocket view: drawn skew is scaled with the clearances", "[unit][agore][pocket]") {
  using agore::drawn_skew;
  agore::RollerProfile roller{.half = 7.0, .radius = 5.0};
  // Straight: its ends go aside in proportion.
  CHECK(drawn_skew(roller.outline(), 0.0, 0.01, 10.0) == Approx(0.1).epsilon(0.05));
  CHECK(drawn_skew(roller.outline(), 0.0, -0.01, 10.0) < -0.09);
  CHECK(drawn_skew(roller.outline(), 0.0, 0.0, 10.0) == Approx(0.0).margin(1e-9));
  CHECK(drawn_skew(roller.outline(), 0.0, 0.03, 1.0) == Approx(0.03));
  CHECK(drawn_skew(roller.outline(), 0.0, 0.5, 1e3) <= adore::kPi / 3.0 + 1e-12);
  // A barrel: its arc goes aside by (R - r)(1 - cos skew), up to the arc's end at 0.19 rad.
  roller.crown = 36.0;
  const double drawn = drawn_skew(roller.outline(), 0.0, 0.06, 9.0);
  CHECK(std::sin(0.5 * drawn) == Approx(3.0 * std::sin(0.03)).epsilon(0.02));
  // However small: 0.1 degrees is a tenth of a chord of the drawn arc. With a cone, too.
  for (const double slope : {0.0, -0.1})
    for (const double lean : {0.0, 0.1})
      for (const double skew : {0.002, -0.002, 0.01, -0.02}) {
        CAPTURE(slope, lean, skew);
        roller.slope = slope;
        CHECK(drawn_skew(roller.outline(lean), slope, skew, 16.0) ==
              Approx(4.0 * skew).epsilon(0.15));
      }
}

TEST_CASE("pocket view: roller and pocket drawn → ratio of the gaps kept",
          "[unit][agore][pocket]") {
  using agore::moved, agore::pocket_gaps;
  // At the second wall, at the first, in the middle, one part of four; jammed, and overlapping.
  CHECK(moved({1.0, 1.0}, {3e-6, 0.0}) == Approx(1.0));
  CHECK(moved({1.0, 1.0}, {-1e-9, 3e-6}) == Approx(-1.0));
  CHECK(moved({1.0, 1.0}, {2e-6, 2e-6}) == Approx(0.0));
  CHECK(moved({3.0, 1.0}, {1e-6, 3e-6}) == Approx(-2.0));
  CHECK(moved({1.0, 1.0}, {0.0, -1e-9}) == Approx(0.0));
  CHECK(moved({-1.0, 0.5}, {0.0, 1e-6}) == Approx(0.75));
  for (const double crown : {0.0, 36.0})
    for (const double taper : {0.0, -0.1})
      for (const double skew : {0.0, 0.2, -0.1}) {
        CAPTURE(crown, taper, skew);
        const agore::RollerProfile shape{
            .half = 7.0, .radius = 5.0, .slope = taper, .crown = crown};
        const agore::PocketOutline pocket{
            .radius = 5.0, .roller_length = 14.0, .taper = taper, .clearance_1 = 3.0};
        const QPolygonF roller = agore::upright(shape.outline(), skew);
        const auto [sides, ends] = pocket_gaps(pocket, roller);
        // Moved by its play it just touches: a little less stays in the hole, a little more does
        // not.
        const QPainterPath hole = agore::pocket_hole(pocket);
        const auto inside = [&](QPointF way) {
          const QPolygonF there = roller.translated(way);
          return std::all_of(there.begin(), there.end(),
                             [&](const QPointF& p) { return hole.contains(p); });
        };
        if (ends[0] > 0.0 && ends[1] > 0.0) {
          CHECK(inside({0.99 * sides[1], 0.0}));
          CHECK(inside({-0.99 * sides[0], 0.0}));
        }
        CHECK_FALSE(inside({1.01 * sides[1] + 0.01, 0.0}));
        CHECK_FALSE(inside({-1.01 * sides[0] - 0.01, 0.0}));
        CHECK_FALSE(inside({0.0, 1.01 * ends[1] + 0.01}));
        CHECK_FALSE(inside({0.0, -1.01 * ends[0] - 0.01}));
      }
}

TEST_CASE("pocket with guide faces: a roller moved by its play touches them and fits between them",
          "[unit][agore][pocket]") {
  agore::PocketOutline pocket{.radius = 5.0, .roller_length = 14.0, .clearance_1 = 3.0};
  pocket.faces = {{-6.0, -2.0, 6.0, 6.5}, {2.0, 6.0, 6.5, 6.0}};  // ends nearer than the middle
  const QPainterPath hole = agore::pocket_hole(pocket);
  CHECK(hole.contains(QPointF(5.9, 5.9)));
  CHECK_FALSE(hole.contains(QPointF(6.1, 5.9)));
  CHECK(hole.contains(QPointF(6.4, 2.1)));
  CHECK(hole.contains(QPointF(6.6, 0.0)));  // between the faces
  CHECK_FALSE(hole.contains(QPointF(-6.1, -5.9)));
  CHECK(agore::pocket_half_size(pocket).width() == Approx(7.1));
  const agore::RollerProfile shape{.half = 7.0, .radius = 5.0};
  const auto play = agore::pocket_gaps(pocket, agore::upright(shape.outline(), 0.0));
  CHECK(play.sides[0] == Approx(1.0));
  CHECK(play.sides[1] == Approx(1.0));
}

TEST_CASE("views: a roller is drawn at the wall that carries it, and the key tells both gaps",
          "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  for (const bool first : {true, false}) {
    const TemporaryFolder folder;
    bearing::Bearing bearing = make_bearing(8);
    bearing.cage->pocket = bearing::PocketShape::Rectangular;  // surfaces in pairs, as rollers'
    results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
    results::H5Writer h5 =
        results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
    for (long step = 0; step <= 3; ++step) {
      scene::Snapshot snapshot = make_snapshot(bearing, step);
      for (auto& element : snapshot.elements) {
        for (std::size_t i = 0; i < 4; ++i) {
          const bool touched = (i % 2 == 0) == first;
          element.pocket[i].force = touched ? 5.0 : 0.0;
          element.pocket[i].gap = touched ? -1e-8 : 3.8e-4;
          element.pocket[i].theta = first ? 0.0 : adore::kPi;
        }
      }
      h5.write(recorder.record(snapshot));
    }
    h5.close();
    write_sizes(folder / "RESULTS.h5",
                {{"bearing_type", 3.0}, {"roller_length", 0.013}, {"roller_crown_radius", 0.04}});
    MotionPicture picture = open_animation(folder / "RESULTS.h5");
    ViewOptions options;
    options.view = View::Pocket;
    options.element = 2;
    // The cage turns to the right: the wall behind the roller drives it.
    CHECK(picture.svg({1280, 800}, 2, options)
              .contains(first ? "side walls: left touched, right 380 µm away"
                              : "side walls: left 380 µm away, right touched"));
    // Between roller and wall there is paper on the one side only.
    const QImage image = picture.image({1280, 800}, 2, options);
    const QColor paper = theme_of(options).surface, cage = theme_of(options).cage;
    const int row =
        static_cast<int>(MotionPicture::pictureAreas({0, 0, 1280, 800}, 1).at(0).center().y()) - 60;
    const auto is = [&](int x, const QColor& of) {
      const QColor c = image.pixelColor(x, row);
      return std::abs(c.red() - of.red()) + std::abs(c.green() - of.green()) +
                 std::abs(c.blue() - of.blue()) <
             30;
    };
    int from = 0, to = 779;
    while (from < to && !is(from, cage)) ++from;
    while (from < to && !is(to, cage)) --to;
    std::array<int, 2> free{};
    for (int x = from; x < to; ++x) free[x < (from + to) / 2 ? 0 : 1] += is(x, paper);
    CHECK(free[first ? 0 : 1] <= 1);
    CHECK(free[first ? 1 : 0] > 20);
    // The arrow of the force starts at that wall and ends at the contact.
    int wall = first ? from : to, red = 0, beyond = 0;
    while (is(wall, cage)) wall += first ? 1 : -1;
    for (int y = row - 100; y < row + 200; ++y)
      for (int x = 0; x < 780; ++x)
        if (image.pixelColor(x, y) == theme_of(options).red)
          ++red, beyond += first ? x > wall + 4 : x < wall - 4;
    INFO(red << " pixels of the arrow, " << beyond << " beyond the wall");
    CHECK(red > 40);
    CHECK(beyond == 0);
  }
}

TEST_CASE("views: unloaded wall → not marked as touched", "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  const TemporaryFolder folder;
  bearing::Bearing bearing = make_bearing(8);
  bearing.cage->pocket = bearing::PocketShape::Rectangular;
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= 3; ++step) {
    scene::Snapshot snapshot = make_snapshot(bearing, step);
    for (auto& element : snapshot.elements)
      for (std::size_t i = 0; i < 4; ++i)
        element.pocket[i].force = 0.0, element.pocket[i].gap = i % 2 == 0 ? 0.0 : 3.8e-4;
    h5.write(recorder.record(snapshot));
  }
  h5.close();
  write_sizes(folder / "RESULTS.h5", {{"bearing_type", 3.0}, {"roller_length", 0.013}});
  MotionPicture picture = open_animation(folder / "RESULTS.h5");
  ViewOptions options;
  options.view = View::Pocket;
  const QString words = test::all_words(picture.svg({1280, 800}, 2, options));
  INFO(words.toStdString());
  CHECK(words.contains("no side wall contact"));
  CHECK(words.contains("right 380 µm away"));
  CHECK_FALSE(words.contains("touched"));
}

TEST_CASE("the shape of a roller is what RESULTS.h5 says of it, in meters or inches",
          "[unit][agore][h5]") {
  using namespace adore::testing;
  const TemporaryFolder folder;
  write_run(folder);
  using Sizes = std::map<std::string, double>;
  Sizes sizes{{"bearing_type", 4.0},        {"roller_length", 0.014}, {"roller_half_angle", 0.05},
              {"roller_mass_offset", 1e-4}, {"cage_width", 0.02},     {"pocket_code", 0.0}};
  for (const double contact_angle : {0.2, -0.2}) {  // wherever the axis leans as the run begins
    sizes["contact_angle"] = contact_angle;
    write_sizes(folder / "RESULTS.h5", sizes);
    for (const auto units : {deck::UnitSystem::SI, deck::UnitSystem::English}) {
      const double unit = units == deck::UnitSystem::SI ? 1.0 : 0.0254;
      const Animation a = prepare(results::MotionFile::open(folder / "RESULTS.h5", units));
      const agore::RollerProfile roller = agore::roller_profile(a);
      CHECK(roller.half == Approx(0.007 / unit));
      CHECK(roller.side(-roller.half) - roller.side(roller.half) ==
            Approx(0.014 / unit * std::tan(0.05)));
      CHECK(roller.mass_centre == Approx(1e-4 / unit));
      // A file of an earlier version has neither corners, crown nor domes.
      CHECK(roller.corner == std::array<double, 2>{});
      CHECK(roller.dome == std::array<double, 2>{});
      CHECK(roller.crown == 0.0);
      const agore::CageProfile cage = agore::cage_profile(a);
      CHECK(cage.half_width == Approx(0.01 / unit));
      CHECK(cage.hole == Approx((0.007 + 0.0002) / unit));  // half of clearance I at each end
      // However a roller lies in its pocket, its walls are beyond it.
      for (const double cone : {0.0, 8.0, -20.0}) {
        const double lean = agore::nominal_lean(a) - cone * adore::kPi / 180.0;
        const auto walls = agore::end_wall_offsets(roller, lean);
        double most[] = {0.0, 0.0};
        for (const QPointF& p : roller.outline().toFillPolygon()) {
          const double u = agore::tilted_point(0.0, 0.0, lean, p.x(), p.y()).x();
          most[u < 0.0 ? 0 : 1] = std::max(most[u < 0.0 ? 0 : 1], std::abs(u));
        }
        for (const std::size_t end : {0U, 1U})
          CHECK(roller.half + walls[end] == Approx(std::max(most[end], roller.half)));
      }
    }
  }
  write_sizes(folder / "RESULTS.h5", {{"roller_plus_x_corner_radius", 3e-4},
                                      {"roller_minus_x_end_radius", 0.1},
                                      {"roller_crown_radius", 0.2},
                                      {"roller_central_length", 0.004}});
  for (const auto units : {deck::UnitSystem::SI, deck::UnitSystem::English}) {
    const double unit = units == deck::UnitSystem::SI ? 1.0 : 0.0254;
    const agore::RollerProfile roller =
        agore::roller_profile(prepare(results::MotionFile::open(folder / "RESULTS.h5", units)));
    CHECK(roller.corner[0] == 0.0);
    CHECK(roller.corner[1] == Approx(3e-4 / unit));
    CHECK(roller.dome[0] == Approx(0.1 / unit));
    CHECK(roller.dome[1] == 0.0);
    CHECK(roller.crown == Approx(0.2 / unit));
    CHECK(roller.central == Approx(0.004 / unit));
  }
  // Without the file a roller is as long as wide.
  Animation alone;
  alone.file.bearing_type = 4;
  alone.file.geometry.element_radius = 0.005;
  CHECK(agore::roller_profile(alone).half == 0.005);
  CHECK(agore::roller_profile(alone).side(-0.005) == agore::roller_profile(alone).side(0.005));
}

TEST_CASE("section view: drawn pocket opening equals that of the cage", "[unit][agore][pocket]") {
  agore::CageProfile cage{.half_width = 9.0, .low = -3.0, .high = 3.0, .hole = 5.0};
  CHECK(cage.pocket_half_length_at(-3.0, 0) == 5.0);
  cage.round = 5.0;  // a sphere
  CHECK(cage.pocket_half_length_at(3.0, 1) == Approx(4.0));
  cage.round = 0.0, cage.flare = 0.1;  // a cone that opens outwards
  CHECK(cage.pocket_half_length_at(3.0, 0) == Approx(5.3));
  CHECK(cage.pocket_half_length_at(-3.0, 1) == Approx(4.7));
  cage.leaning = {0.25, 0.5};  // of a roller that leans in its pocket
  CHECK(cage.pocket_half_length_at(0.0, 0) == Approx(5.25));
  CHECK(cage.pocket_half_length_at(0.0, 1) == Approx(5.5));
}

TEST_CASE("section view: guide land ends with its bar", "[unit][agore]") {
  agore::CageProfile cage{.half_width = 9.0, .low = -3.0, .high = 3.0, .hole = 5.5};
  using Part = std::pair<double, double>;
  CHECK(agore::land_range_on_bar(cage, 30.0, {0, 5.0, 8.0, 33.0, 33.1}) == Part{5.5, 8.0});
  CHECK(agore::land_range_on_bar(cage, 30.0, {1, -8.0, -5.0, 27.0, 26.9}) == Part{-8.0, -5.5});
  CHECK(agore::land_range_on_bar(cage, 30.0, {1, 6.0, 8.0, 27.0, 26.9}) == Part{6.0, 8.0});
  CHECK(agore::land_range_on_bar(cage, 30.0, {0, -8.0, 8.0, 33.0, 33.1}) == Part{-8.0, 8.0});
}

TEST_CASE("flange view: roller rotated by Phi of SOL1, its +x end up", "[gui][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  write_run(folder);
  write_sizes(folder / "RESULTS.h5", {{"bearing_type", 2.0},
                                      {"roller_length", 0.014},
                                      {"inner_flange_minus_x_height", 0.002},
                                      {"inner_flange_plus_x_height", 0.002}});
  Animation animation = open_motion(folder / "RESULTS.h5");
  ViewOptions options;
  options.view = View::Flange;
  options.element = 3;
  const double theta = 0.7;
  for (const double phi : {0.2, -0.12, 0.0}) {
    // Turned to its azimuth, then by Phi about the way outwards: its axis is
    // (cos Phi, sin Phi cos theta, sin Phi sin theta), of which SOL1 has asin of that along
    // y = z x x of the azimuth frame.
    auto& element = animation.file.frames[1].elements[2];
    element.theta = theta;
    element.angles = {theta, 0.0, phi};
    QImage image(600, 600, QImage::Format_RGB32);
    image.fill(theme_of(options).surface);
    QPainter painter(&image);
    paint_picture(painter, QRectF(image.rect()), animation, 1, options);
    painter.end();
    // Middle of the text column around the middle row of the roller.
    const auto middle = [&](int x) {
      const auto paper = [&](int y) { return image.pixelColor(x, y) == theme_of(options).surface; };
      int top = 270, bottom = 270;
      while (top > 0 && !paper(top)) --top;
      while (bottom < 599 && !paper(bottom)) ++bottom;
      REQUIRE(bottom - top > 100);
      return 0.5 * (top + bottom);
    };
    constexpr int kWay = 90;
    const double slope = (middle(300 - kWay) - middle(300 + kWay)) / (2.0 * kWay);
    CAPTURE(phi, slope);
    CHECK(slope == Approx(std::tan(phi)).margin(0.012));  // up is less of y in a picture
  }
}
