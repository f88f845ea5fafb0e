#pragma once

#include "adrinput/document.hpp"

#include <QWidget>

class QLineEdit;
class QListWidget;
class QStackedWidget;
class QToolButton;

namespace adore::adrinput {

/// The records of the deck with their state at a glance, and the search for a variable above them.
class RecordList : public QWidget {
  Q_OBJECT
 public:
  explicit RecordList(Document& document, QWidget* parent = nullptr);

  void sync();
  void setCurrentRecord(const std::string& record);
  void startSearch();
  void focusRecords();

 signals:
  void recordChosen(const QString& record);
  /// Of a record that the deck may not have.
  void variableChosen(const QString& record, int variable);
  /// The user wants to see why the deck is in its state.
  void stateClicked();
  void designChosen();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void search(const QString& query);
  void chooseSearchResult(int row);
  void updateSearchResults();
  void syncState();

  Document& document_;
  QLineEdit* query_;
  QStackedWidget* stack_;
  QListWidget* records_;
  QListWidget* search_results_;
  QToolButton *state_, *design_;  ///< of the deck as a whole; the front page
};

/// Sign and color of a state: a check mark, a ring, a triangle or a cross.
[[nodiscard]] QIcon state_icon(RecordState state);
[[nodiscard]] QString state_text(RecordState state);

}  // namespace adore::adrinput
