#include "desktop/lubricant_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string>

namespace adore::desktop {
namespace {

using calculators::CurveChart;
using calculators::LubricantCurves;

ChartPanel panel_of(const CurveChart& chart) {
  ChartPanel panel;
  panel.title = chart.y_title;
  panel.unit = chart.y_unit;
  panel.log = chart.log_y;
  for (const calculators::NamedCurve& curve : chart.curves)
    panel.curves.push_back({curve.name, curve.y, {}});
  return panel;
}

ChartPage page_of(const LubricantCurves& all, LubricantTitle title,
                  std::initializer_list<const CurveChart*> charts) {
  const CurveChart& first = **charts.begin();
  ChartPage page;
  page.title =
      title == LubricantTitle::Whole ? fmt::format("{}: {}", all.name, first.title) : all.name;
  page.subtitle = all.conditions;
  if (all.provenance == "estimated")
    page.note = "some constants of this lubricant are estimates (resources/lubricants.json)";
  page.x_title = first.x_title;
  page.x_unit = first.x_unit;
  page.log_x = first.log_x;
  if (!first.curves.empty()) page.x = first.curves.front().x;
  for (const CurveChart* chart : charts) page.panels.push_back(panel_of(*chart));
  return page;
}

constexpr double kMeasured = 0.12;  ///< the most that disc machines read of any oil

void add_note(ChartPage& page, const std::string& text) {
  if (!text.empty()) page.note += (page.note.empty() ? "" : "; ") + text;
}

double largest(const CurveChart& chart) {
  double out = 0.0;
  for (const calculators::NamedCurve& curve : chart.curves)
    for (const double y : curve.y) out = std::max(out, y);
  return out;
}

}  // namespace

std::vector<ChartPage> lubricant_pages(const calculators::LubricantContact& contact,
                                       LubricantTitle title) {
  const LubricantCurves all = calculators::lubricant_curves(contact);
  std::vector<ChartPage> pages{
      all.laws.curves.empty() ? page_of(all, title, {&all.traction})
                              : page_of(all, title, {&all.traction, &all.laws}),
      page_of(all, title, {&all.viscosity}), page_of(all, title, {&all.film, &all.lambda})};
  // Without limiting shear stress laws reach hundreds: a linear scale would hide the rest.
  pages[0].panels[0].log = largest(all.traction) > 1.0;
  if (largest(all.traction) > kMeasured)
    add_note(pages[0],
             "traction coefficients above 0.12 exceed all disc machine measurements (no limiting "
             "shear stress)");
  add_note(pages[0], all.recommended);
  for (const std::size_t page : {std::size_t{0}, std::size_t{1}})
    add_note(pages[page], all.extrapolation_note);
  constexpr double kNearGlass = 0.99e12;  // tribology/viscosity/glass.hpp
  if (largest(all.viscosity) > kNearGlass)
    add_note(pages[1], "the viscosity is limited to 10¹² Pa·s (glass)");
  if (all.beyond_heating)
    add_note(pages.back(),
             "the inlet heating factor is limited to 0.1; beyond a minimum of the film thickness, "
             "the curve is extrapolated");
  return pages;
}

}  // namespace adore::desktop
