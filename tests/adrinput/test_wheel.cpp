#include "adrinput/deck_window.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/study_window.hpp"
#include "deck/templates.hpp"
#include "studies/study.hpp"
#include "support/qt_app.hpp"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <catch2/catch.hpp>

#include <fstream>

/// Scrolling over a form does not change it.
using namespace adore;
using namespace adore::adrinput;

namespace {

QString value_of(const QWidget& field) {
  if (const auto* list = qobject_cast<const QComboBox*>(&field)) return list->currentText();
  if (const auto* number = qobject_cast<const QAbstractSpinBox*>(&field)) return number->text();
  return {};
}

/// Lists and numbers that are in sight and that the wheel changes without a click.
QStringList changed_by_wheel(QWidget& window, int& fields) {
  QStringList out;
  for (QWidget* field : window.findChildren<QWidget*>()) {
    const bool of_a_kind = qobject_cast<QComboBox*>(field) != nullptr ||
                           qobject_cast<QAbstractSpinBox*>(field) != nullptr;
    if (!of_a_kind || !field->isVisible() || !field->isEnabled()) continue;
    ++fields;
    for (const int turn : {-120, 120}) {
      if (QWidget* focus = QApplication::focusWidget()) focus->clearFocus();
      const QString before = value_of(*field);
      QWheelEvent wheel(QPointF(field->rect().center()),
                        QPointF(field->mapToGlobal(field->rect().center())), QPoint(),
                        QPoint(0, turn), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(field, &wheel);
      if (value_of(*field) != before)
        out << QString("%1 %2: %3 became %4")
                   .arg(field->metaObject()->className(), field->objectName(), before,
                        value_of(*field));
    }
  }
  return out;
}

}  // namespace

TEST_CASE("adrinput: scrolling over a form or a panel changes no value", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  window.drawingPanel().hide();  // its list of views changes nothing of the deck
  int fields = 0;
  auto* tabs = window.findChild<QTabWidget*>("panels");
  for (int page = 0; page < tabs->count(); ++page) {
    tabs->setCurrentIndex(page);
    CHECK(changed_by_wheel(window, fields).join("; ").toStdString() == "");
  }
  for (const std::string& record : window.document().pages()) {
    INFO("record " << record);
    window.showRecord(record);
    CHECK(changed_by_wheel(window, fields).join("; ").toStdString() == "");
  }
  CHECK(fields > 40);
  CHECK_FALSE(window.document().modified());
}

TEST_CASE("adrinput: scrolling over the form of a study changes no value",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("DATA.txt").toStdString()) << deck::template_text("ball");
  StudyWindow window;
  window.show();
  int fields = 0;
  for (int kind = 0; kind < studies::kKinds; ++kind) {
    const std::string name(studies::kind_name(static_cast<studies::Kind>(kind)));
    INFO(name);
    window.newStudy(folder.filePath(QString::fromStdString(name + ".json")).toStdString(),
                    QString::fromStdString(name), folder.filePath("DATA.txt").toStdString());
    const std::string before = window.document().text();
    CHECK(changed_by_wheel(window, fields).join("; ").toStdString() == "");
    CHECK(window.document().text() == before);
  }
  CHECK(fields >= 3 * studies::kKinds);
}
