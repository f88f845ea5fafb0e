#include "adrinput/drawing_panel.hpp"

#include "desktop/spoken_name.hpp"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QTimer>

#include <algorithm>
#include <exception>

namespace adore::adrinput {
namespace {

constexpr int kDrawPause = 60;  // ms without a change before the picture is drawn again

/// The drawing of an incomplete or damaged deck, or the reason why there is none: called by a
/// timer, whose event loop an exception would end with all windows.
drawing::Drawing draw_or_reason(drawing::View view, const deck::Deck& deck) {
  try {
    return drawing::draw(view, deck);
  } catch (const std::exception& error) {
    drawing::Drawing none;
    none.reason = error.what();
    return none;
  }
}

}  // namespace

DrawingPanel::DrawingPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("drawing-panel");
  views_ = new QComboBox(this);
  views_->setObjectName("drawing-views");
  desktop::name_box(*views_, tr("Drawing view"));
  auto* name = new QLabel(tr("Vie&w"), this);
  name->setBuddy(views_);
  picture_ = new DrawingView(this);
  picture_->setObjectName("drawing");
  auto* row = new QHBoxLayout;
  row->addWidget(name);
  row->addWidget(views_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->addLayout(row);
  column->addWidget(picture_, 1);
  pause_ = new QTimer(this);
  pause_->setSingleShot(true);
  pause_->setInterval(kDrawPause);
  connect(pause_, &QTimer::timeout, this, &DrawingPanel::drawNow);
  connect(views_, &QComboBox::activated, this, [this](int index) {
    chooseView(static_cast<drawing::View>(views_->itemData(index).toInt()));
  });
  connect(picture_, &DrawingView::dimensionClicked, this, &DrawingPanel::fieldWanted);
}

void DrawingPanel::setDeck(const deck::Deck& deck) {
  if (deck_ == deck && !deck_.records.empty()) return;
  deck_ = deck;
  pause_->start();
}

void DrawingPanel::fillViews() {
  const std::vector<drawing::View> views = drawing::views_of(deck_);
  std::vector<drawing::View> present;
  for (int i = 0; i < views_->count(); ++i)
    present.push_back(static_cast<drawing::View>(views_->itemData(i).toInt()));
  if (views != present) {
    views_->clear();
    for (const drawing::View view : views) {
      const std::string_view title = drawing::title_of(view);
      views_->addItem(QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())),
                      static_cast<int>(view));
    }
  }
  views_->setCurrentIndex(views_->findData(static_cast<int>(view())));
}

drawing::View DrawingPanel::view() const {
  const drawing::View wanted = chosen_.value_or(preferred_);
  const std::vector<drawing::View> views = drawing::views_of(deck_);
  const bool there = std::find(views.begin(), views.end(), wanted) != views.end();
  return there ? wanted : drawing::View::CrossSection;
}

void DrawingPanel::drawNow() {
  pause_->stop();
  if (deck_.records.empty()) return;
  // Of another type of bearing the last good drawing means nothing.
  const long long type = deck_.integer("kBrg");
  if (type != type_) good_.clear();
  type_ = type;
  fillViews();
  label();
  const drawing::View now = view();
  drawing::Drawing drawing = draw_or_reason(now, deck_);
  for (drawing::Pane& pane : drawing.panes) {
    for (drawing::Dimension& d : pane.dimensions)
      d.label = worded(d.label, d.variable, d.instance, d.index);
    for (drawing::Arrow& a : pane.arrows) a.label = worded(a.label, a.variable, 1, 1);
  }
  if (drawing.reason.empty()) {
    good_[now] = drawing;
    picture_->setDrawing(std::move(drawing));
    return;
  }
  const QString reason = QString::fromStdString(drawing.reason);
  const auto last = good_.find(now);
  picture_->setDrawing(last == good_.end() ? std::move(drawing) : last->second, reason);
}

void DrawingPanel::label() {
  const DrawingFocus& focus = picture_->focusOn();
  picture_->setFocusLabel(
      focus.variable.empty()
          ? QString()
          : QString::fromStdString(
                worded(drawing::label_of(deck_, focus.variable, focus.instance, focus.index),
                       focus.variable, focus.instance, focus.index)));
}

std::string DrawingPanel::worded(const std::string& label, const std::string& variable,
                                 int instance, int index) const {
  const QString own = wording ? wording(variable, instance, index) : QString();
  return own.isEmpty() ? label : own.toStdString();
}

void DrawingPanel::setFocusOn(DrawingFocus focus) {
  if (focus == picture_->focusOn()) return;
  const drawing::View wanted = drawing::view_for(focus.record, focus.variable);
  picture_->setFocusOn(std::move(focus));
  label();
  if (wanted == preferred_) return;  // a view chosen by hand stays
  preferred_ = wanted;
  chosen_.reset();
  drawNow();
}

void DrawingPanel::chooseView(drawing::View view) {
  chosen_ = view;
  drawNow();
}

}  // namespace adore::adrinput
