#pragma once

#include "adrinput/study_document.hpp"

#include <QTableWidget>

namespace adore::adrinput {

/// One table of a study: a row for each entry and an empty one for the next. The document is
/// updated with every key.
class StudyTable : public QTableWidget {
  Q_OBJECT
 public:
  StudyTable(StudyDocument& document, const StudyTableSpec& spec, QWidget* parent = nullptr);

  void sync();
  [[nodiscard]] const StudyTableSpec& spec() const { return spec_; }
  void removeCurrentRow();
  /// The row of an error, or none (-1).
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
