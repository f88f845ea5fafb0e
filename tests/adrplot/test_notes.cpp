#include "adrplot/plot_document.hpp"
#include "desktop/chart_scene.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QGraphicsSimpleTextItem>
#include <catch2/catch.hpp>

#include <string>

/// Notes of all types of pages are complete, or state the number of omitted sentences.
using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// Lines of the note, joined; blanks between a number and its unit as they are in the page.
QString shown_note(const desktop::ChartScene& scene, QString& tip) {
  QString out;
  for (QGraphicsItem* item : scene.items(Qt::AscendingOrder)) {
    auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item);
    if (text == nullptr || text->pos().x() != 24.0 || text->pos().y() < 60.0) continue;
    out += (out.isEmpty() ? "" : " ") + text->text();
    tip = text->toolTip();
  }
  return out.replace(QChar(QChar::Nbsp), ' ');
}

}  // namespace

TEST_CASE("pages: notes → never cut, for any page, content and size", "[gui][adrplot]") {
  test::use_qt();
  int notes = 0, counted = 0;
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    test::SyntheticRun made;
    made.steps = 400;
    results::SolFile file = test::synthetic_sol(kind, made);
    // Unequal steps: spectra have to say more.
    const double step = file.steps[1].time - file.steps[0].time;
    for (std::size_t i = 0; i < file.steps.size(); i += 3) file.steps[i].time += 0.2 * step;
    const PlotDocument document = make_document(std::move(file));
    for (const Domain domain : {Domain::History, Domain::Spectrum, Domain::Spectrogram})
      for (const SpectrumScale scale :
           {SpectrumScale::Relative, SpectrumScale::Units, SpectrumScale::Decibel}) {
        if (domain == Domain::History && scale != SpectrumScale::Relative) continue;
        PageOptions options;
        options.domain = domain;
        options.spectrum.scale = scale;
        for (std::size_t p = 0; p < document.pages.size(); ++p) {
          desktop::ChartPage page = document.build(static_cast<int>(p) + 1, options);
          if (page.note.empty() || page.panels.empty()) continue;
          ++notes;
          for (const int more : {0, 6}) {
            for (int i = 0; i < more; ++i)
              page.note += " There is still more to be told of page " +
                           std::to_string(document.pages.size() + static_cast<std::size_t>(i)) +
                           ", as files of runs that were killed have it.";
            for (const auto& [size, interactive] : {std::pair(QSizeF(700, 450), true),
                                                    {QSizeF(1280, 800), true},
                                                    {QSizeF(700, 450), false},
                                                    {QSizeF(1280, 800), false}}) {
              desktop::ChartScene scene;
              scene.setInteractive(interactive);
              scene.setPageSize(size);
              scene.setPage(page);
              QString tip;
              const QString shown = shown_note(scene, tip),
                            whole = QString::fromStdString(page.note);
              INFO(page.title << ", " << size.width() << " wide: " << shown.toStdString());
              CHECK_FALSE(shown.contains(QChar(0x2026)));
              if (shown == whole) continue;
              ++counted;
              // A picture has no tooltips, so it shows all notes.
              CHECK(shown.contains("move the pointer here") == interactive);
              if (!interactive) CHECK(more > 0);
              if (!interactive) CHECK(shown.endsWith("not shown.)"));
              CHECK(tip.contains(whole.right(20).toHtmlEscaped()));
              const QString told = shown.left(shown.lastIndexOf('(')).trimmed();
              CHECK(whole.startsWith(told));
            }
          }
        }
      }
  }
  CHECK(notes > 50);
  CHECK(counted > 20);
}
