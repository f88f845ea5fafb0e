#include "adrplot/channel_tree.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace adore::adrplot {
namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

QStandardItem* item_of(const QString& text) {
  auto* item = new QStandardItem(text);
  item->setEditable(false);
  return item;
}

QString leaf_name(const std::string& panel, const std::string& curve, const std::string& page) {
  if (curve.empty()) return text_of(panel);
  return text_of(panel == page || curve.starts_with(panel) ? curve : panel + ", " + curve);
}

void add_page(QStandardItem* branch, const QString& file_name, const PlotDocument::Entry& entry,
              int file, int page) {
  auto* item = item_of(text_of(entry.title));
  for (std::size_t p = 0; p < entry.curves.size(); ++p)
    for (const std::string& curve : entry.curves[p]) {
      auto* leaf = item_of(leaf_name(entry.panels[p], curve, entry.title));
      leaf->setData(QJsonArray{file, page, static_cast<int>(p), text_of(curve)},
                    ChannelModel::kRefRole);
      leaf->setData(
          file_name + ' ' + text_of(entry.group) + ' ' + item->text() + ' ' + leaf->text(),
          ChannelModel::kPathRole);
      item->appendRow(leaf);
    }
  branch->appendRow(item);
}

}  // namespace

std::vector<ChannelRef> channels_in(const QMimeData& data) {
  std::vector<ChannelRef> out;
  for (const QJsonValue one : QJsonDocument::fromJson(data.data(kChannelsMime)).array()) {
    const QJsonArray ref = one.toArray();
    if (ref.size() == 4)
      out.push_back(
          {ref[0].toInt(), ref[1].toInt(), ref[2].toInt(), ref[3].toString().toStdString()});
  }
  return out;
}

void ChannelModel::fill(const std::vector<const PlotDocument*>& files) {
  clear();
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (files[f] == nullptr) continue;
    const PlotDocument& file = *files[f];
    const std::string folder = run_folder(file.path).filename().string();
    auto* root = item_of(text_of((folder.empty() ? "" : folder + "/") +
                                 file.path.filename().string() + " — " + file.subject));
    root->setToolTip(text_of(file.path.string()));
    std::map<std::string, QStandardItem*> groups;
    for (std::size_t p = 0; p < file.pages.size(); ++p) {
      const PlotDocument::Entry& entry = file.pages[p];
      if (entry.curves.empty()) continue;
      QStandardItem* branch = root;
      if (!entry.group.empty()) {
        QStandardItem*& group = groups[entry.group];
        if (group == nullptr) root->appendRow(group = item_of(text_of(entry.group)));
        branch = group;
      }
      add_page(branch, root->text(), entry, static_cast<int>(f), static_cast<int>(p) + 1);
    }
    if (root->hasChildren())
      appendRow(root);
    else
      delete root;
  }
}

std::optional<ChannelRef> ChannelModel::refOf(const QModelIndex& index) {
  const QJsonArray ref = index.data(kRefRole).toJsonArray();
  if (ref.size() != 4) return std::nullopt;
  return ChannelRef{ref[0].toInt(), ref[1].toInt(), ref[2].toInt(),
                    ref[3].toString().toStdString()};
}

QMimeData* ChannelModel::mimeData(const QModelIndexList& indexes) const {
  QJsonArray all;
  for (const QModelIndex& index : indexes)
    if (const QJsonArray ref = index.data(kRefRole).toJsonArray(); ref.size() == 4) all.append(ref);
  if (all.isEmpty()) return nullptr;
  auto* out = new QMimeData;
  out->setData(kChannelsMime, QJsonDocument(all).toJson(QJsonDocument::Compact));
  return out;
}

ChannelFilter::ChannelFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setRecursiveFilteringEnabled(true);
}

void ChannelFilter::setFilterText(const QString& text) {
  words_ = text.split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

bool ChannelFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QString path =
      sourceModel()->index(row, 0, parent).data(ChannelModel::kPathRole).toString();
  // Branches are shown for their channels.
  return !path.isEmpty() && std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
    return path.contains(word, Qt::CaseInsensitive);
  });
}

ChannelTree::ChannelTree(QWidget* parent)
    : QWidget(parent),
      filter_(new QLineEdit(this)),
      tree_(new QTreeView(this)),
      model_(new ChannelModel(this)),
      proxy_(new ChannelFilter(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 0);
  column->setSpacing(4);
  filter_->setObjectName("channelFilter");
  filter_->setPlaceholderText(tr("Filter: load outer 3"));
  filter_->setAccessibleName(tr("Filter of channels"));
  filter_->setClearButtonEnabled(true);
  column->addWidget(filter_);
  proxy_->setSourceModel(model_);
  tree_->setModel(proxy_);
  tree_->setObjectName("channels");
  tree_->setAccessibleName(tr("Channels"));
  tree_->setHeaderHidden(true);
  tree_->setUniformRowHeights(true);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setDragEnabled(true);
  tree_->setDragDropMode(QAbstractItemView::DragOnly);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  column->addWidget(tree_, 1);
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    proxy_->setFilterText(text);
    constexpr int kFew = 200;  // channels that are shown at once
    if (!text.trimmed().isEmpty() && proxy_->rowCount() <= kFew)
      tree_->expandAll();
    else
      tree_->collapseAll();
  });
  connect(tree_, &QTreeView::activated, this, [this](const QModelIndex& index) {
    if (ChannelModel::refOf(index)) emit addToChartRequested();
  });
  connect(tree_, &QTreeView::customContextMenuRequested, this, &ChannelTree::showMenu);
}

void ChannelTree::fill(const std::vector<const PlotDocument*>& files) {
  model_->fill(files);
  if (proxy_->rowCount() == 1) tree_->expand(proxy_->index(0, 0));
}

std::vector<ChannelRef> ChannelTree::selected() const {
  std::vector<ChannelRef> out;
  QModelIndexList chosen = tree_->selectionModel()->selectedIndexes();
  std::sort(chosen.begin(), chosen.end());
  for (const QModelIndex& index : chosen)
    if (const auto ref = ChannelModel::refOf(index)) out.push_back(*ref);
  return out;
}

void ChannelTree::showMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  connect(menu, &QMenu::aboutToHide, menu, &QObject::deleteLater);
  menu->setObjectName("channelMenu");
  const bool any = !selected().empty();
  const auto add = [&](const QString& text, auto signal) {
    menu->addAction(text, this, signal)->setEnabled(any);
  };
  add(tr("&Add to Chart"), &ChannelTree::addToChartRequested);
  add(tr("&New Chart"), &ChannelTree::newChartRequested);
  add(tr("&Formula of Selected Channels..."), &ChannelTree::formulaRequested);
  add(tr("&Show Page"), &ChannelTree::pageRequested);
  menu->addAction(tr("&Copy Names"),
                  [this] {
                    QStringList names;
                    for (const QModelIndex& index : tree_->selectionModel()->selectedIndexes())
                      names << index.data().toString();
                    QGuiApplication::clipboard()->setText(names.join('\n'));
                  })
      ->setEnabled(any);
  menu->addSeparator();
  menu->addAction(tr("&Expand All"), tree_, &QTreeView::expandAll);
  menu->addAction(tr("C&ollapse All"), tree_, &QTreeView::collapseAll);
  menu->popup(tree_->viewport()->mapToGlobal(at));
}

}  // namespace adore::adrplot
