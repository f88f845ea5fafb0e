#pragma once

#include "adrinput/qt_text.hpp"
#include "deck/schema.hpp"

#include <QComboBox>
#include <QLineEdit>
#include <QString>

#include <string>
#include <string_view>
#include <vector>

class QColor;
class QGridLayout;
class QLabel;

/// Parts of the form of a record.
namespace adore::adrinput {

[[nodiscard]] QLabel* make_text_label(const QString& text, const QColor& colour, QWidget* parent);

inline constexpr int kBetween = 14;  ///< name and value
[[nodiscard]] QGridLayout* make_grid();

[[nodiscard]] std::vector<deck::OptionSpec> choices_of(const deck::VariableSpec& variable);
/// Are there codes beyond those that a list can show? Their meanings, or empty.
[[nodiscard]] QString typed_code_hint(const deck::VariableSpec& variable);
/// Text of a choice in a list: "1 — record 8.1".
[[nodiscard]] QString choice_text(std::string_view code, std::string_view meaning);

/// One of the four records of listed deviations, which are one table.
[[nodiscard]] inline bool is_diameter_record(const std::string& record) {
  return record.starts_with("5G.1D.");
}

/// A field as wide as its values need, less if there is no space.
class ValueLine : public QLineEdit {
 public:
  ValueLine(bool text, QWidget* parent);
  [[nodiscard]] QSize sizeHint() const override {
    return {preferred_width_, QLineEdit::sizeHint().height()};
  }

 private:
  int preferred_width_;
};

/// As wide as its longest text, less if there is no space; the open list is never narrower.
class ChoiceBox : public QComboBox {
 public:
  explicit ChoiceBox(QWidget* parent);
  /// A text that is not in the list, and must fit too.
  void widenForText(const QString& text);
  [[nodiscard]] QSize sizeHint() const override {
    return QComboBox::sizeHint().expandedTo({widest_text_width_, 0});
  }
  void showPopup() override;

 private:
  int widest_text_width_ = 0;
};

/// Is a list narrower than its selected text?
[[nodiscard]] bool is_text_cut_off(const QComboBox& combo);
/// Shows a text that is longer than its field from its beginning.
void show_combo_text_start(QComboBox* combo);

}  // namespace adore::adrinput
