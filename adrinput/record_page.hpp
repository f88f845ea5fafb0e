#pragma once

#include "adrinput/document.hpp"

#include <QWidget>

#include <memory>
#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QComboBox;
class QPlainTextEdit;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace adore::adrinput {

class CellTable;

/// The form of one record, generated from the schema: a row per variable with its field, unit,
/// limits, help and problems; arrays and repeated records as tables.
class RecordPage : public QWidget {
  Q_OBJECT
 public:
  RecordPage(Document& document, const std::string& record, QWidget* parent = nullptr);
  ~RecordPage() override;

  [[nodiscard]] const std::string& record() const { return record_; }
  /// Shows the content of the document. The field being edited keeps its text unless `all`.
  void sync(bool all = false);
  /// Puts the keyboard focus on a value. False when this page has no field for it.
  bool focusCell(const Cell& cell);
  void focusFirst();
  /// Shows each value in the other unit system, too.
  void setOtherUnitsShown(bool shown);
  /// The field of a variable: QLineEdit or QComboBox, or its table.
  [[nodiscard]] QWidget* fieldOf(std::size_t variable) const;

 signals:
  void otherUnitsToggled(bool shown);
  /// A kind of quantity is to be shown in another unit from now on.
  void unitChosen();
  /// A field got the focus and should be in view.
  void focusMoved(QWidget* field);
  /// The same, as the value that is worked on.
  void cellFocused(const Cell& cell);

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  struct Row {
    std::size_t variable = 0;
    QGridLayout* grid = nullptr;
    int at = 0;                    ///< the first of its rows in the grid
    QVBoxLayout* value = nullptr;  ///< field and its other widgets
    QHBoxLayout* side = nullptr;   ///< field, unit and, if there is space, its limits
    QLabel* help = nullptr;
    QLineEdit* line = nullptr;
    QComboBox* combo = nullptr;
    CellTable* table = nullptr;
    QLabel* unit = nullptr;
    QToolButton* choice = nullptr;  ///< of the unit that the value is shown in
    QToolButton* names = nullptr;   ///< a list of names to choose from
    QLabel* name = nullptr;
    QLabel* other = nullptr;   ///< the value in other units, and its meaning
    QLabel* unused = nullptr;  ///< why nothing uses the value
    QLabel* problem = nullptr;
  };
  void addHeading(QVBoxLayout* layout);
  void addVariable(QGridLayout* grid, std::size_t variable);
  void addInstances(QVBoxLayout* layout);
  void addListedDiameters(QVBoxLayout* layout);
  void addUserLines(QVBoxLayout* layout);
  QLineEdit* makeLineEdit(const Cell& cell);
  QComboBox* makeCombo(const Cell& cell);
  QPushButton* makeUnitsButton();
  bool openMenuOf(const QWidget* field, const QKeyEvent& key);
  QToolButton* makeEffectsButton(const Cell& cell);
  QToolButton* makeUnitChoice(const deck::VariableSpec& variable);
  void finish(QWidget* field);
  void syncRow(Row& row, bool all);
  void syncCombo(Row& row, const QString& value, bool all);
  void showStatusOfRow(Row& row);
  void place(Row& row);
  void fitToWidth(int width);
  void showProblems(Row& row);
  void announceFocusedCell(const QWidget* field);
  [[nodiscard]] Cell cellOf(std::size_t variable) const;

  Document& document_;
  std::string record_;
  const deck::RecordSpec& spec_;
  std::vector<Row> rows_;
  QLabel* condition_label_ = nullptr;
  QPushButton* other_units_ = nullptr;  ///< next to kUnit
  bool shows_other_units_ = false;
  bool narrow_layout_ = false;  ///< names are above their values, not next to them
  QPlainTextEdit* user_lines_edit_ = nullptr;
};

}  // namespace adore::adrinput
