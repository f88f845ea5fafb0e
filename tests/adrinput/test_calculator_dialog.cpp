#include "adrinput/calculator_dialog.hpp"
#include "adrinput/deck_window.hpp"
#include "calculators/calculator_description.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace adore;
using adrinput::CalculatorDialog;

/// Texts that are lower than their wrapped lines, and fields that are squeezed.
static int cut_texts(const QDialog& dialog) {
  QTest::qWait(1);
  int out = 0;
  for (const QLabel* label : dialog.findChildren<QLabel*>())
    if (label->isVisible() && label->height() < label->heightForWidth(label->width())) {
      UNSCOPED_INFO(label->text().toStdString());
      ++out;
    }
  for (const QLineEdit* line : dialog.findChildren<QLineEdit*>())
    if (line->isVisible() && line->height() < line->minimumSizeHint().height()) ++out;
  return out;
}

TEST_CASE("calculator dialog: example of each kind → the results of calculate()",
          "[gui][adrinput][calculators]") {
  test::use_qt();
  CalculatorDialog dialog;
  dialog.show();
  auto* names = dialog.findChild<QComboBox*>("calculator-list");
  auto* kinds = dialog.findChild<QComboBox*>("kind-list");
  auto* table = dialog.findChild<QTableWidget*>("calculator-results");
  const auto& all = calculators::calculator_list();
  int described = 0, computed = 0;
  for (const calculators::CalculatorInfo& info : all) {
    if (calculators::family_schema(info.family) == nullptr) continue;
    ++described;
    names->setCurrentText(QString::fromStdString(info.name));
    const auto calculations = calculators::describe_calculator(info).at("calculations");
    REQUIRE(kinds->count() == static_cast<int>(calculations.size()));
    for (int k = 0; k < kinds->count(); ++k) {
      kinds->setCurrentIndex(k);
      dialog.findChild<QPushButton*>("example")->click();
      dialog.findChild<QPushButton*>("compute")->click();
      const auto& calculation = calculations.at(static_cast<std::size_t>(k));
      CAPTURE(info.name, kinds->currentText().toStdString(), dialog.input().dump(),
              dialog.findChild<QLabel*>("calculator-message")->text().toStdString());
      for (const auto& input : calculation.at("inputs"))
        CHECK(dialog.findChild<QWidget*>(
                  QString::fromStdString(input.at("name").get<std::string>())) != nullptr);
      const nlohmann::json example = calculation.at("example");
      const auto expected = calculators::calculate(info.name, example);
      CHECK(calculators::calculate(info.name, dialog.input()) == expected);
      CHECK(table->rowCount() > 0);
      CHECK(cut_texts(dialog) == 0);
      computed += table->rowCount() > 0 ? 1 : 0;
    }
  }
  CHECK(names->count() == described);
  CHECK(described > 40);
  CHECK(computed > 100);
}

TEST_CASE("calculator dialog: missing and wrong values → errors at their fields, no result",
          "[gui][adrinput][calculators]") {
  test::use_qt();
  adrinput::DeckWindow window;
  window.show();
  window.findChild<QAction*>("calculators")->trigger();
  auto* dialog = window.findChild<CalculatorDialog*>("calculator");
  REQUIRE(dialog != nullptr);
  auto* table = dialog->findChild<QTableWidget*>("calculator-results");
  dialog->compute();
  const std::string& required = dialog->kind().required.front();
  const auto error_of = [&](const std::string& name) {
    return dialog->findChild<QLabel*>("error " + QString::fromStdString(name));
  };
  CHECK(error_of(required)->text().contains("missing"));
  CHECK_FALSE(error_of(required)->isHidden());
  CHECK(table->rowCount() == 0);
  dialog->fillExample();
  CHECK(error_of(required)->isHidden());
  auto* field = dialog->findChild<QLineEdit*>(QString::fromStdString(required));
  REQUIRE(field != nullptr);
  const QString right = field->text();
  field->setText("foo");
  dialog->compute();
  CHECK_FALSE(error_of(required)->isHidden());
  CHECK(cut_texts(*dialog) == 0);
  CHECK(table->rowCount() == 0);
  field->setText(right);
  dialog->compute();
  CHECK(error_of(required)->isHidden());
  CHECK(table->rowCount() > 0);
}
