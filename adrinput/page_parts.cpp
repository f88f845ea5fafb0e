#include "adrinput/page_parts.hpp"

#include <QAbstractItemView>
#include <QColor>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace adore::adrinput {
namespace {

constexpr int kTextWidth = 330, kNumberWidth = 200, kMinFieldWidth = 90;  // of fields
constexpr int kLeastLetters = 8;    // of a list that must be narrow
constexpr int kFrameAndArrow = 44;  // of a list

}  // namespace

QLabel* make_text_label(const QString& text, const QColor& colour, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setStyleSheet(QString("color: %1").arg(colour.name()));
  return label;
}

std::vector<deck::OptionSpec> choices_of(const deck::VariableSpec& variable) {
  std::vector<deck::OptionSpec> all = variable.options;
  if (!variable.option_table.empty())
    for (const deck::OptionSpec& option : deck::option_table(variable.option_table))
      all.push_back(option);
  return all;
}

QString typed_code_hint(const deck::VariableSpec& variable) {
  QString text;
  for (const deck::OptionSpec& option : variable.options) {
    if (option.code != "n" && option.code != "-n") continue;
    if (!text.isEmpty()) text += "; ";
    text +=
        QString(option.code == "n" ? "or type a larger number: %1" : "or type a smaller number: %1")
            .arg(text_of(option.meaning));
  }
  return text;
}

QGridLayout* make_grid() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kBetween);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  return grid;
}

QString choice_text(std::string_view code, std::string_view meaning) {
  if (meaning.empty()) return text_of(code);
  return QString("%1 — %2").arg(text_of(code), text_of(meaning));
}

ValueLine::ValueLine(bool text, QWidget* parent)
    : QLineEdit(parent), preferred_width_(text ? kTextWidth : kNumberWidth) {
  setMinimumWidth(kMinFieldWidth);
  setMaximumWidth(preferred_width_);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
  setSizeAdjustPolicy(QComboBox::AdjustToContents);
  setMinimumContentsLength(kLeastLetters);
  setMaxVisibleItems(24);
  setInsertPolicy(QComboBox::NoInsert);
}

void ChoiceBox::widenForText(const QString& text) {
  widest_text_width_ =
      std::max(widest_text_width_, fontMetrics().horizontalAdvance(text) + kFrameAndArrow);
}

void ChoiceBox::showPopup() {
  constexpr int kMargins = 24;
  view()->setMinimumWidth(view()->sizeHintForColumn(0) + kMargins);
  QComboBox::showPopup();
}

bool is_text_cut_off(const QComboBox& combo) {
  return combo.isVisible() && combo.width() < combo.sizeHint().width() &&
         combo.fontMetrics().horizontalAdvance(combo.currentText()) + kFrameAndArrow >
             combo.width();
}

void show_combo_text_start(QComboBox* combo) { combo->lineEdit()->setCursorPosition(0); }

}  // namespace adore::adrinput
