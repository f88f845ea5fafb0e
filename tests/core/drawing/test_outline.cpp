#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "deck/templates.hpp"
#include "drawing/outline_model.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_rollers.hpp"
#include "tribology/traction_curve.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace adore;
using namespace adore::drawing;

namespace {

const Shape& shape_of(const Drawing& drawing, const std::string& name, std::size_t pane = 0) {
  const auto& shapes = drawing.panes.at(pane).shapes;
  const auto found = std::find_if(shapes.begin(), shapes.end(),
                                  [&](const Shape& shape) { return shape.name == name; });
  INFO("shape " << name);
  REQUIRE(found != shapes.end());
  return *found;
}

const Dimension& measure_of(const Drawing& drawing, const std::string& variable, int instance = 1) {
  for (const Pane& pane : drawing.panes)
    for (const Dimension& d : pane.dimensions)
      if (d.variable == variable && d.instance == instance) return d;
  FAIL("no measure of " << variable);
  return drawing.panes.front().dimensions.front();
}

double length_of(const Dimension& d) { return std::hypot(d.to.x - d.from.x, d.to.y - d.from.y); }

double angle_of(const Dimension& d) {
  const double a = std::atan2(d.from.y - d.centre.y, d.from.x - d.centre.x);
  const double b = std::atan2(d.to.y - d.centre.y, d.to.x - d.centre.x);
  return std::abs(std::remainder(b - a, 2.0 * std::acos(-1.0)));
}

/// Largest distance of a point of one drawing from its likeness in another.
double difference(const Drawing& a, const Drawing& b) {
  double out = 0.0;
  const auto take = [&](const Point& p, const Point& q) {
    out = std::max({out, std::abs(p.x - q.x), std::abs(p.y - q.y)});
  };
  REQUIRE(a.panes.size() == b.panes.size());
  for (std::size_t i = 0; i < a.panes.size(); ++i) {
    const Pane &p = a.panes[i], &q = b.panes[i];
    REQUIRE(p.shapes.size() == q.shapes.size());
    REQUIRE(p.dimensions.size() == q.dimensions.size());
    for (std::size_t k = 0; k < p.shapes.size(); ++k) {
      REQUIRE(p.shapes[k].paths.size() == q.shapes[k].paths.size());
      REQUIRE(p.shapes[k].circles.size() == q.shapes[k].circles.size());
      for (std::size_t j = 0; j < p.shapes[k].paths.size(); ++j) {
        REQUIRE(p.shapes[k].paths[j].size() == q.shapes[k].paths[j].size());
        for (std::size_t n = 0; n < p.shapes[k].paths[j].size(); ++n)
          take(p.shapes[k].paths[j][n], q.shapes[k].paths[j][n]);
      }
      for (std::size_t j = 0; j < p.shapes[k].circles.size(); ++j)
        out =
            std::max(out, std::abs(p.shapes[k].circles[j].radius - q.shapes[k].circles[j].radius));
    }
    for (std::size_t k = 0; k < p.dimensions.size(); ++k) {
      take(p.dimensions[k].from, q.dimensions[k].from);
      take(p.dimensions[k].to, q.dimensions[k].to);
    }
  }
  return out;
}

bool finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Has everything that a painter maps a place?
bool all_finite(const Drawing& drawing) {
  for (const Pane& pane : drawing.panes) {
    for (const Shape& shape : pane.shapes) {
      if (shape.paths.empty() && shape.circles.empty()) return false;
      for (const Path& path : shape.paths)
        if (!std::all_of(path.begin(), path.end(), finite)) return false;
      for (const Circle& c : shape.circles)
        if (!finite(c.centre) || !(c.radius > 0.0) || !std::isfinite(c.radius)) return false;
    }
    for (const Dimension& d : pane.dimensions)
      if (!finite(d.from) || !finite(d.to) || !finite(d.centre)) return false;
    for (const Arrow& arrow : pane.arrows)
      if (!std::all_of(arrow.path.begin(), arrow.path.end(), finite)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("outline: every view of every example deck is drawn", "[unit][outline]") {
  for (const deck::TemplateInfo& info : deck::templates()) {
    const deck::Deck deck = deck::new_deck(info.name);
    const std::vector<View> views = views_of(deck);
    CHECK(views.size() >= 5);
    for (const View view : views) {
      INFO(info.name << ", " << title_of(view));
      const Drawing drawing = draw(view, deck);
      CHECK(drawing.reason == "");
      REQUIRE_FALSE(drawing.panes.empty());
      CHECK(drawing.view == view);
      CHECK_FALSE(drawing.panes.front().shapes.empty());
      CHECK(all_finite(drawing));
    }
  }
}

TEST_CASE("outline: section of a ball deck → sizes of the deck", "[unit][outline]") {
  const deck::Deck deck = deck::new_deck("ball");
  const Drawing section = draw(View::CrossSection, deck);
  const Circle& ball = shape_of(section, "ball").circles.at(0);
  CHECK(ball.radius == 0.5 * deck.si("bReDia"));
  CHECK(ball.centre.y == 0.5 * deck.si("pitchDia"));
  // Rounding of sums of lengths near 0.1 m.
  const double tiny = 1e-15;
  CHECK(length_of(measure_of(section, "bReDia")) == Approx(deck.si("bReDia")).margin(tiny));
  CHECK(length_of(measure_of(section, "brgOD")) == 0.5 * deck.si("brgOD"));
  CHECK(length_of(measure_of(section, "raceWidth1")) == deck.si("raceWidth1"));
  CHECK(length_of(measure_of(section, "raceCurFac1")) ==
        Approx(deck.si("raceCurFac1") * deck.si("bReDia")).epsilon(1e-12));
  CHECK(angle_of(measure_of(section, "freeConAng")) ==
        Approx(deck.si("freeConAng")).epsilon(1e-12));
  CHECK(measure_of(section, "pitchDia").label == "pitchDia = 0.06 m");
  // The contact line stands at the contact angle and passes through the ball center.
  const Path& line = shape_of(section, "contact line").paths.at(0);
  const double across = line.back().x - line.front().x, up = line.back().y - line.front().y;
  CHECK(std::atan2(across, up) == Approx(deck.si("freeConAng")).epsilon(1e-12));
  CHECK(0.5 * (line.back().y + line.front().y) == Approx(ball.centre.y).epsilon(1e-14));
  // The ball touches both grooves there and overlaps neither ring.
  for (const auto& [name, inside] : {std::pair{"outer ring", false}, {"inner ring", true}}) {
    const Path& ring = shape_of(section, name).paths.at(0);
    double nearest = 1.0, angle = 0.0;
    for (const Point& p : ring) {
      const double dx = p.x - ball.centre.x, dy = p.y - ball.centre.y;
      if (std::hypot(dx, dy) >= nearest) continue;
      nearest = std::hypot(dx, dy);
      angle = std::atan2(inside ? -dx : dx, inside ? -dy : dy);
    }
    INFO(name);
    // The groove is sampled: its nearest corner lies up to a chord beside the contact, where the
    // groove has parted from the ball by less than a micrometre.
    CHECK(nearest >= ball.radius - 1e-9);
    CHECK(nearest < ball.radius + 1e-6);
    CHECK(angle == Approx(deck.si("freeConAng")).margin(0.06));
  }
}

TEST_CASE("outline: side view → all elements on the pitch circle", "[unit][outline]") {
  for (const char* name : {"ball", "tapered"}) {
    const deck::Deck deck = deck::new_deck(name);
    const Drawing side = draw(View::AdditionalView, deck);
    const double pitch = deck.integer("kBrg") == 1
                             ? deck.si("pitchDia")
                             : setup::build_roller_geometry(deck).pitch_diameter;
    int elements = 0;
    for (const Shape& shape : side.panes[0].shapes) {
      if (shape.part != Part::Element) continue;
      ++elements;
      const Circle& c = shape.circles.at(0);
      CHECK(c.radius == 0.5 * deck.si("bReDia"));
      CHECK(std::hypot(c.centre.x, c.centre.y) == Approx(0.5 * pitch).epsilon(1e-14));
    }
    CHECK(elements == deck.integer("nRe"));
    // Element 1 is at the top, element 2 towards -y (azimuth about +X from Z).
    CHECK(shape_of(side, "element 1").circles[0].centre.y == Approx(0.5 * pitch).epsilon(1e-14));
    CHECK(shape_of(side, "element 2").circles[0].centre.x < 0.0);
    CHECK(shape_of(side, "cage").paths.size() == static_cast<std::size_t>(elements));
  }
}

TEST_CASE("outline: roller → profile of the deck", "[unit][outline]") {
  const deck::Deck deck = deck::new_deck("cylindrical");
  const Drawing element = draw(View::Element, deck);
  const Path& roller = shape_of(element, "roller").paths.at(0);
  double left = 0.0, right = 0.0, high = 0.0;
  for (const Point& p : roller) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    high = std::max(high, p.y);
  }
  CHECK(right - left == Approx(deck.si("bReLen")).epsilon(1e-12));
  CHECK(high == Approx(0.5 * deck.si("bReDia")).epsilon(1e-12));
  CHECK(length_of(measure_of(element, "bReCenLen")) == Approx(deck.si("bReCenLen")).epsilon(1e-12));
  // The profile falls by e²/(2 Rc) beyond the land; e⁴/(8 Rc³) is far below the tolerance.
  const Path& drop = shape_of(element, "profile", 1).paths.at(0);
  const double e = drop.back().x - 0.5 * deck.si("bReCenLen");
  CHECK(-drop.back().y == Approx(e * e / (2.0 * deck.si("bReCrn"))).epsilon(1e-6));
}

TEST_CASE("outline: tapered rollers → between their cones, which meet in the apex",
          "[unit][outline]") {
  const deck::Deck deck = deck::new_deck("tapered");
  const Drawing section = draw(View::CrossSection, deck);
  CHECK(angle_of(measure_of(section, "raceTaper1")) ==
        Approx(deck.si("raceTaper1")).epsilon(1e-12));
  CHECK(angle_of(measure_of(section, "raceTaper2")) ==
        Approx(deck.si("raceTaper2")).epsilon(1e-12));
  CHECK(length_of(measure_of(section, "raceLandLmt1")) ==
        Approx(deck.si("raceLandLmt1")).epsilon(1e-12));
  const Drawing flange = draw(View::Flange, deck);
  CHECK(length_of(measure_of(flange, "flngHt12")) == Approx(deck.si("flngHt12")).epsilon(1e-12));
  CHECK(angle_of(measure_of(flange, "flngAng12")) == Approx(deck.si("flngAng12")).epsilon(1e-9));
}

TEST_CASE("outline: English deck → same drawing as in SI", "[unit][outline]") {
  const deck::Deck si = deck::new_deck("ball"), english = deck::new_deck("ball-english");
  for (const View view : {View::CrossSection, View::AdditionalView, View::Element, View::Pocket,
                          View::Lands, View::Traction}) {
    INFO(title_of(view));
    // The English numbers are the SI ones rounded to 16 digits.
    CHECK(difference(draw(view, si), draw(view, english)) < 1e-14);
  }
  CHECK(measure_of(draw(View::CrossSection, english), "bReDia").label == "bReDia = 0.5 in");
  CHECK(draw(View::Traction, english).panes[0].axes[0].unit == "in/s");
}

TEST_CASE("outline: pocket and lands → their clearances", "[unit][outline]") {
  const deck::Deck deck = deck::new_deck("ball");
  const Drawing pocket = draw(View::Pocket, deck);
  CHECK(length_of(measure_of(pocket, "bPocCls1")) == Approx(deck.si("bPocCls1")).epsilon(1e-9));
  const Drawing lands = draw(View::Lands, deck);
  for (const int i : {1, 2}) {
    CHECK(length_of(measure_of(lands, "cageGsWidth", i)) ==
          Approx(deck.si("cageGsWidth", i)).epsilon(1e-12));
    // Diametral 0.3 mm, exaggerated as the title says.
    const double ratio =
        length_of(measure_of(lands, "cageGsCls", i)) / (0.5 * deck.si("cageGsCls", i));
    CHECK(ratio == Approx(std::round(ratio)).epsilon(1e-9));
    CHECK(lands.panes[0].title.find("× " + std::to_string(std::lround(ratio))) !=
          std::string::npos);
  }
}

TEST_CASE("outline: drawn cage = computed cage in every example deck", "[unit][outline]") {
  int cages = 0;
  for (const deck::TemplateInfo& example : deck::templates()) {
    CAPTURE(example.name);
    deck::Deck deck = deck::new_deck(example.name);
    deck.set("mode", "-1");
    deck.complete();
    const auto drawn = outline_cage(deck);
    const auto computed = setup::build_bearing(deck).cage;
    REQUIRE(drawn.has_value() == computed.has_value());
    if (!drawn) continue;
    ++cages;
    for (const auto member :
         {&bearing::Cage::outer_diameter, &bearing::Cage::inner_diameter, &bearing::Cage::width,
          &bearing::Cage::clearance_outer, &bearing::Cage::clearance_inner,
          &bearing::Cage::pocket_clearance_2, &bearing::Cage::cone_angle})
      CHECK((*drawn).*member == (*computed).*member);
    CHECK(drawn->pocket == computed->pocket);
    REQUIRE(drawn->lands.size() == computed->lands.size());
    for (std::size_t i = 0; i < drawn->lands.size(); ++i) {
      CHECK(drawn->lands[i].guide == computed->lands[i].guide);
      for (const auto member : {&bearing::GuideLand::diameter, &bearing::GuideLand::width,
                                &bearing::GuideLand::edge, &bearing::GuideLand::clearance})
        CHECK(drawn->lands[i].*member == computed->lands[i].*member);
    }
  }
  CHECK(cages > 3);
}

TEST_CASE("outline: every ball pocket shape → its clearances", "[unit][outline]") {
  deck::Deck deck = deck::new_deck("ball");
  for (const char* code : {"0", "1", "2", "3", "4"}) {
    deck.set("kPocType", code);
    deck.set("bPocCls1", "0.0004");
    deck.set("bPocCls2", "0.0006");
    INFO("kPocType " << code);
    const Drawing pocket = draw(View::Pocket, deck);
    CHECK(pocket.reason == "");
    REQUIRE(pocket.panes.size() == 2);
    const bool second = std::string(code) >= "2";
    const auto& all = pocket.panes[0].dimensions;
    CHECK(std::any_of(all.begin(), all.end(), [](const Dimension& d) {
            return d.variable == "bPocCls2" && !d.minor;
          }) == second);
    if (second && code[0] != '4')
      CHECK(length_of(measure_of(pocket, "bPocCls2")) == Approx(0.0006).epsilon(1e-9));
  }
}

TEST_CASE("outline: traction curves → those of the law", "[unit][outline]") {
  const deck::Deck deck = deck::new_deck("ball");
  const Drawing traction = draw(View::Traction, deck);
  const auto law = tribology::traction_curve(
      static_cast<int>(deck.integer("kTracType")),
      {deck.si("reRaceTC1"), deck.si("reRaceTC2"), deck.si("reRaceTC3"), deck.si("reRaceTC4")});
  const Path& curve = shape_of(traction, "element and race").paths.at(0);
  REQUIRE(curve.size() > 100);
  for (const Point& p : curve) CHECK(p.y == tribology::traction_coefficient(law, p.x));
  CHECK(measure_of(traction, "reRaceTC2").to.y == Approx(deck.si("reRaceTC2")).epsilon(1e-9));
  CHECK(measure_of(traction, "reRaceTC4").to.x == deck.si("reRaceTC4"));
}

TEST_CASE("outline: arrows → directions of the loads", "[unit][outline]") {
  deck::Deck deck = deck::new_deck("ball");
  deck.set("appLoadY", "-300");
  const Drawing side = draw(View::AdditionalView, deck);
  const auto arrow = [&](const std::string& name) {
    for (const Arrow& a : side.panes[0].arrows)
      if (a.variable == name) return a;
    FAIL("no arrow " << name);
    return Arrow();
  };
  CHECK(arrow("appLoadY").path.back().x < 0.0);
  CHECK(arrow("appLoadZ").path.back().y > 0.0);
  CHECK(arrow("appLoadZ").label == "appLoadZ = 500.0 N");
  CHECK(arrow("gravityVecZ").path.back().y < arrow("gravityVecZ").path.front().y);
  // rpm2 > 0 turns about +X from Z towards -Y: anticlockwise seen from +X.
  const Path& turn = arrow("rpm2").path;
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < turn.size(); ++i)
    area += turn[i].x * turn[i + 1].y - turn[i + 1].x * turn[i].y;
  CHECK(area > 0.0);
  deck.set("kFS3", "1");
  deck.complete();
  const Drawing held = draw(View::AdditionalView, deck);
  CHECK(std::any_of(held.panes[0].arrows.begin(), held.panes[0].arrows.end(),
                    [](const Arrow& a) { return a.variable == "appDispZ"; }));
}

TEST_CASE("outline: deck that cannot be drawn → reason", "[unit][outline]") {
  const auto reason = [](const char* name, const char* variable, const char* value,
                         View view = View::CrossSection) {
    deck::Deck deck = deck::new_deck(name);
    deck.set(variable, value);
    return draw(view, deck).reason;
  };
  CHECK(reason("ball", "bReDia", "-0.01").find("bReDia") != std::string::npos);
  CHECK(reason("ball", "pitchDia", "0.001").find("pitchDia") != std::string::npos);
  CHECK(reason("ball", "raceCurFac1", "0.5").find("raceCurFac1") != std::string::npos);
  CHECK(reason("tapered", "raceTaper2", "20").find("angle") != std::string::npos);
  CHECK(reason("cylindrical", "bReCorRad1", "0.05").size() > 20);
  CHECK(reason("ball", "reRaceTC4", "-1", View::Traction) == "");  // other curves are left
  CHECK(reason("ball-thrust", "nCseg", "0", View::Pocket).find("no cage") != std::string::npos);
  deck::Deck hollow = deck::new_deck("ball");
  for (deck::RecordData& record : hollow.records)
    for (auto& values : record.values)
      for (deck::Value& value : values) value = std::monostate{};
  for (int view = 0; view < 8; ++view) {
    const Drawing drawing = draw(static_cast<View>(view), hollow);
    CHECK((!drawing.reason.empty() || !drawing.panes.empty()));
  }
  CHECK(draw(View::CrossSection, deck::Deck()).reason != "");
  CHECK(draw(View::CrossSection, hollow).reason.find("kBrg") != std::string::npos);
}

TEST_CASE("outline: any value of any number → drawing or reason", "[unit][outline][slow]") {
  // Whatever one number is, something is drawn or refused; nothing else is thrown.
  int drawn = 0, refused = 0;
  for (const char* name : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const deck::Deck whole = deck::new_deck(name);
    for (std::size_t r = 0; r < whole.records.size(); ++r)
      for (std::size_t v = 1; v < whole.records[r].values.size(); ++v)
        for (const double wrong : {0.0, -1.0, 1e30, 88.0}) {
          deck::Deck deck = whole;
          for (deck::Value& value : deck.records[r].values[v])
            if (std::holds_alternative<double>(value)) value = wrong;
          for (deck::Value& value : deck.records[r].values[v])
            if (std::holds_alternative<long long>(value))
              value = static_cast<long long>(std::clamp(wrong, -9.0, 1e6));
          for (int view = 0; view < 8; ++view) {
            INFO(name << " record " << deck.records[r].id << " variable " << v << " = " << wrong
                      << " view " << view);
            const Drawing drawing = draw(static_cast<View>(view), deck);
            if (drawing.reason.empty()) {
              ++drawn;
              if (!all_finite(drawing)) CHECK(drawing.reason == "has points without a place");
            } else {
              ++refused;
            }
          }
        }
  }
  CHECK(drawn > 1000);
  CHECK(refused > 200);
}

TEST_CASE("outline: every variable of the schema belongs to a view or to the default",
          "[unit][outline]") {
  CHECK(view_of_variable("5A", "pitchDia") == View::CrossSection);
  CHECK(view_of_variable("5D.1", "bReCrn") == View::Element);
  CHECK(view_of_variable("7.1", "bPocCls1") == View::Pocket);
  CHECK(view_of_variable("7.2.i", "cageGsCls") == View::Lands);
  CHECK(view_of_variable("5F", "flngHt11") == View::Flange);
  CHECK(view_of_variable("10.5.2D", "cageRaceTC2") == View::Traction);
  CHECK(view_of_variable("9.1.1", "appLoadX") == View::Loads);
  CHECK(view_of_variable("1", "mode") == View::CrossSection);
  CHECK(parts_of("8.3", "shftEM") == std::vector<Part>{Part::Shaft});
  CHECK(parts_of("9.1.3", "raceTemp2") == std::vector<Part>{Part::InnerRing});
  // What a record of geometry asks for can be seen in the view of the variable: a measure, an
  // arrow, or a shape that shows it.
  for (const char* name : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const deck::Deck deck = deck::new_deck(name);
    const std::vector<View> views = views_of(deck);
    for (const deck::RecordData& record : deck.records) {
      const std::string_view id = record.id;
      if (id[0] != '4' && id[0] != '5' && id != "7.1" && id != "7.2.i" && id != "9.1.1") continue;
      for (const deck::VariableSpec& variable : deck::find_record(id)->variables) {
        if (variable.name == "recID") continue;
        View view = view_of_variable(id, variable.name);
        if (std::find(views.begin(), views.end(), view) == views.end()) view = View::CrossSection;
        const Drawing drawing = draw(view, deck);
        bool seen = !parts_of(id, variable.name).empty();
        for (const Pane& pane : drawing.panes) {
          for (const Dimension& d : pane.dimensions) seen = seen || d.variable == variable.name;
          for (const Arrow& a : pane.arrows) seen = seen || a.variable == variable.name;
          for (const Shape& s : pane.shapes)
            seen =
                seen || std::find(s.shows.begin(), s.shows.end(), variable.name) != s.shows.end();
        }
        INFO(name << ", record " << id << ", " << variable.name << ", " << title_of(view));
        CHECK(seen);
      }
    }
  }
}

TEST_CASE("outline: deck cut at any place → drawing, or the missing value", "[unit][drawing]") {
  int drawn = 0, refused = 0;
  for (const char* type : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const std::string text = deck::write_deck(deck::new_deck(type));
    // Behind each value: a comma or the end of a line.
    for (std::size_t at = text.find_first_of(",\n"); at != std::string::npos;
         at = text.find_first_of(",\n", at + 1)) {
      const deck::ReadResult cut = deck::read_deck_text(text.substr(0, at), "DATA.txt");
      INFO(type << " cut after "
                << text.substr(at < 60 ? 0 : at - 60, std::min<std::size_t>(at, 60)));
      try {
        (void)outline_model(cut.deck);
        ++drawn;
      } catch (const InputError& error) {
        ++refused;
        CHECK(std::string(error.what()).size() > 20);
      }
    }
  }
  CHECK(drawn > 100);
  CHECK(refused > 100);
}
