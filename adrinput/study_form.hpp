#pragma once

#include "adrinput/study_document.hpp"

#include <QWidget>

#include <vector>

class QBoxLayout;
class QGroupBox;
class QLabel;

namespace adore::adrinput {

class StudyTable;

/// A study file as fields and tables.
class StudyForm : public QWidget {
  Q_OBJECT
 public:
  explicit StudyForm(StudyDocument& document, QWidget* parent = nullptr);

  void sync();
  /// Marks the field or row that `key` ("variables[2].normal") names with the sentence.
  void showProblem(const std::string& key, const QString& sentence);
  /// Shows that field; false if the form does not have it.
  bool goTo(const std::string& key);
  [[nodiscard]] StudyTable* table(std::string_view key) const;

 signals:
  void deckChoiceRequested();

 private:
  struct Field {
    const StudyField* spec;
    QWidget* input;
    QLabel* label;
    QGroupBox* group;
  };
  void addGroup(QBoxLayout* column, std::string_view name);
  void addTable(QBoxLayout* column, const StudyTableSpec& spec);
  void syncField(const Field& field);
  [[nodiscard]] const Field* fieldOf(const std::string& key) const;

  StudyDocument& document_;
  std::vector<Field> fields_;
  std::vector<StudyTable*> tables_;
  std::vector<QWidget*> table_boxes_;
};

}  // namespace adore::adrinput
