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
  view_box_ = new QComboBox(this);
  view_box_->setObjectName("drawing-views");
  desktop::set_accessible_name(*view_box_, tr("Drawing view"));
  auto* name = new QLabel(tr("Vie&w"), this);
  name->setBuddy(view_box_);
  drawing_view_ = new DrawingView(this);
  drawing_view_->setObjectName("drawing");
  auto* row = new QHBoxLayout;
  row->addWidget(name);
  row->addWidget(view_box_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->addLayout(row);
  column->addWidget(drawing_view_, 1);
  delay_timer_ = new QTimer(this);
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kDrawPause);
  connect(delay_timer_, &QTimer::timeout, this, &DrawingPanel::drawNow);
  connect(view_box_, &QComboBox::activated, this, [this](int index) {
    chooseView(static_cast<drawing::View>(view_box_->itemData(index).toInt()));
  });
  connect(drawing_view_, &DrawingView::dimensionClicked, this, &DrawingPanel::fieldRequested);
}

void DrawingPanel::setDeck(const deck::Deck& deck) {
  if (deck_ == deck && !deck_.records.empty()) return;
  deck_ = deck;
  delay_timer_->start();
}

void DrawingPanel::fillViews() {
  const std::vector<drawing::View> views = drawing::views_of(deck_);
  std::vector<drawing::View> present;
  for (int i = 0; i < view_box_->count(); ++i)
    present.push_back(static_cast<drawing::View>(view_box_->itemData(i).toInt()));
  if (views != present) {
    view_box_->clear();
    for (const drawing::View view : views) {
      const std::string_view title = drawing::title_of(view);
      view_box_->addItem(QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())),
                         static_cast<int>(view));
    }
  }
  view_box_->setCurrentIndex(view_box_->findData(static_cast<int>(view())));
}

drawing::View DrawingPanel::view() const {
  const drawing::View wanted = chosen_view_.value_or(preferred_view_);
  const std::vector<drawing::View> views = drawing::views_of(deck_);
  const bool there = std::find(views.begin(), views.end(), wanted) != views.end();
  return there ? wanted : drawing::View::CrossSection;
}

void DrawingPanel::drawNow() {
  delay_timer_->stop();
  if (deck_.records.empty()) return;
  // Of another type of bearing the last good drawing means nothing.
  const long long type = deck_.integer("kBrg");
  if (type != drawn_bearing_type_) last_valid_drawings_.clear();
  drawn_bearing_type_ = type;
  fillViews();
  label();
  const drawing::View now = view();
  drawing::Drawing drawing = draw_or_reason(now, deck_);
  for (drawing::Pane& pane : drawing.panes) {
    for (drawing::Dimension& d : pane.dimensions)
      d.label = displayLabel(d.label, d.variable, d.instance, d.index);
    for (drawing::Arrow& a : pane.arrows) a.label = displayLabel(a.label, a.variable, 1, 1);
  }
  if (drawing.reason.empty()) {
    last_valid_drawings_[now] = drawing;
    drawing_view_->setDrawing(std::move(drawing));
    return;
  }
  const QString reason = QString::fromStdString(drawing.reason);
  const auto last = last_valid_drawings_.find(now);
  drawing_view_->setDrawing(last == last_valid_drawings_.end() ? std::move(drawing) : last->second,
                            reason);
}

void DrawingPanel::label() {
  const DrawingFocus& focus = drawing_view_->currentFocus();
  drawing_view_->setFocusLabel(
      focus.variable.empty()
          ? QString()
          : QString::fromStdString(
                displayLabel(drawing::label_of(deck_, focus.variable, focus.instance, focus.index),
                             focus.variable, focus.instance, focus.index)));
}

std::string DrawingPanel::displayLabel(const std::string& label, const std::string& variable,
                                       int instance, int index) const {
  const QString own = wording ? wording(variable, instance, index) : QString();
  return own.isEmpty() ? label : own.toStdString();
}

void DrawingPanel::setFocusOn(DrawingFocus focus) {
  if (focus == drawing_view_->currentFocus()) return;
  const drawing::View wanted = drawing::view_of_variable(focus.record, focus.variable);
  drawing_view_->setFocusOn(std::move(focus));
  label();
  if (wanted == preferred_view_) return;  // a view chosen by hand stays
  preferred_view_ = wanted;
  chosen_view_.reset();
  drawNow();
}

void DrawingPanel::chooseView(drawing::View view) {
  chosen_view_ = view;
  drawNow();
}

}  // namespace adore::adrinput
