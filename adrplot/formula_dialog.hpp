#pragma once

#include "adrplot/channel_tree.hpp"
#include "adrplot/formula_document.hpp"

#include <QDialog>

#include <functional>

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QTableWidget;

namespace adore::adrplot {

/// Name, formula, unit and channels of a computed channel. The result or the error is shown while
/// the formula is typed.
class FormulaDialog : public QDialog {
  Q_OBJECT
 public:
  /// `find` gives the input of a channel of the tree. @param files of the tree, alive as long
  FormulaDialog(const std::vector<const PlotDocument*>& files,
                std::function<FormulaInput(const ChannelRef&)> find, const PageOptions& options,
                QWidget* parent = nullptr);
  void addChannels(const std::vector<ChannelRef>& channels);
  void setChannel(const FormulaChannel& channel);
  [[nodiscard]] FormulaChannel channel() const;

 private:
  void addInput(FormulaInput input);
  void check();
  [[nodiscard]] QString unusedInputName() const;

  std::function<FormulaInput(const ChannelRef&)> find_;
  PageOptions options_;
  std::vector<FormulaInput> inputs_;
  QLineEdit* title_;
  QLineEdit* formula_;
  QLineEdit* unit_;
  ChannelTree* tree_;
  QTableWidget* table_;
  QLabel* result_;
  QDialogButtonBox* buttons_;
};

}  // namespace adore::adrplot
