#pragma once

#include "adrinput/document.hpp"

#include <QTableWidget>

namespace adore::adrinput {

/// Values side by side: the elements of an array (one row), or a repeated record (a row per
/// variable and element, a column per instance). Cells are edited in place.
class CellTable : public QTableWidget {
  Q_OBJECT
 public:
  /// An array of a record that occurs once.
  CellTable(Document& document, const std::string& record, std::size_t variable,
            QWidget* parent = nullptr);
  /// A repeated record.
  CellTable(Document& document, const std::string& record, QWidget* parent = nullptr);

  /// The four records of ten listed diameter deviations, as one table.
  static CellTable* createForListedDiameters(Document& document, QWidget* parent);

  void sync();
  /// Shows each value in the other unit system, too.
  void setOtherUnitsShown(bool shown);
  /// Pastes the clipboard from the current cell on: one step for undo.
  void paste();
  /// False when the cell is not in this table.
  bool focusCell(const Cell& cell);
  [[nodiscard]] Cell cellAt(int row, int column) const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void resizeEvent(QResizeEvent* event) override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

 private:
  struct Line {
    std::size_t variable = 0, element = 0;
    std::string record;  ///< of a table of several records: a column per variable
  };
  explicit CellTable(Document& document, QWidget* parent);
  void setUp();
  /// Each with the unit that its values are shown in.
  void nameRows();
  void fillCell(int row, int column);
  void fitHeight();
  [[nodiscard]] bool atEnd(bool next) const;
  void pasteInOrder(const QString& text);
  [[nodiscard]] bool hasSeveralRecords() const { return !lines_.front().record.empty(); }

  Document& document_;
  std::string record_;
  bool is_repeated_record_ = false;
  bool shows_other_units_ = false;
  std::vector<Line> lines_;  ///< rows
  QSize content_size_;       ///< all of them, without a bar
};

}  // namespace adore::adrinput
