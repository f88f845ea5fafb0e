#include "desktop/axis_scale.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/even_digits.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsTextItem>
#include <QImage>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace adore;
using namespace adore::desktop;

namespace {

ChartPage wave_page(int points, int panels) {
  ChartPage page;
  page.title = "Waves";
  page.x_title = "Bearing rotation";
  page.x_unit = "rev";
  for (int i = 0; i < points; ++i) page.x.push_back(3.0 * i / (points - 1));
  for (int p = 0; p < panels; ++p) {
    ChartPanel panel{"Force", "N", {}, false};
    for (const char* name : {"outer", "inner"}) {
      ChartCurve curve{name, {}, {}};
      for (const double x : page.x) curve.y.push_back(100 * std::sin(6.28 * x) + 10 * p);
      panel.curves.push_back(std::move(curve));
    }
    page.panels.push_back(std::move(panel));
  }
  return page;
}

}  // namespace

TEST_CASE("zero_padded_quantity: numbers of a list have one count of digits", "[unit]") {
  using desktop::zero_padded_quantity;
  CHECK(zero_padded_quantity(312.2, "N", 4) == "312.2 N");
  CHECK(zero_padded_quantity(272.0, "N", 4) == "272.0 N");
  CHECK(zero_padded_quantity(272.0, "N", 3) == "272 N");
  CHECK(zero_padded_quantity(0.052, "s", 3) == "52.0 ms");
  CHECK(zero_padded_quantity(0.0879, "s", 3) == "87.9 ms");
  CHECK(zero_padded_quantity(0.5, "", 3) == "0.500");
  CHECK(zero_padded_quantity(-2.5, "N", 3).ends_with("2.50 N"));
  CHECK(zero_padded_quantity(0.0, "N", 3) == desktop::pretty_quantity(0.0, "N", 3));
  // Never another number, and never more digits than asked for.
  for (double value = 1.234e-9; value < 1e9; value *= 7.3)
    for (const int digits : {2, 3, 4}) {
      const std::string plain = desktop::pretty_quantity(value, "N", digits),
                        even = zero_padded_quantity(value, "N", digits);
      CAPTURE(plain, even);
      CHECK(std::stod(even) == std::stod(plain));
      CHECK(even.size() >= plain.size());
    }
}

TEST_CASE("axis_scale: ticks 1, 2 or 5 times a power of ten, enclose the data", "[unit]") {
  for (const double span : {1.0, 3.7, 0.021, 8.8e5, 4e-9}) {
    const AxisScale axis = value_axis(0.3 * span, 1.3 * span, "", 5);
    const double mantissa = axis.step / std::pow(10.0, std::floor(std::log10(axis.step) + 1e-9));
    CHECK((std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 ||
           std::abs(mantissa - 5) < 1e-9));
    CHECK(axis.min <= axis.shown(0.3 * span));
    CHECK(axis.max >= axis.shown(1.3 * span));
    CHECK((axis.max - axis.min) / axis.step <=
          7.5);  // five parts wanted, rounding outwards adds two at most
  }
}

TEST_CASE("axis_scale: outliers do not extend the axis", "[unit]") {
  // A gap of 120 µm with contacts of 3 µm: the axis begins below those, not at -100 µm.
  const AxisScale gap = value_axis(-3e-6, 120e-6, "m", 2);
  REQUIRE(gap.step == Approx(50.0).margin(51.0));
  CHECK(gap.min < -3.0);
  CHECK(gap.min > -20.0);
  for (const double low : {-1.0, -0.2, -0.05, -0.01, 0.0, 0.3})
    for (const double high : {0.35, 0.5, 1.0, 1.01, 1.1, 3.7})
      for (const int parts : {2, 3, 5, 8}) {
        const AxisScale axis = value_axis(low, high, "", parts);
        CAPTURE(low, high, parts, axis.min, axis.max, axis.step);
        CHECK(axis.min <= low);
        CHECK(axis.max >= high);
        CHECK(axis_ticks(axis).size() >= 2);
        // Either the axis ends near the values, or they fill a good part of its last step.
        const auto idle = [&](double beyond) { return beyond < 0.9 * axis.step; };
        CHECK(idle(low - axis.min));
        CHECK(idle(axis.max - high));
      }
}

TEST_CASE("axis_scale: units take SI prefixes, or powers of ten where they have none", "[unit]") {
  CHECK(value_axis(0, 3.2e-6, "m", 5).unit == "µm");
  CHECK(value_axis(0, 3.2e-6, "m", 5).factor == Approx(1e-6));
  CHECK(value_axis(0, 12500, "N", 5).unit == "kN");
  CHECK(value_axis(0, 420, "N", 5).unit == "N");
  CHECK(value_axis(-3e6, 2e6, "rpm/s", 5).unit == "10⁶ rpm/s");
  CHECK(value_axis(0, 8000, "rpm", 5).unit == "rpm");
  CHECK(value_axis(0, 4e-17, "m^3/s", 5).unit == "10⁻¹⁸ m³/s");
  CHECK(value_axis(0, 0.2, "N.m", 5).unit == "mN·m");
  CHECK(tight_axis(0, 0.018, "s", 5).unit == "ms");
}

TEST_CASE("axis_scale: a signal that hardly moves is shown from a base value", "[unit]") {
  const AxisScale axis = value_axis(0.0325 - 4e-7, 0.0325 + 4e-7, "m", 5);
  CHECK(axis.unit == "nm");
  CHECK(axis.offset == Approx(0.0325).epsilon(1e-9));
  CHECK(axis.offset_text == "32.5 mm");
  CHECK(axis.shown(0.0325 + 4e-7) == Approx(400.0).epsilon(1e-6));
}

TEST_CASE("axis_scale: constants, zeros and missing values still give a drawable axis", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const auto& [low, high] : {std::pair{0.0, 0.0},
                                  {5.0, 5.0},
                                  {-2e-30, -2e-30},
                                  {nan, nan},
                                  {inf, -inf},
                                  {1e300, 1e300},
                                  {9e307, 9e307},
                                  {-1.7e308, 1.7e308},
                                  {5e-324, 5e-324}}) {
    const AxisScale axis = value_axis(low, high, "m", 5);
    CHECK(std::isfinite(axis.min));
    CHECK(std::isfinite(axis.max));
    CHECK(axis.max > axis.min);
    CHECK(axis.step > 0.0);
    CHECK((axis.max - axis.min) / axis.step < 20.0);
  }
}

TEST_CASE("axis_scale: numbers for people carry no negative zero and a true minus sign", "[unit]") {
  CHECK(tick_text(-0.4, 1) == "−0.4");
  CHECK(tick_text(-1e-17, 1) == "0.0");
  CHECK(pretty_number(1416.3, 3) == "1416");
  CHECK(pretty_number(0.43, 3) == "0.43");
  CHECK(pretty_number(-2.5e-9, 3) == "−2.5·10⁻⁹");
  CHECK(pretty_quantity(3.2e-6, "m", 3) == "3.2 µm");
  CHECK(pretty_quantity(8.3936e-3, "s", 5) == "8.3936 ms");
}

TEST_CASE("chart_page: lines break at missing values and where an angle starts again", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> x{0, 1, 2, 3, 4, 5, 6};
  CHECK(drawable_polylines(x, {0, 1, nan, 3, 4, 5, 6}, 0, 6, 100, false).size() == 2);
  CHECK(drawable_polylines(x, {340, 350, 359, 5, 15, 25, 35}, 0, 6, 100, true).size() == 2);
  CHECK(drawable_polylines(x, {340, 350, 359, 5, 15, 25, 35}, 0, 6, 100, false).size() == 1);
  const auto zoomed = drawable_polylines(x, {0, 1, 2, 3, 4, 5, 6}, 2.5, 3.5, 100, false);
  REQUIRE(zoomed.size() == 1);
  CHECK(zoomed.front().x == std::vector<double>{2, 3, 4});  // one neighbor beyond each end
}

TEST_CASE("chart_page: thinning a long line keeps every peak", "[unit]") {
  std::vector<double> x, y;
  for (int i = 0; i < 200000; ++i) {
    x.push_back(i);
    y.push_back(std::sin(0.7 * i));
  }
  y[123457] = 50.0;
  y[61001] = -40.0;
  const auto pieces = drawable_polylines(x, y, 0, 199999, 800, false);
  REQUIRE(pieces.size() == 1);
  CHECK(pieces.front().x.size() <= 4 * 801);
  CHECK(*std::max_element(pieces.front().y.begin(), pieces.front().y.end()) == 50.0);
  CHECK(*std::min_element(pieces.front().y.begin(), pieces.front().y.end()) == -40.0);
  CHECK(std::is_sorted(pieces.front().x.begin(), pieces.front().x.end()));
}

TEST_CASE("chart_scene: panels stand over one abscissa with a series per curve", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({1280, 800});
  scene.setPage(wave_page(5000, 3));
  REQUIRE(scene.plotAreas().size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(scene.lineCount(i) == 2);
    CHECK(scene.plotAreas()[i].left() == scene.plotAreas()[0].left());
    CHECK(scene.plotAreas()[i].width() == scene.plotAreas()[0].width());
    CHECK(scene.sceneRect().contains(scene.plotAreas()[i]));
  }
  std::map<QString, int> texts;
  for (auto* item : scene.items())
    if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item)) ++texts[text->text()];
  CHECK(texts["Force [N]"] == 3);
  CHECK(texts["Bearing rotation [rev]"] == 1);
  CHECK_FALSE(scene.plotAreas()[0].intersects(scene.plotAreas()[1]));
  // No text or curve reaches beyond the page: nothing is clipped.
  for (auto* item : scene.items())
    if (item->parentItem() == nullptr)
      CHECK(scene.sceneRect().contains(item->sceneBoundingRect().adjusted(1, 1, -1, -1)));
}

TEST_CASE("chart_scene: zooming follows the abscissa and keeps inside the data", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPage(wave_page(1000, 1));
  CHECK(scene.viewHigh() == Approx(3.0));
  scene.setView(1.0, 2.0);
  CHECK(scene.viewLow() == 1.0);
  CHECK(scene.abscissaAt(scene.sceneXAt(1.25)) == Approx(1.25));
  CHECK(scene.abscissaAt(scene.plotAreas()[0].right()) == Approx(2.0));
  scene.setView(-5.0, 99.0);
  CHECK(scene.viewLow() == 0.0);
  CHECK(scene.viewHigh() == Approx(3.0));
  const QPointF middle(scene.sceneXAt(0.75), scene.plotAreas()[0].center().y());
  CHECK(scene.readout(middle).contains("outer −"));
  CHECK(scene.readout({1, 1}).isEmpty());
}

TEST_CASE("chart_scene: logarithmic axis → curves with hidden values are named", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x = {0.0, 1.0, 2.0};
  page.panels = {
      {"Spin/roll", "", {{"outer", {0.1, 0.2, 0.3}, {}}, {"inner", {-0.1, -0.2, -0.1}, {}}}},
      {"Angle", "deg", {{"outer", {-3.0, -2.0, -1.0}, {}}}}};
  ChartScene scene;
  const auto words = [&](bool log) {
    for (ChartPanel& panel : page.panels) panel.log = log;
    scene.setPage(page);
    QString text;
    for (auto* item : scene.items()) {
      if (auto* simple = dynamic_cast<QGraphicsSimpleTextItem*>(item)) text += simple->text() + "|";
      if (auto* rich = dynamic_cast<QGraphicsTextItem*>(item)) text += rich->toPlainText() + "|";
    }
    return text;
  };
  CHECK(words(true).contains("inner (not above 0)|"));
  CHECK_FALSE(words(true).contains("outer (not above 0)"));
  CHECK(words(true).count("No value is above 0") == 1);
  CHECK_FALSE(words(false).contains("above 0"));
}

TEST_CASE("chart_scene: a page without panels shows its sentence, in both themes", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.note = "The stored steps are not equally spaced.";
  for (const auto kind : {ThemeKind::Light, ThemeKind::Dark}) {
    ChartScene scene;
    scene.setTheme(theme(kind));
    scene.setPage(page);
    const QImage image = scene.image({640, 400});
    CHECK(image.pixelColor(3, 3) == theme(kind).surface);
    int inked = 0;
    for (int y = 0; y < 400; ++y)
      for (int x = 0; x < 640; ++x) inked += image.pixelColor(x, y) != theme(kind).surface;
    CHECK(inked > 300);
  }
}
