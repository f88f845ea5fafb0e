#pragma once

#include "calculators/calculator_schema.hpp"
#include "calculators/calculators.hpp"

#include <QDialog>

#include <map>
#include <vector>

class QBoxLayout;
class QComboBox;
class QLabel;
class QScrollArea;
class QTableWidget;

namespace adore::adrinput {

/// Component calculators (`adore calc`). Calculators, kinds, fields, units and ranges come from the
/// schema (calculators/calculator_schema.hpp), results and errors from calculate().
///
/// One field per input. Values of a list are separated by commas, rows of a list of lists by
/// semicolons; lists of objects have one value per object ("lands[].race": inner, outer).
class CalculatorDialog : public QDialog {
  Q_OBJECT
 public:
  explicit CalculatorDialog(QWidget* parent = nullptr);

  void fillExample();
  void compute();
  /// {"inputs": {...}}, with "kind" where the inputs do not select it.
  [[nodiscard]] nlohmann::json input() const;
  [[nodiscard]] const calculators::SchemaKind& kind() const { return *kinds_.at(kindIndex()); }

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Field {
    const calculators::SchemaInput* input;
    QWidget* editor;  ///< QComboBox of codes, else QLineEdit
    QLabel* error;
  };

  [[nodiscard]] const calculators::CalculatorInfo& calculator() const;
  [[nodiscard]] std::size_t kindIndex() const;
  void showCalculator();
  void showKind();
  void addField(QBoxLayout& column, const calculators::SchemaInput& input);
  /// Height of the fields: their texts wrap.
  void fitPage();
  void clearResults();
  void showError(const QString& variable, const QString& text);
  void showResults(const nlohmann::json& results);

  QComboBox *calculator_, *kind_;
  QScrollArea* scroll_area_;
  QLabel *help_, *message_;
  QTableWidget* results_;
  std::vector<const calculators::SchemaKind*> kinds_;
  std::vector<Field> fields_;
};

}  // namespace adore::adrinput
