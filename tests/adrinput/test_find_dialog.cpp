#include "adrinput/document.hpp"
#include "adrinput/find_dialog.hpp"
#include "desktop/chart_view.hpp"
#include "support/qt_app.hpp"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::adrinput;

namespace {

template <class Widget>
Widget* part(FindDialog& dialog, const char* name) {
  auto* out = dialog.findChild<Widget*>(name);
  REQUIRE(out != nullptr);
  return out;
}

void type(FindDialog& dialog, const char* name, const QString& text) {
  auto* edit = part<QLineEdit>(dialog, name);
  edit->clear();
  QTest::keyClicks(edit, text);
}

void ask(FindDialog& dialog, const QString& unknown, const QString& first, const QString& last,
         const QString& target, const QString& value) {
  part<QComboBox>(dialog, "find-question")->setCurrentIndex(0);
  part<QComboBox>(dialog, "find-unknown")->setCurrentText(unknown);
  part<QComboBox>(dialog, "find-target")->setCurrentText(target);
  type(dialog, "find-first", first);
  type(dialog, "find-last", last);
  type(dialog, "find-value", value);
}

void run(FindDialog& dialog) {
  QTest::mouseClick(part<QPushButton>(dialog, "find-run"), Qt::LeftButton);
  REQUIRE(QTest::qWaitFor([&] { return !dialog.busy(); }, 60000));
}

}  // namespace

TEST_CASE("find dialog: thrust for a contact load → answer, curve, value in the deck",
          "[gui][find]") {
  test::use_qt();
  Document document;
  FindDialog open(document);
  FindDialog* const dialog = &open;
  document.changed = [dialog] { dialog->sync(); };
  dialog->show();
  CHECK_FALSE(part<QPushButton>(*dialog, "find-apply")->isEnabled());
  ask(*dialog, "appLoadX", "1000", "5000", "largest_contact_load_N", "500");
  run(*dialog);
  REQUIRE(dialog->report());
  REQUIRE(dialog->report()->outcome.answer == FindAnswer::One);
  const double found = dialog->report()->outcome.solutions[0].x;
  CHECK(part<QLabel>(*dialog, "find-answer")->text().contains("appLoadX = "));
  const desktop::ChartPage& page =
      part<desktop::ChartView>(*dialog, "find-chart")->chartScene().page();
  REQUIRE(page.panels.size() == 1);
  CHECK(page.panels[0].curves.at(0).y.size() >= 41);
  REQUIRE(page.marks.size() == 1);
  CHECK(page.marks[0].x == found);

  QTest::mouseClick(part<QPushButton>(*dialog, "find-apply"), Qt::LeftButton);
  CHECK(document.deck().real("appLoadX") == Approx(found));
  // The answer is that of the deck as it is now, until another change.
  CHECK_FALSE(part<QLabel>(*dialog, "find-answer")->text().contains("Out of date"));
  document.change({{"appLoadZ", "1"}});
  CHECK(part<QLabel>(*dialog, "find-answer")->text().contains("Out of date"));
}

TEST_CASE("find dialog: no solution and wrong entries → sentences, nothing to set", "[gui][find]") {
  test::use_qt();
  Document document;
  FindDialog open(document);
  FindDialog* const dialog = &open;
  document.changed = [dialog] { dialog->sync(); };
  dialog->show();
  ask(*dialog, "appLoadX", "1000", "2000", "largest_contact_load_N", "1e6");
  run(*dialog);
  CHECK(part<QLabel>(*dialog, "find-answer")->text().startsWith("No solution"));
  CHECK(part<QLabel>(*dialog, "find-answer")->text().contains("the upper bound"));
  CHECK_FALSE(part<QPushButton>(*dialog, "find-apply")->isEnabled());
  ask(*dialog, "appLoadX", "200", "100", "largest_contact_load_N", "500");
  run(*dialog);
  CHECK(part<QLabel>(*dialog, "find-answer")->text().contains("lower one first"));
  ask(*dialog, "apLoadX", "100", "200", "largest_contact_load_N", "500");
  run(*dialog);
  CHECK(part<QLabel>(*dialog, "find-answer")->text().contains("apLoadX"));
}

TEST_CASE("find dialog: question → unknown, target and bounds of the deck's value", "[gui][find]") {
  test::use_qt();
  Document document;
  FindDialog open(document);
  FindDialog* const dialog = &open;
  document.changed = [dialog] { dialog->sync(); };
  dialog->show();
  auto* questions = part<QComboBox>(*dialog, "find-question");
  questions->setCurrentIndex(questions->findData("pivot-speed"));
  CHECK(part<QComboBox>(*dialog, "find-unknown")->currentText() == "rpm2");
  CHECK(part<QComboBox>(*dialog, "find-target")->currentText() == "gyroscopic_ratio");
  CHECK(part<QLineEdit>(*dialog, "find-value")->text() == "1");
  CHECK(part<QLineEdit>(*dialog, "find-first")->text().toDouble() ==
        Approx(0.25 * document.deck().real("rpm2")));
}
