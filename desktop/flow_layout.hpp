#pragma once

#include <QLayout>
#include <QList>

namespace adore::desktop {

/// Widgets in a row that wraps in a narrow window, like words. The rest of a row is given to
/// widgets that grow, and to stretches.
class FlowLayout : public QLayout {
 public:
  explicit FlowLayout(QWidget* parent = nullptr) : QLayout(parent) {}
  ~FlowLayout() override;

  void addStretch();

  void addItem(QLayoutItem* item) override { items_.append(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override { return items_.value(index); }
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize minimumSize() const override;
  [[nodiscard]] QSize sizeHint() const override;
  void setGeometry(const QRect& rect) override;

 private:
  /// Height used; moves the items if `place`.
  int flow(const QRect& rect, bool place) const;
  QList<QLayoutItem*> items_;
};

}  // namespace adore::desktop
