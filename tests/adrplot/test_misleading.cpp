#include "adrplot/known_values.hpp"
#include "adrplot/plot_document.hpp"
#include "adrplot/spectrum_page.hpp"
#include "adrplot/vibration_values.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_scene.hpp"
#include "results/channels.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QGraphicsLineItem>
#include <QGraphicsTextItem>
#include <QPen>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

/// What a file stores and nothing computed is not drawn as a result.
using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// Every value of the columns whose names begin so.
void set(results::SolFile& file, const std::string& begin, double value) {
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id.starts_with(begin))
      for (auto& step : file.steps) step.values.at(c) = value;
}

/// Page by a word of its title.
desktop::ChartPage page_with(const results::SolFile& file, const std::string& word,
                             const PageOptions& options = {}) {
  const PlotDocument document = make_document(file);
  for (std::size_t p = 0; p < document.pages.size(); ++p)
    if (document.pages[p].title.find(word) != std::string::npos)
      return document.build(static_cast<int>(p) + 1, options);
  FAIL("no page about " << word);
  return {};
}

}  // namespace

TEST_CASE("pages: rounding of spin over roll is not drawn as a signal", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  set(file, "contact.load.", 100.0);
  set(file, "contact.spin_to_roll.", -6.7e-19);
  const auto look = [&](bool rounding) {
    int seen = 0;
    const PlotDocument now = make_document(file);
    for (std::size_t p = 0; p < now.pages.size(); ++p)
      for (const auto& panel : now.build(static_cast<int>(p) + 1, {}).panels)
        if (panel.message.find("No spin") != std::string::npos) ++seen;
    CHECK((seen > 0) == rounding);
  };
  look(true);
  set(file, "contact.spin_to_roll.", 2e-4);
  look(false);
}

TEST_CASE("pages: contact position on a pocket wall only during contact", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Cage);
  file.header.bearing_type = 2;
  file.header.pocket_type = 0;
  const auto columns = results::sol_columns(file.header);
  const auto column = [&](const std::string& id) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].id == id) return c;
    FAIL("no column " << id);
    return std::size_t{0};
  };
  const std::size_t force = column("pocket.force.1.1"), place = column("pocket.position.1.1");
  for (std::size_t i = 0; i < file.steps.size(); ++i) {
    auto& values = file.steps[i].values;
    if (values.size() < columns.size()) values.resize(columns.size());
    values[force] = i % 10 == 3 ? 5.0 : 0.0;
    values[place] = i % 2 == 0 ? -4e-3 : 4e-3;  // by rounding, but for the touches
    if (i % 10 == 3) values[place] = 1e-3;
  }
  const auto page = page_with(file, "Pocket 1 ");
  const auto& curve = page.panels.at(2).curves.at(0);
  REQUIRE(page.panels[2].title == "Contact position");
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    if (i % 10 == 3)
      CHECK(curve.y[i] == Approx(1e-3));
    else
      CHECK(std::isnan(curve.y[i]));
  }
  for (auto& step : file.steps) step.values[place] = -3e-12;
  const auto middle = page_with(file, "Pocket 1 ");
  for (const double y : middle.panels.at(2).curves.at(0).y) CHECK((std::isnan(y) || y == 0.0));
  set(file, "pocket.force.", 0.0);
  CHECK(page_with(file, "Pocket 1 ").panels.at(2).message.find("did not touch") !=
        std::string::npos);
}

TEST_CASE("pages: no average heat before the end of a thermal step, none without coolant",
          "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Power);
  const auto columns = results::sol_columns(file.header);
  REQUIRE(file.steps.size() > 4);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      double& value = file.steps[i].values.at(c);
      const std::string& id = columns[c].id;
      if (id.starts_with("thermal.")) value = 300.0;
      if (id.ends_with("_heat")) value = i < 3 || id == "thermal.coolant_heat" ? 0.0 : 50.0;
    }
  const auto none = [](const desktop::ChartCurve& curve) { return !has_number(curve.y); };
  auto heat = page_with(file, "Average heat"), warm = page_with(file, "Bearing temperatures");
  const std::string no_coolant = "No coolant flow in this run: all heat flows through the races.";
  CHECK(heat.panels.at(1).message == no_coolant);
  CHECK(none(heat.panels[1].curves.at(0)));
  CHECK(warm.panels.at(0).message == no_coolant);
  CHECK_FALSE(none(warm.panels.at(1).curves.at(0)));
  for (const std::size_t panel : {0U, 2U})
    for (const desktop::ChartCurve& curve : heat.panels.at(panel).curves) {
      CHECK(std::isnan(curve.y.at(2)));
      CHECK(curve.y.at(3) == 50.0);
    }
  set(file, "thermal.coolant_heat", 10.0);
  heat = page_with(file, "Average heat");
  CHECK(heat.panels.at(1).curves.at(0).y.at(3) == 10.0);
  CHECK_FALSE(none(page_with(file, "Bearing temperatures").panels.at(0).curves.at(0)));
  for (const char* id :
       {"thermal.total_heat", "thermal.coolant_heat", "thermal.outer_heat", "thermal.inner_heat"})
    set(file, id, 0.0);
  heat = page_with(file, "Average heat");
  for (const desktop::ChartPanel& panel : heat.panels)
    CHECK(panel.message == "No thermal step was completed in this run.");
  CHECK_FALSE(none(page_with(file, "Bearing temperatures").panels.at(0).curves.at(0)));
}

TEST_CASE("pages: wear without integration → no curve, cage may lack one", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Power);
  const std::vector<std::string> ids{"power.element1_wear_rate", "race.wear_rate",
                                     "power.cage_wear_rate"};
  for (const std::string& id : ids) set(file, id, 0.0);
  for (const desktop::ChartPanel& panel : page_with(file, "wear rates").panels)
    CHECK(panel.message == "Wear was not computed in this run, or the wear coefficients are 0.");
  set(file, "race.wear_rate", 1e-15);
  for (const desktop::ChartPanel& panel : page_with(file, "wear rates").panels) {
    CHECK(panel.message.empty());
    for (const desktop::ChartCurve& curve : panel.curves) CHECK(has_number(curve.y));
  }
}

TEST_CASE("pages: rates from a force balance → no curve; rates of a body at rest → curve",
          "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  const auto columns = results::sol_columns(file.header);
  const auto fill = [&](const std::string& id, double slope) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].id == id)
        for (std::size_t i = 0; i < file.steps.size(); ++i)
          file.steps[i].values.at(c) = slope == 0.0 ? 0.0 : 0.02 + slope * static_cast<double>(i);
  };
  const auto message = [&](const std::string& page, std::size_t panel) {
    const desktop::ChartPanel built = page_with(file, page).panels.at(panel);
    CHECK(built.message.empty() == has_number(built.curves.at(0).y));
    return built.message;
  };
  const auto& velocity = page_with(file, "Velocity").panels;
  std::size_t radial = 0;
  while (radial < velocity.size() && velocity[radial].title.find("adial") == std::string::npos)
    ++radial;
  REQUIRE(radial < velocity.size());
  fill("element.radial_position", 1e-6);
  fill("element.radial_velocity", 0.0);
  fill("element.radial_acceleration", 0.0);
  for (const char* page : {"Velocity", "Accelerations"})
    CHECK(message(page, radial).find("results from a force balance") != std::string::npos);
  fill("element.radial_velocity", 1e-3);  // the same with a velocity that changes
  CHECK(message("Velocity", radial).empty());
  CHECK(message("Accelerations", radial).find("Not computed") != std::string::npos);
  fill("element.radial_velocity", 0.0);
  set(file, "element.radial_position", 0.02);  // what rests has rates of 0
  for (const char* page : {"Velocity", "Accelerations"}) CHECK(message(page, radial).empty());
  for (const char* id : {"element.theta", "element.phi", "element.rotation"}) set(file, id, 0.0);
  for (const double turns : {100.0, 0.0}) {
    set(file, "element.angular_velocity", turns);
    for (const std::size_t panel : {0U, 1U, 2U})
      CHECK((message("Angular orientation", panel) ==
             "The orientation was not integrated in this run.") == (turns > 0.0));
  }
}

TEST_CASE("pages: oscillating shaft → no frequency marks, note on unbounded ratios",
          "[unit][adrplot]") {
  for (const bool swings : {false, true}) {
    results::SolFile file = test::synthetic_sol(SolKind::Cage);
    const double whole = static_cast<double>(file.steps.size());
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      const double part = static_cast<double>(i) / whole;
      file.steps[i].revolutions = swings ? std::sin(6.0 * part) : part;
    }
    PageOptions spectrum;
    spectrum.domain = Domain::Spectrum;
    const auto lines = page_with(file, "Mass center velocities", spectrum);
    INFO(lines.note);
    CHECK(lines.marks.empty() == swings);
    CHECK((lines.note.find("oscillates") != std::string::npos) == swings);
    CHECK(lines.note.find("varies from") == std::string::npos);
    const auto history = page_with(file, "Mass center velocities");
    INFO(history.note);
    CHECK((history.note.find("passes through 0") != std::string::npos) == swings);
  }
}

TEST_CASE("pages: centered cage → no whirl direction", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Cage);
  set(file, "cage.land1_gap", 1e-4);
  set(file, "cage.land1_angle", 3.0);
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "cage.land1_angle") file.steps[0].values[c] = 0.0;
  const auto first = [&](double y_of_cage) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].id == "cage.y_over_clearance") file.steps[0].values[c] = y_of_cage;
      if (columns[c].id == "cage.z_over_clearance") file.steps[0].values[c] = 0.0;
    }
    const auto page = page_with(file, "land 1");
    CHECK(std::isfinite(page.panels.at(2).curves.at(0).y.at(1)));
    return page.panels.at(2).curves.at(0).y.at(0);
  };
  CHECK(std::isnan(first(0.0)));
  CHECK(first(-0.3) == 0.0);  // beside the middle an angle of 0 is one
}

TEST_CASE("pages: gaps at lost contact and steps of slip → notes", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  set(file, "contact.load.", 100.0);
  set(file, "contact.angle.", 0.1);
  const auto note = [&](const std::string& page) { return page_with(file, page).note; };
  CHECK(note("load and angle").find("no contact") == std::string::npos);
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "contact.load.inner")
      for (std::size_t i = file.steps.size() / 2; i < file.steps.size(); ++i)
        file.steps[i].values[c] = 0.0;
  // The load, in the other panel, is 0 there.
  const std::string gap = note("load and angle");
  CHECK_THAT(gap, Catch::Contains("ontact angle") && !Catch::Contains("ontact load"));
  CHECK_THAT(gap, Catch::Contains("of the inner race") && !Catch::Contains("outer race"));
  CHECK_THAT(gap, Catch::Contains("missing where there is no contact."));
  // A spectrum has no such gaps; a number that the file never had is no open contact.
  for (const Domain domain : {Domain::Spectrum, Domain::Spectrogram}) {
    PageOptions options;
    options.domain = domain;
    CHECK(page_with(file, "load and angle", options).note.find("missing where") ==
          std::string::npos);
  }
  results::SolFile damaged = test::synthetic_sol(SolKind::Element);
  set(damaged, "contact.load.", 100.0);
  set(damaged, "contact.angle.", 0.1);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id.starts_with("contact.angle."))
      damaged.steps[0].values[c] = std::numeric_limits<double>::quiet_NaN();
  CHECK(page_with(damaged, "load and angle").note.find("missing where") == std::string::npos);
  CHECK(note("slip").find("largest value of all slices") == std::string::npos);  // balls have none
  file.header.bearing_type = 2;
  CHECK(note("slip").find("largest value of all slices") != std::string::npos);
}

TEST_CASE("pages: rounding of a force → not enlarged next to large components", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Race);
  set(file, "race.applied_force_x", 1e-7);
  set(file, "race.applied_force_y", 3.0);
  set(file, "race.applied_force_z", 5000.0);
  const desktop::ChartPage page = page_with(file, "forces");
  REQUIRE(page.panels.size() == 3);
  for (const auto& panel : page.panels) CHECK(panel.least_span == Approx(5e-4));
}

TEST_CASE("pages: lines of frequencies do not cross the words of an empty chart", "[gui]") {
  test::use_qt();
  results::SolFile file = test::synthetic_sol(SolKind::Race);
  set(file, "race.", 2e-6);
  desktop::ChartPage page = page_with(file, "spectrum");
  REQUIRE_FALSE(page.marks.empty());
  REQUIRE(page.panels.front().message.find("No vibration") == 0);
  const auto dashed = [](const desktop::ChartPage& shown) {
    desktop::ChartScene scene;
    scene.setPageSize({900, 600});
    scene.setPage(shown);
    int lines = 0;
    for (const QGraphicsItem* item : scene.items())
      if (const auto* line = qgraphicsitem_cast<const QGraphicsLineItem*>(item))
        lines += line->pen().style() == Qt::DashLine ? 1 : 0;
    return lines;
  };
  CHECK(dashed(page) == 0);
  page.panels.front().curves.front().y.assign(page.x.size(), 1.0);
  CHECK(dashed(page) > 0);
}

TEST_CASE("pages: cage orbit → divisor given in the note", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Cage);
  const desktop::ChartPage guided = page_with(file, "orbit");
  CHECK(guided.guide_radius == 1.0);
  CHECK_THAT(guided.note, Catch::Contains("clearance of the guide lands, 150 µm"));
  CHECK(guided.x_title == "Y / clearance");
  file.header.segments = 2;
  CHECK_THAT(page_with(file, "orbit").note, Catch::Contains("middle of an untilted segment"));
  file.header.segments = 1;
  for (const char* land : {"cage.land1_", "cage.land2_"}) set(file, land, 0.0);
  const desktop::ChartPage free = page_with(file, "orbit");
  CHECK(free.guide_radius == 0.0);
  CHECK_THAT(free.note, Catch::Contains("no guide land") &&
                            Catch::Contains("radial pocket clearance, 150 µm"));
  CHECK(free.x_title == "Y / pocket clearance");
  // A clearance of one unit of length is none.
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "cage.radial_position")
      for (auto& step : file.steps) step.values[c] /= 150e-6;
  const desktop::ChartPage position = page_with(file, "orbit");
  CHECK_THAT(position.note, Catch::Contains("its orbit is in m"));
  CHECK(position.x_title == "Y / 1 m");
  // What the run says goes before what its numbers look like.
  using results::CageLengthScale;
  const std::vector<PageSpec> pages = plot_pages(file.kind, file.header);
  PageContext context;
  context.facts.cage_length_scale = {60e-6, CageLengthScale::Of::Pockets};
  CHECK_THAT(build_page(file, pages, 5, {}, context).note,
             Catch::Contains("pocket clearance, 60 µm"));
  context.facts.cage_length_scale = {149e-6, CageLengthScale::Of::GuideLands};
  CHECK_THAT(build_page(file, pages, 5, {}, context).note, Catch::Contains("lands, 149 µm"));
}

TEST_CASE("pages: rounding errors → no spectrum for any column", "[unit][adrplot]") {
  // A sine of every column's own size has lines; one of its last digits, about it or 0, has none.
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    const results::SolFile base = test::synthetic_sol(kind);
    const auto drawn = [&](double middle, double swing, Domain domain) {
      results::SolFile file = base;
      for (std::size_t i = 0; i < file.steps.size(); ++i)
        for (double& value : file.steps[i].values)
          value = middle + swing * std::sin(0.3 * static_cast<double>(i));
      const PlotDocument document = make_document(file);
      PageOptions options;
      options.domain = domain;
      std::set<std::string> titles;
      for (std::size_t p = 0; p < document.pages.size(); ++p) {
        if (document.pages[p].kind == PageKind::Orbit) continue;
        const auto page = document.build(static_cast<int>(p) + 1, options);
        for (const auto& panel : page.panels)
          for (const auto& curve : panel.curves)
            if (!curve.y.empty()) titles.insert(page.title + ", " + panel.title);
      }
      return titles;
    };
    for (const Domain domain : {Domain::Spectrum, Domain::Spectrogram}) {
      INFO(static_cast<int>(kind) << " " << static_cast<int>(domain));
      CHECK(drawn(2.0, 1.0, domain).size() > 2);
      CHECK(drawn(0.0, 1e-17, domain) == std::set<std::string>());
      CHECK(drawn(2.0, 4e-16, domain) == std::set<std::string>());
    }
  }
  // Beside the other coordinates of the place.
  results::SolFile file = test::synthetic_sol(SolKind::Cage);
  const auto columns = results::sol_columns(file.header);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].id == "cage.x_over_clearance")
      for (std::size_t i = 0; i < file.steps.size(); ++i)
        file.steps[i].values[c] = 1e-11 * std::sin(0.3 * static_cast<double>(i));
  const auto spectrum = page_with(file, "spectrum");
  REQUIRE(spectrum.panels.at(0).title == "X");
  CHECK(spectrum.panels[0].message.find(
            "No vibration: the value changes only by rounding errors") == 0);
  CHECK(spectrum.panels[0].curves.at(0).y.empty());
  CHECK_FALSE(spectrum.panels[1].curves.at(0).y.empty());
  // The last digit of a text file.
  const std::vector<double> text(20, 1.4984284e-4);
  std::vector<double> last = text, between = text;
  last[7] = 1.4984285e-4;
  between[7] = 1.49842845e-4;
  CHECK(is_only_rounding(last, "m", 0.0));
  CHECK_FALSE(is_only_rounding(between, "m", 0.0));
}

TEST_CASE("pages: message for a whole page → shown once, without axes or notes on lines",
          "[gui][adrplot]") {
  test::use_qt();
  // Races that stand still, stored at unequal steps; a cage without lands.
  results::SolFile still = test::synthetic_sol(SolKind::Race);
  const double step = still.steps[1].time - still.steps[0].time;
  for (std::size_t i = 0; i < still.steps.size(); i += 3) still.steps[i].time += 0.2 * step;
  set(still, "race.", 2e-6);
  results::SolFile bare = test::synthetic_sol(SolKind::Cage);
  set(bare, "cage.land", 0.0);
  for (const auto& [page, told] : {std::pair{page_with(still, "spectrum"),
                                             "No vibration: all values of this page are constant."},
                                   {page_with(bare, "land 1"), "This cage has no guide land 1."}}) {
    INFO(page.title << ": " << page.note);
    CHECK(page.note.empty());
    for (const QSizeF size : {QSizeF(1280, 800), QSizeF(700, 450)}) {
      desktop::ChartScene scene;
      scene.setPageSize(size);
      scene.setPage(page);
      int said = 0, beside = 0;
      const QRectF below(0.0, 70.0, size.width(), size.height() - 70.0);
      for (QGraphicsItem* item : scene.items()) {
        const auto* text = qgraphicsitem_cast<QGraphicsTextItem*>(item);
        if (text != nullptr && text->toPlainText() == told)
          ++said;
        else
          beside += item->sceneBoundingRect().intersects(below) ? 1 : 0;
      }
      CHECK(said == 1);
      CHECK(beside == 0);
    }
  }
}

TEST_CASE("pages: contact that never closes → not a missing value", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  set(file, "contact.load.inner", 0.0);
  const auto page = page_with(file, "load and angle");
  CHECK(page.note.find("Inner race: no contact in this run.") != std::string::npos);
  set(file, "contact.load.outer", 0.0);
  for (const std::size_t p : {1U, 2U})
    CHECK(page_with(file, "load and angle").panels.at(p).message == "No contact in this run.");
}

TEST_CASE("pages: a curve without a spectrum is named, with its reason", "[unit][adrplot]") {
  results::SolFile file = test::synthetic_sol(SolKind::Element);
  const auto columns = results::sol_columns(file.header);
  const auto race = [&](const std::string& id, auto&& change) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].id == id)
        for (std::size_t i = 0; i < file.steps.size(); ++i) change(file.steps[i].values[c], i);
  };
  PageOptions options;
  options.domain = Domain::Spectrum;
  // Open contacts have no angle.
  race("contact.load.inner", [](double& v, std::size_t i) {
    v = i < 600 ? 100.0 + 9.0 * std::sin(0.1 * static_cast<double>(i)) : 0.0;
  });
  auto page = page_with(file, "Race interactions 1", options);
  REQUIRE(page.panels.at(1).title == "Contact angle");
  CHECK_FALSE(page.panels[1].curves.at(0).y.empty());
  CHECK(page.note.find("Contact angle and spin/roll, inner race: there are no values after ") !=
        std::string::npos);
  race("contact.angle.outer", [](double& v, std::size_t) { v = 15.0; });
  page = page_with(file, "Race interactions 1", options);
  const std::string& message = page.panels.at(1).message;
  CHECK(message.find("Outer race: the value is constant. Inner race: there are no values "
                     "after ") == 0);
  CHECK(message.find(", so there is no frequency spectrum.") != std::string::npos);
  CHECK(page.note.find("missing") == std::string::npos);
}

TEST_CASE("spectrum pages: notes on the reference of heights and the line spacing",
          "[unit][adrplot]") {
  test::SyntheticRun made;
  made.steps = 1001;
  const results::SolFile file = test::synthetic_sol(SolKind::Element, made);
  const double every = 1000.0 / (1001.0 * made.end_time());  // of 1001 samples [Hz]
  const std::string apart = "line spacing " + desktop::pretty_quantity(every, "Hz", 3);
  PageOptions options;
  options.domain = Domain::Spectrum;
  for (const SpectrumScale scale :
       {SpectrumScale::Relative, SpectrumScale::Units, SpectrumScale::Decibel}) {
    options.spectrum.scale = scale;
    const auto page = page_with(file, "Race interactions 1", options);
    INFO(page.note);
    CHECK(page.x.front() == Approx(every));
    CHECK(page.note.find(apart) != std::string::npos);
    CHECK((page.note.find("maximum of the curve") != std::string::npos) ==
          (scale == SpectrumScale::Relative));
  }
  options.domain = Domain::Spectrogram;
  const auto fall = page_with(file, "Race interactions 1", options);
  CHECK(fall.note.find("line spacing " + desktop::pretty_quantity(fall.x.front(), "Hz", 3)) !=
        std::string::npos);
}

TEST_CASE("pages: constant values → note, one dot for start and end", "[gui]") {
  test::use_qt();
  results::SolFile file = test::synthetic_sol(SolKind::Race);
  const auto key = [](const desktop::ChartPage& page) {
    desktop::ChartScene scene;
    scene.setPageSize({700, 450});
    scene.setPage(page);
    for (const QGraphicsItem* item : scene.items())
      if (const auto* text = dynamic_cast<const QGraphicsTextItem*>(item);
          text != nullptr && text->toPlainText().contains("start"))
        return text->toPlainText().toStdString();
    return std::string();
  };
  auto orbit = page_with(file, "orbit");
  CHECK(orbit.note.find("does not move") == std::string::npos);
  CHECK(key(orbit).find("start and end") == std::string::npos);
  set(file, "race.y", 0.0);
  set(file, "race.z", 2e-5);
  orbit = page_with(file, "orbit");
  CHECK(orbit.note.find("does not move in this plane") != std::string::npos);
  CHECK(key(orbit).find("start and end") != std::string::npos);
  const auto still = [&] {
    return page_with(file, "Mass center velocities").note.find("does not move") !=
           std::string::npos;
  };
  for (const char* id : {"race.whirl_speed", "race.radial_velocity"}) set(file, id, 0.0);
  set(file, "race.axial_velocity", 1e-6);
  CHECK_FALSE(still());
  set(file, "race.axial_velocity", 1e-19);
  CHECK(still());
  set(file, "race.applied_moment", 0.0);
  CHECK_THAT(page_with(file, "Applied moments").note,
             Catch::EndsWith("All values of this page are 0."));
}

TEST_CASE("pages: notes start sentences with a capital letter", "[unit][adrplot]") {
  // A letter behind a colon or within "spectra of" begins no sentence.
  const auto faults = [](const std::string& note) {
    int out = 0;
    for (const char* const behind : {": ", "spectra of "})
      for (auto at = note.find(behind); at != std::string::npos; at = note.find(behind, at + 1)) {
        const auto first = at + std::string(behind).size();
        if (first + 1 < note.size() && std::isupper(static_cast<unsigned char>(note[first])) &&
            std::islower(static_cast<unsigned char>(note[first + 1])))
          ++out;
      }
    return out;
  };
  REQUIRE(faults("Outer race: This has none.") == 1);
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    results::SolFile file = test::synthetic_sol(kind);
    // One race of each pair has nothing that was computed.
    for (const char* begin : {"contact.film.outer", "contact.temperature_rise.outer",
                              "contact.load.outer", "contact.spin_to_roll.outer"})
      set(file, begin, 0.0);
    const PlotDocument document = make_document(file);
    for (const Domain domain : {Domain::History, Domain::Spectrum, Domain::Spectrogram})
      for (std::size_t p = 0; p < document.pages.size(); ++p) {
        PageOptions options;
        options.domain = domain;
        const std::string note = document.build(static_cast<int>(p) + 1, options).note;
        CAPTURE(document.pages[p].title, note);
        CHECK(faults(note) == 0);
      }
  }
}

TEST_CASE("pages: notes on a part of the steps do not refer to the whole run", "[unit][adrplot]") {
  int said = 0;  // of whole files
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    results::SolFile file = test::synthetic_sol(kind);
    const auto columns = results::sol_columns(file.header);
    for (const bool part : {false, true})
      for (const double value : {0.0, 1e30}) {
        file.part = part;
        for (std::size_t c = 0; c < columns.size(); ++c)
          for (auto& step : file.steps)
            step.values.at(c) = columns[c].id.ends_with("spin_to_roll") ? 0.0 : value;
        const PlotDocument document = make_document(file);
        for (std::size_t p = 0; p < document.pages.size(); ++p) {
          const desktop::ChartPage page = document.build(static_cast<int>(p) + 1, {});
          std::string words = page.note;
          for (const auto& panel : page.panels) words += " " + panel.message;
          INFO(page.title << ": " << words);
          bool of_run = false;
          for (const char* of : {"in this run", "never", "constant in this file"})
            of_run = of_run || words.find(of) != std::string::npos;
          said += of_run && !part ? 1 : 0;
          CHECK_FALSE((part && of_run));
        }
      }
  }
  CHECK(said > 3);
}
