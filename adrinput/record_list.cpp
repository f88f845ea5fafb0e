#include "adrinput/record_list.hpp"

#include "adrinput/design_page.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/qt_text.hpp"
#include "adrinput/search.hpp"
#include "desktop/theme.hpp"
#include "runs/unused_request.hpp"

#include <QIcon>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPixmap>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <map>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kRecordRole = Qt::UserRole, kVariableRole = Qt::UserRole + 1;

/// Draws a sign and all lines of a text: the style would shorten the last line of some texts with
/// dots although there is space.
class WrappedText : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& given,
                               const QModelIndex& index) const override {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const auto* list = qobject_cast<const QListView*>(option.widget);
    const int width =
        list != nullptr ? list->viewport()->width() - 2 * list->spacing() : option.rect.width();
    const QRect words = option.fontMetrics.boundingRect(
        text_place(QRect(0, 0, width, kTall), option), Qt::TextWordWrap, option.text);
    return {width, std::max(words.height(), kSign) + 2 * kMargin};
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& given,
             const QModelIndex& index) const override {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QStyle* style = option.widget->style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const QRect place = option.rect.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    if (!option.icon.isNull())
      option.icon.paint(painter, QRect(place.left(), place.center().y() - kSign / 2, kSign, kSign),
                        Qt::AlignCenter, chosen ? QIcon::Selected : QIcon::Normal);
    painter->save();
    painter->setFont(option.font);
    painter->setPen(option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text));
    painter->drawText(text_place(option.rect, option),
                      Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignVCenter, option.text);
    painter->restore();
  }

 private:
  static constexpr int kMargin = 4, kSign = 16, kTall = 10'000;
  static QRect text_place(const QRect& row, const QStyleOptionViewItem& option) {
    const int left = option.icon.isNull() ? kMargin : 3 * kMargin + kSign;
    return row.adjusted(left, 0, -kMargin, 0);
  }
};

QListWidget* make_list(const QString& name, QWidget* parent) {
  auto* list = new QListWidget(parent);
  list->setObjectName(name);
  list->setWordWrap(true);
  list->setItemDelegate(new WrappedText(list));
  list->setFrameShape(QFrame::NoFrame);
  list->setResizeMode(QListView::Adjust);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list->setSpacing(1);
  return list;
}

/// Distinguished by shape, for color-blind users.
QPixmap state_sign(RecordState state, const QColor& colour) {
  QPixmap pixmap(32, 32);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  switch (state) {
    case RecordState::Complete:
      painter.drawPolyline(QPolygonF({{3.5, 8.5}, {6.5, 11.5}, {12.5, 4.5}}));
      break;
    case RecordState::Untouched:
      painter.drawEllipse(QPointF(8, 8), 4, 4);
      break;
    case RecordState::Doubtful:
      painter.drawPolygon(QPolygonF({{8, 2.5}, {14, 13}, {2, 13}}));
      break;
    case RecordState::Wrong:
      painter.drawLine(QPointF(4, 4), QPointF(12, 12));
      painter.drawLine(QPointF(12, 4), QPointF(4, 12));
      break;
  }
  return pixmap;
}

/// Adds possible line breaks to words that are wider than a narrow list: after commas and slashes,
/// between the parts of a name, and within long numbers.
QString breakable(const QString& text) {
  static const QRegularExpression longer("\\S{13,}");
  static const QRegularExpression places("([,/(\\[_])(?=\\S)|([a-z])(?=[A-Z])|(\\d{9})(?=\\d)");
  QString out;
  qsizetype from = 0;
  for (auto words = longer.globalMatch(text); words.hasNext();) {
    const QRegularExpressionMatch word = words.next();
    out += text.mid(from, word.capturedStart() - from);
    out += word.captured().replace(places, "\\1\\2\\3\u200b");
    from = word.capturedEnd();
  }
  return out + text.mid(from);
}

}  // namespace

QString state_text(RecordState state) {
  switch (state) {
    case RecordState::Complete:
      return "complete";
    case RecordState::Untouched:
      return "has default values";
    case RecordState::Doubtful:
      return "has a warning";
    case RecordState::Wrong:
      return "has an error";
  }
  return {};
}

QIcon state_icon(RecordState state) {
  const desktop::Theme& theme = desktop::current_theme();
  static std::map<std::pair<desktop::ThemeKind, RecordState>, QIcon> drawn;
  const auto known = drawn.find({theme.kind, state});
  if (known != drawn.end()) return known->second;
  const std::map<RecordState, QColor> colours = {{RecordState::Complete, theme.green},
                                                 {RecordState::Untouched, theme.muted},
                                                 {RecordState::Doubtful, theme.curves[1]},
                                                 {RecordState::Wrong, theme.red}};
  QIcon icon;
  icon.addPixmap(state_sign(state, colours.at(state)), QIcon::Normal);
  icon.addPixmap(state_sign(state, Qt::white), QIcon::Selected);
  return drawn.emplace(std::pair(theme.kind, state), icon).first->second;
}

RecordList::RecordList(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      query_(new QLineEdit(this)),
      stack_(new QStackedWidget(this)),
      records_(make_list("records", this)),
      search_results_(make_list("found", this)),
      state_(new QToolButton(this)),
      design_(new QToolButton(this)) {
  query_->setObjectName("search");
  query_->setPlaceholderText(tr("Find a variable (Ctrl+F)"));
  query_->setAccessibleName(tr("Find a variable"));
  query_->setClearButtonEnabled(true);
  query_->installEventFilter(this);
  search_results_->installEventFilter(this);
  records_->setAccessibleName(tr("Records"));
  search_results_->setAccessibleName(tr("Variables found"));
  stack_->addWidget(records_);
  stack_->addWidget(search_results_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 8, 0, 0);
  layout->addWidget(design_);
  layout->addWidget(query_);
  layout->addWidget(state_);
  design_->setObjectName("design");
  design_->setText(tr("Design page"));
  design_->setToolTip(tr("Inputs and results of this bearing (Ctrl+B)"));
  design_->setCheckable(true);
  design_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(design_, &QToolButton::clicked, this, &RecordList::designChosen);
  layout->addWidget(stack_, 1);
  state_->setObjectName("deck-state");
  state_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  state_->setAutoRaise(true);
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(state_, &QToolButton::clicked, this, &RecordList::stateClicked);
  connect(query_, &QLineEdit::textChanged, this, &RecordList::search);
  for (QToolButton* cross : query_->findChildren<QToolButton*>())  // at its end
    connect(cross, &QToolButton::clicked, this, [this] { records_->setFocus(); });
  connect(records_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr) emit recordChosen(item->data(kRecordRole).toString());
  });
  connect(search_results_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { chooseSearchResult(search_results_->row(item)); });
  sync();
}

/// State of the deck: can a run start?
void RecordList::syncState() {
  const auto errors = static_cast<int>(
      std::count_if(document_.problems().begin(), document_.problems().end(),
                    [](const Problem& p) { return p.issue.severity == Severity::Error; }));
  RecordState sign = RecordState::Complete;
  QString text = tr("Ready to run"), more = tr("A run of this deck can start.");
  switch (document_.deck_state()) {
    case DeckState::Wrong:
      sign = RecordState::Wrong;
      text = errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors);
      more = tr("The deck has errors. Click for the first one (F8).");
      break;
    case DeckState::Refused:
      sign = RecordState::Doubtful;
      text = tr("Run refused");
      more = tr("A run of this deck cannot start. Click for the reason.");
      break;
    case DeckState::Unchecked:
      sign = RecordState::Untouched;
      text = tr("Checking …");
      more = tr("Checking that the run can start");
      break;
    case DeckState::Ready:
      if (const std::string none = runs::why_no_step(document_.deck()); !none.empty()) {
        sign = RecordState::Doubtful;
        text = tr("Ready: no motion");
        more = tr("A run computes only the quasi-static solution because %1.")
                   .arg(QString::fromStdString(none));
      } else if (document_.deck().integer("mode") < 0) {
        text = tr("Ready: quasi-static");
        more = tr("A run computes only the quasi-static solution because mode is %1.")
                   .arg(document_.deck().integer("mode"));
      }
      if (const int warnings = document_.warnings(); warnings > 0) {
        sign = RecordState::Doubtful;
        text += warnings == 1 ? tr(", 1 warning") : tr(", %1 warnings").arg(warnings);
        more += tr(" Click for the first warning.");
      }
      break;
  }
  state_->setIcon(state_icon(sign));
  state_->setText(text);
  state_->setToolTip(more);
  state_->setAccessibleName(tr("Deck state: %1").arg(text));
}

void RecordList::sync() {
  syncState();
  const QSignalBlocker quiet(records_);
  const std::vector<std::string> pages = document_.pages();
  while (records_->count() > static_cast<int>(pages.size()))
    delete records_->takeItem(records_->count() - 1);
  for (int i = 0; i < static_cast<int>(pages.size()); ++i) {
    const std::string& id = pages[static_cast<std::size_t>(i)];
    if (records_->count() <= i) records_->addItem(new QListWidgetItem);
    QListWidgetItem* item = records_->item(i);
    const deck::RecordSpec& spec = *page_record(id);
    const RecordState state = document_.state_of(id);
    item->setText(QString("%1  %2").arg(record_number(spec), text_of(spec.title)));
    item->setIcon(state_icon(state));
    item->setToolTip(state_text(state));
    item->setData(Qt::AccessibleTextRole, item->text() + ", " + state_text(state));
    item->setData(kRecordRole, QString::fromStdString(id));
  }
  updateSearchResults();
}

void RecordList::setCurrentRecord(const std::string& record) {
  const QSignalBlocker quiet(records_);
  design_->setChecked(record == kDesignPage);
  if (record == kDesignPage) {  // a click on any record leaves the page
    records_->setCurrentRow(-1);
    return records_->clearSelection();
  }
  for (int i = 0; i < records_->count(); ++i)
    if (records_->item(i)->data(kRecordRole).toString().toStdString() == record) {
      records_->setCurrentRow(i);
      records_->scrollToItem(records_->item(i));
    }
}

void RecordList::focusRecords() { records_->setFocus(); }

void RecordList::startSearch() {
  query_->setFocus(Qt::ShortcutFocusReason);
  query_->selectAll();
}

void RecordList::search(const QString& query) {
  search_results_->clear();
  stack_->setCurrentWidget(query.trimmed().isEmpty() ? records_ : search_results_);
  if (query.trimmed().isEmpty()) return;
  for (const VariableMatch& found : search_variables(query.toStdString(), [this](const Cell& cell) {
         return document_.instances(cell.record) > 0;
       })) {
    auto* item = new QListWidgetItem(search_results_);
    item->setData(kRecordRole, QString::fromStdString(found.cell.record));
    item->setData(kVariableRole, static_cast<int>(found.cell.variable));
  }
  updateSearchResults();
  if (search_results_->count() == 0) {
    auto* item = new QListWidgetItem(tr("No variable found."), search_results_);
    item->setFlags(Qt::NoItemFlags);
  } else {
    search_results_->setCurrentRow(0);
  }
}

/// Search results, pale if the deck does not have them now.
void RecordList::updateSearchResults() {
  for (int row = 0; row < search_results_->count(); ++row) {
    QListWidgetItem* item = search_results_->item(row);
    Cell cell;
    cell.record = item->data(kRecordRole).toString().toStdString();
    if (cell.record.empty()) continue;
    cell.variable = static_cast<std::size_t>(item->data(kVariableRole).toInt());
    const deck::RecordSpec& record = *page_record(cell.record);
    const deck::VariableSpec& variable = *variable_of(cell);
    const bool here = document_.instances(cell.record) > 0;
    QString text = QString("%1 · record %2\n%3")
                       .arg(text_of(variable.name), record_number(record), text_of(variable.help));
    if (!here) text += tr("\nNot in this deck (requires %1)").arg(text_of(record.condition));
    text = breakable(text);
    if (item->text() != text) item->setText(text);
    item->setForeground(here ? QBrush() : QBrush(desktop::current_theme().muted));
  }
}

void RecordList::chooseSearchResult(int row) {
  const QListWidgetItem* item = search_results_->item(row);
  if (item == nullptr || !item->data(kRecordRole).isValid()) return;
  emit variableChosen(item->data(kRecordRole).toString(), item->data(kVariableRole).toInt());
}

bool RecordList::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && object == query_ && query_->text().isEmpty()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();  // an empty search has no text to undo: the shortcut is for the deck
      return true;
    }
  }
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) {
      query_->clear();
      records_->setFocus();
      return true;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      if (stack_->currentWidget() == search_results_)
        chooseSearchResult(std::max(search_results_->currentRow(), 0));
      return true;
    }
    if (object == query_ && (key == Qt::Key_Down || key == Qt::Key_Up) &&
        stack_->currentWidget() == search_results_) {
      const int row = search_results_->currentRow() + (key == Qt::Key_Down ? 1 : -1);
      search_results_->setCurrentRow(std::clamp(row, 0, search_results_->count() - 1));
      return true;
    }
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace adore::adrinput
