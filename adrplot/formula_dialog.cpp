#include "adrplot/formula_dialog.hpp"

#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/dialogs.hpp"
#include "signal/channel_formula.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace adore::adrplot {

FormulaDialog::FormulaDialog(const std::vector<const PlotDocument*>& files,
                             std::function<FormulaInput(const ChannelRef&)> find,
                             const PageOptions& options, QWidget* parent)
    : QDialog(parent), find_(std::move(find)), options_(options) {
  setWindowTitle(tr("Formula channel"));
  desktop::delete_when_done(*this);
  resize(620, 640);
  options_.domain = Domain::History;
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  const auto field = [&](const QString& label, const char* name, const QString& example) {
    auto* out = new QLineEdit(this);
    out->setObjectName(name);
    out->setPlaceholderText(example);
    form->addRow(label, out);
    connect(out, &QLineEdit::textChanged, this, &FormulaDialog::check);
    return out;
  };
  title_ = field(tr("&Name"), "title", tr("Radial force"));
  formula_ = field(tr("&Formula"), "formula", "sqrt(a^2 + b^2)");
  unit_ = field(tr("&Unit"), "unit", "N");
  column->addLayout(form);
  column->addWidget(new QLabel(tr("Double-click a channel to use it in the formula."), this));
  tree_ = new ChannelTree(this);
  tree_->fill(files);
  column->addWidget(tree_, 3);
  connect(tree_, &ChannelTree::addToChartRequested, this,
          [this] { addChannels(tree_->selected()); });
  table_ = new QTableWidget(0, 2, this);
  table_->setObjectName("inputs");
  table_->setAccessibleName(tr("Names in the formula"));
  table_->setHorizontalHeaderLabels({tr("Name in the formula"), tr("Channel")});
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->verticalHeader()->hide();
  column->addWidget(table_, 2);
  connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() != 0) return;
    inputs_.at(static_cast<std::size_t>(item->row())).name = item->text().trimmed().toStdString();
    check();
  });
  result_ = new QLabel(this);
  result_->setObjectName("result");
  result_->setWordWrap(true);
  result_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  column->addWidget(result_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons_);
  check();
}

QString FormulaDialog::unusedInputName() const {
  for (int i = 0;; ++i) {
    const QString letter = QString(QChar('a' + i % 26));
    const QString name = i < 26 ? letter : letter + QString::number(i / 26);
    if (std::none_of(inputs_.begin(), inputs_.end(), [&](const FormulaInput& input) {
          return QString::fromStdString(input.name) == name;
        }))
      return name;
  }
}

void FormulaDialog::addInput(FormulaInput input) {
  if (input.name.empty()) input.name = unusedInputName().toStdString();
  const QSignalBlocker quiet(table_);
  const int row = table_->rowCount();
  table_->insertRow(row);
  table_->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(input.name)));
  const PlotDocument::Entry& page = input.file->pages.at(static_cast<std::size_t>(input.page - 1));
  QString text = QString::fromStdString(page.panels.at(input.panel));
  if (!input.curve.empty()) text += ", " + QString::fromStdString(input.curve);
  text += " — " + QString::fromStdString(input.file->path.filename().string());
  auto* channel = new QTableWidgetItem(text);
  channel->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  table_->setItem(row, 1, channel);
  inputs_.push_back(std::move(input));
}

void FormulaDialog::addChannels(const std::vector<ChannelRef>& channels) {
  for (const ChannelRef& channel : channels) addInput(find_(channel));
  check();
}

void FormulaDialog::setChannel(const FormulaChannel& channel) {
  title_->setText(QString::fromStdString(channel.title));
  unit_->setText(QString::fromStdString(channel.unit));
  for (const FormulaInput& input : channel.inputs) addInput(input);
  formula_->setText(QString::fromStdString(channel.formula));
  check();
}

/// Only with the channels that it uses.
FormulaChannel FormulaDialog::channel() const {
  FormulaChannel out{title_->text().trimmed().toStdString(),
                     formula_->text().toStdString(),
                     unit_->text().trimmed().toStdString(),
                     {}};
  if (out.title.empty()) out.title = out.formula;
  const std::vector<std::string> used = signal::variable_names_in(out.formula);
  for (const FormulaInput& input : inputs_)
    if (std::find(used.begin(), used.end(), input.name) != used.end()) out.inputs.push_back(input);
  return out;
}

void FormulaDialog::check() {
  QString text;
  bool valid = false;
  try {
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (!signal::is_formula_name(inputs_[i].name))
        throw InputError("\"" + inputs_[i].name +
                         "\" cannot be a name in a formula. Use letters, digits and underscores");
      for (std::size_t k = 0; k < i; ++k)
        if (inputs_[k].name == inputs_[i].name)
          throw InputError("the name \"" + inputs_[i].name + "\" is used twice");
    }
    if (formula_->text().trimmed().isEmpty()) {
      text = tr("Enter a formula. Functions: sqrt, abs, sin, cos, atan2, exp, log10, min, max, …");
    } else {
      const FormulaChannel now = channel();
      const desktop::ChartPage page = formula_page(now, options_);
      desktop::Extent extent;
      for (const double v : page.panels.front().curves.front().y) extent.include(v);
      valid = !extent.empty();
      const auto number = [&](double v) {
        return QString::fromStdString(desktop::pretty_quantity(v, now.unit));
      };
      text = valid ? tr("%1 to %2").arg(number(extent.low), number(extent.high))
                   : tr("The formula has no values.");
    }
  } catch (const std::exception& error) {
    text = QString::fromUtf8(error.what());
  }
  result_->setText(text);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(valid);
}

}  // namespace adore::adrplot
