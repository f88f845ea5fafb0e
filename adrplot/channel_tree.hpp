#pragma once

#include "adrplot/plot_document.hpp"

#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLineEdit;
class QMimeData;
class QTreeView;

namespace adore::adrplot {

/// A curve of an open file by its place: file, page (from 1), panel and name.
struct ChannelRef {
  int file = 0, page = 1, panel = 0;
  std::string curve;
};

/// Type of dragged channels.
inline constexpr const char* kChannelsMime = "application/x-adore-channels";
[[nodiscard]] std::vector<ChannelRef> channels_in(const QMimeData& data);

/// File, group, page, curve: every curve over steps of the open files.
class ChannelModel : public QStandardItemModel {
  Q_OBJECT
 public:
  enum Role { kRefRole = Qt::UserRole + 1, kPathRole };
  using QStandardItemModel::QStandardItemModel;
  void fill(const std::vector<const PlotDocument*>& files);
  [[nodiscard]] static std::optional<ChannelRef> refOf(const QModelIndex& index);
  [[nodiscard]] QStringList mimeTypes() const override { return {kChannelsMime}; }
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
};

/// Filtered channels: each word of the filter is in the name of the channel, its page or its file.
class ChannelFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit ChannelFilter(QObject* parent);
  void setFilterText(const QString& text);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QStringList words_;
};

/// The channels with a filter. Enter and double click use a channel, a context menu has the rest.
class ChannelTree : public QWidget {
  Q_OBJECT
 public:
  explicit ChannelTree(QWidget* parent = nullptr);
  void fill(const std::vector<const PlotDocument*>& files);
  [[nodiscard]] std::vector<ChannelRef> selected() const;
  [[nodiscard]] QTreeView& tree() { return *tree_; }

 signals:
  void addToChartRequested();  ///< selected channels to the chart
  void newChartRequested();    ///< selected channels in a new chart
  void formulaRequested();     ///< formula of the selected channels
  void pageRequested();        ///< page of the first selected channel

 private:
  void showMenu(const QPoint& at);

  QLineEdit* filter_;
  QTreeView* tree_;
  ChannelModel* model_;
  ChannelFilter* proxy_;
};

}  // namespace adore::adrplot
