#include "adrplot/curve_dialog.hpp"

#include "desktop/dialogs.hpp"
#include "desktop/spoken_name.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace adore::adrplot {
namespace {

constexpr int kFile = Qt::UserRole, kPage = Qt::UserRole + 1, kPanel = Qt::UserRole + 2,
              kCurve = Qt::UserRole + 3;

/// Pages and curves of a file when its branch is opened: until then nothing is read.
void fill(QTreeWidgetItem* root, const PlotDocument& file, int index, const PageOptions& options) {
  for (std::size_t p = 0; p < file.pages.size(); ++p) {
    if (file.pages[p].kind == PageKind::Orbit || file.pages[p].kind == PageKind::Spectrum) continue;
    const desktop::ChartPage page = file.build(static_cast<int>(p + 1), options);
    if (page.equal_axes) continue;
    auto* branch = new QTreeWidgetItem(root, {QString::fromStdString(file.pages[p].title)});
    for (std::size_t i = 0; i < page.panels.size(); ++i)
      for (std::size_t c = 0; c < page.panels[i].curves.size(); ++c) {
        const std::string& name = page.panels[i].curves[c].name;
        auto* item = new QTreeWidgetItem(
            branch,
            {QString::fromStdString(page.panels[i].title + (name.empty() ? "" : ", " + name)),
             QString::fromStdString(page.panels[i].unit)});
        item->setCheckState(0, Qt::Unchecked);
        item->setData(0, kFile, index);
        item->setData(0, kPage, static_cast<int>(p + 1));
        item->setData(0, kPanel, static_cast<int>(i));
        item->setData(0, kCurve, static_cast<int>(c));
      }
  }
}

}  // namespace

CurveDialog::CurveDialog(const std::vector<const PlotDocument*>& files, const PageOptions& options,
                         const CurveChoice& before, QWidget* parent)
    : QDialog(parent), files_(files) {
  setWindowTitle(tr("Combine curves"));
  desktop::delete_when_done(*this);
  resize(620, 520);
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel(
      tr("Select curves of one or more runs. Curves with the same unit share a panel."), this));
  tree_ = new QTreeWidget(this);
  tree_->setAccessibleName(tr("Curves"));
  tree_->setObjectName("curves");
  tree_->setHeaderLabels({tr("Curve"), tr("Unit")});
  tree_->setColumnWidth(0, 440);
  column->addWidget(tree_, 1);
  combination_box_ = new QComboBox(this);
  combination_box_->setObjectName("how");
  combination_box_->addItems({tr("Draw together"), tr("Draw differences from:")});
  desktop::set_accessible_name(*combination_box_, tr("Chart content"));
  column->addWidget(combination_box_);
  reference_ = new QComboBox(this);
  reference_->setObjectName("reference");
  desktop::set_accessible_name(*reference_, tr("Reference curve"));
  reference_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  column->addWidget(reference_);
  connect(combination_box_, &QComboBox::currentIndexChanged, this, &CurveDialog::fillReferenceBox);
  connect(reference_, &QComboBox::activated, this,
          [this](int index) { chosen_ = checked_items_.at(static_cast<std::size_t>(index)); });
  connect(tree_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    const bool on = item->checkState(0) == Qt::Checked;
    const auto known = std::find(checked_items_.begin(), checked_items_.end(), item);
    if (on && known == checked_items_.end()) checked_items_.push_back(item);
    if (!on && known != checked_items_.end()) checked_items_.erase(known);
    fillReferenceBox();
  });
  fillReferenceBox();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  PageOptions history = options;
  history.domain = Domain::History;
  for (std::size_t f = 0; f < files_.size(); ++f) {
    const PlotDocument& file = *files_[f];
    auto* root = new QTreeWidgetItem(
        tree_,
        {QString::fromStdString((run_folder(file.path).filename() / file.path.filename()).string() +
                                " — " + file.subject)});
    root->setToolTip(0, QString::fromStdString(file.path.string()));
    root->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
  }
  connect(tree_, &QTreeWidget::itemExpanded, this, [this, history](QTreeWidgetItem* item) {
    const int index = tree_->indexOfTopLevelItem(item);
    if (index >= 0 && item->childCount() == 0)
      fill(item, *files_[static_cast<std::size_t>(index)], index, history);
  });
  if (tree_->topLevelItemCount() == 1) tree_->topLevelItem(0)->setExpanded(true);
  checkCurves(before);
}

void CurveDialog::checkCurves(const CurveChoice& before) {
  combination_box_->setCurrentIndex(before.how == Combine::Difference ? 1 : 0);
  QTreeWidgetItem* first = nullptr;
  for (const CurveChoice::Curve& one : before.curves)
    for (std::size_t f = 0; f < files_.size(); ++f) {
      if (files_[f]->path != one.file) continue;
      QTreeWidgetItem* root = tree_->topLevelItem(static_cast<int>(f));
      root->setExpanded(true);  // fills it
      for (int p = 0; p < root->childCount(); ++p)
        for (int c = 0; c < root->child(p)->childCount(); ++c) {
          QTreeWidgetItem* item = root->child(p)->child(c);
          if (item->data(0, kPage).toInt() != one.page ||
              item->data(0, kPanel).toInt() != static_cast<int>(one.panel) ||
              item->data(0, kCurve).toInt() != static_cast<int>(one.curve))
            continue;
          if (one.reference) chosen_ = item;
          item->setCheckState(0, Qt::Checked);
          root->child(p)->setExpanded(true);
          if (first == nullptr) first = item;
        }
    }
  if (first != nullptr) tree_->scrollToItem(first);
}

/// The curves in the order of their ticks.
void CurveDialog::fillReferenceBox() {
  reference_->clear();
  for (const QTreeWidgetItem* item : checked_items_)
    reference_->addItem(QString("%1 · %2").arg(item->text(0), item->parent()->parent()->text(0)));
  const auto kept = std::find(checked_items_.begin(), checked_items_.end(), chosen_);
  if (kept == checked_items_.end()) chosen_ = nullptr;
  if (!checked_items_.empty())
    reference_->setCurrentIndex(
        chosen_ == nullptr ? 0 : static_cast<int>(kept - checked_items_.begin()));
  reference_->setEnabled(how() == Combine::Difference && !checked_items_.empty());
}

std::vector<CurvePick> CurveDialog::picks() const {
  std::vector<CurvePick> out;
  const QTreeWidgetItem* const reference = how() == Combine::Overlay || checked_items_.empty()
                                               ? nullptr
                                           : chosen_ == nullptr ? checked_items_.front()
                                                                : chosen_;
  for (int f = 0; f < tree_->topLevelItemCount(); ++f)
    for (int p = 0; p < tree_->topLevelItem(f)->childCount(); ++p) {
      const QTreeWidgetItem* branch = tree_->topLevelItem(f)->child(p);
      for (int c = 0; c < branch->childCount(); ++c) {
        const QTreeWidgetItem* item = branch->child(c);
        if (item->checkState(0) != Qt::Checked) continue;
        out.insert(
            item == reference ? out.begin() : out.end(),
            {files_[static_cast<std::size_t>(item->data(0, kFile).toInt())],
             item->data(0, kPage).toInt(), static_cast<std::size_t>(item->data(0, kPanel).toInt()),
             static_cast<std::size_t>(item->data(0, kCurve).toInt())});
      }
    }
  return out;
}

CurveChoice CurveDialog::choice() const {
  CurveChoice out{.how = how()};
  for (const QTreeWidgetItem* item : checked_items_)
    out.curves.push_back(
        {files_[static_cast<std::size_t>(item->data(0, kFile).toInt())]->path,
         item->data(0, kPage).toInt(), static_cast<std::size_t>(item->data(0, kPanel).toInt()),
         static_cast<std::size_t>(item->data(0, kCurve).toInt()), item == chosen_});
  return out;
}

Combine CurveDialog::how() const {
  return combination_box_->currentIndex() == 1 ? Combine::Difference : Combine::Overlay;
}

}  // namespace adore::adrplot
