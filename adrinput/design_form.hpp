#pragma once

#include "adrinput/document.hpp"
#include "design/design_inputs.hpp"

#include <QWidget>

#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QTimer;

namespace adore::adrinput {

/// Inputs of the design page: bearing by designation, operation, oil and main dimensions. They are
/// variables of the deck, in units that people use; the record forms show the same values.
class DesignForm : public QWidget {
  Q_OBJECT
 public:
  explicit DesignForm(Document& document, QWidget* parent = nullptr);
  ~DesignForm() override;

  /// The document has changed.
  void sync();
  /// Enters the text into the deck if it is valid, and leaves it in the field.
  void acceptValidFields();
  /// The same for any text, as when its field is left.
  void commitFields();
  void focusBearing();
  [[nodiscard]] QLineEdit& bearingField() { return *bearing_field_; }
  /// The field of a variable; nullptr: the deck does not have it.
  [[nodiscard]] QLineEdit* fieldOf(const std::string& variable) const;
  [[nodiscard]] QComboBox& oilField() { return *oil_box_; }

 signals:
  void catalogRequested();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  struct Field {
    design::DesignInput input;
    QLabel *name = nullptr, *unit = nullptr;
    QLineEdit* line = nullptr;
  };
  [[nodiscard]] Field makeField(const design::DesignInput& input);
  void rebuild();
  void applyBearing();
  void applyField(Field& field, bool finished);
  void showBearing();
  void fillOils();
  /// Cells of an input in the deck.
  [[nodiscard]] std::vector<Cell> cellsOf(const design::DesignInput& input) const;

  Document& document_;
  QLineEdit* bearing_field_;
  QLabel* bearing_facts_;
  QWidget* oil_row_;
  QComboBox* oil_box_;
  QGridLayout* grid_;
  std::vector<Field> fields_;
  QTimer* delay_timer_;
  bool applying_input_ = false;
};

}  // namespace adore::adrinput
