#pragma once

#include "adrinput/study_document.hpp"

#include <QTableWidget>

namespace adore::adrinput {

/// One table of a study: a row for each entry and an empty one to type the next into. What is typed
/// reaches the document with every key.
class StudyTable : public QTableWidget {
  Q_OBJECT
 public:
  StudyTable(StudyDocument& document, const StudyTableSpec& spec, QWidget* parent = nullptr);

  void sync();
  [[nodiscard]] const StudyTableSpec& spec() const { return spec_; }
  void removeCurrentRow();
  /// The row that a sentence is about, or none (-1).
  void markRow(int row, const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fitHeight();

  StudyDocument& document_;
  const StudyTableSpec& spec_;
  bool syncing_ = false;
};

}  // namespace adore::adrinput
