#include "desktop/findings_bar.hpp"

#include "desktop/theme.hpp"

#include <QListWidget>
#include <QPainter>
#include <QResizeEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace adore::desktop {
namespace {

// Of a picture [pixels]: height of a line, and of the picture for each line; number of lines.
constexpr int kLine = 18, kHeightOfLine = 100, kMostLines = 4;
constexpr int kMostRows = 10, kHighest = 420;  // of the list without scrolling
constexpr int kLeastWide = 360;

const QColor& colour_of(Severity severity, const Theme& theme) {
  return severity == Severity::Note ? theme.muted : theme.red;
}

QString word(Severity severity) {
  return severity == Severity::Error     ? FindingsBar::tr("Error")
         : severity == Severity::Warning ? FindingsBar::tr("Warning")
                                         : FindingsBar::tr("Note");
}

}  // namespace

QString finding_text(const Finding& finding) {
  QStringList place;
  if (!finding.record.empty())
    place << FindingsBar::tr("record %1").arg(QString::fromStdString(finding.record));
  if (!finding.variable.empty()) place << QString::fromStdString(finding.variable);
  if (!finding.body.empty()) place << QString::fromStdString(finding.body);
  if (finding.time) place << FindingsBar::tr("t = %1 s").arg(*finding.time, 0, 'g', 6);
  QString text = word(finding.severity);
  if (!place.isEmpty()) text += " (" + place.join(", ") + ")";
  text += ": " + QString::fromStdString(finding.message);
  if (!finding.remedy.empty()) text += "; " + QString::fromStdString(finding.remedy);
  return text;
}

FindingsBar::FindingsBar(QWidget* parent)
    : QWidget(parent),
      button_(new QToolButton(this)),
      popup_(new QWidget(this, Qt::Popup)),
      list_(new QListWidget(popup_)) {
  setObjectName("findings");
  button_->setObjectName("findings-line");
  button_->setAutoRaise(true);
  button_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  button_->setFocusPolicy(Qt::TabFocus);
  connect(button_, &QToolButton::clicked, this, &FindingsBar::openList);
  auto* row = new QVBoxLayout(this);
  row->setContentsMargins(4, 0, 4, 0);
  row->addWidget(button_);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  list_->setObjectName("findings-list");
  list_->setAccessibleName(tr("Findings"));
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setResizeMode(QListView::Adjust);
  auto* column = new QVBoxLayout(popup_);
  column->setContentsMargins(1, 1, 1, 1);
  column->addWidget(list_);
  // A click and Enter both activate; the style may ask for a double click.
  connect(list_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { show(list_->row(item)); });
  connect(list_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { show(list_->row(item)); });
  hide();
}

void FindingsBar::setFindings(std::vector<Finding> findings) {
  findings_ = std::move(findings);
  fill();
}

void FindingsBar::setCurrentPage(std::function<bool(const Finding&)> concerns,
                                 const QString& name) {
  concerns_current_page_ = std::move(concerns);
  page_name_ = name;
  fill();
}

void FindingsBar::fill() {
  const auto here = [this](const Finding& one) {
    return concerns_current_page_ && concerns_current_page_(one);
  };
  std::stable_sort(findings_.begin(), findings_.end(), [&](const Finding& a, const Finding& b) {
    const auto rank = [&](const Finding& one) {
      const bool warns = one.severity > Severity::Note;
      return std::tuple(here(one) && warns, one.severity, here(one));
    };
    return rank(a) > rank(b);
  });
  list_->clear();
  const Theme& theme = current_theme();
  for (const Finding& one : findings_) {
    auto* item = new QListWidgetItem(finding_text(one), list_);
    item->setForeground(one.severity == Severity::Note ? theme.text : theme.red);
    item->setToolTip(QString::fromStdString(one.code).toHtmlEscaped());
    QFont font = item->font();
    font.setBold(here(one));
    item->setFont(font);
  }
  const std::string all = findings_line(findings_);
  line_ = QString::fromStdString(all);
  if (!findings_.empty() && here(findings_.front()) && findings_.front().severity > Severity::Note)
    line_ = QString::fromStdString(all.substr(0, all.find(". Worst: "))) + ". " + page_name_ +
            ": " + QString::fromStdString(findings_.front().message);
  elideLine();
  setVisible(!findings_.empty());
}

void FindingsBar::elideLine() {
  const Theme& theme = current_theme();
  const Finding* const worst = worst_finding(findings_);
  QPalette colours = button_->palette();
  colours.setColor(QPalette::ButtonText,
                   worst == nullptr ? theme.muted : colour_of(worst->severity, theme));
  button_->setPalette(colours);
  const QString whole = tr("Findings: %1").arg(line_);
  QString text =
      button_->fontMetrics().elidedText(whole, Qt::ElideRight, std::max(button_->width() - 16, 60));
  button_->setText(text.replace("&", "&&"));
  button_->setAccessibleName(whole);
  button_->setToolTip(tr("Show all findings"));
}

void FindingsBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  elideLine();
}

void FindingsBar::openList() {
  popup_->setFixedWidth(std::max(width(), kLeastWide));
  list_->setFixedWidth(popup_->width() - 2);
  // Row heights of the view belong to its last width until it is shown.
  constexpr int kBeside = 30;  // scroll bar, frame, margins [pixels]
  int height = 2 * list_->frameWidth() + 8;
  for (int row = 0; row < std::min(list_->count(), kMostRows); ++row) {
    const QFontMetrics metrics(list_->item(row)->font());
    height += 6 + metrics
                      .boundingRect(0, 0, popup_->width() - kBeside, 1 << 14, Qt::TextWordWrap,
                                    list_->item(row)->text())
                      .height();
  }
  list_->setFixedHeight(std::min(height, kHighest));
  popup_->adjustSize();
  // Above the line if there is no space below.
  const QPoint below = mapToGlobal(QPoint(0, this->height()));
  const bool up = below.y() + popup_->height() > window()->frameGeometry().bottom();
  popup_->move(up ? mapToGlobal(QPoint(0, 0)) - QPoint(0, popup_->height()) : below);
  popup_->show();
  list_->setCurrentRow(0);
  list_->setFocus();
}

void FindingsBar::show(int row) {
  if (row < 0 || row >= static_cast<int>(findings_.size())) return;
  popup_->hide();
  const Finding finding = findings_[static_cast<std::size_t>(row)];
  emit chosen(finding);
}

QIcon warning_icon() {
  constexpr int kSize = 16;
  QPixmap picture(kSize, kSize);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(current_theme().red);
  painter.drawPolygon(QPolygonF{{8, 2}, {15, 14}, {1, 14}});
  painter.setPen(QPen(current_theme().surface, 1.6));
  painter.drawLine(QPointF(8, 6.5), QPointF(8, 10));
  painter.drawPoint(QPointF(8, 12.3));
  return QIcon(picture);
}

int parse_element_number(const std::string& body) {
  for (const char* word : {"ball ", "roller ", "element ", "balls ", "rollers ", "elements "}) {
    const std::size_t at = body.find(word);
    if (at == std::string::npos) continue;
    int number = 0;
    for (std::size_t i = at + std::string_view(word).size();
         i < body.size() && body[i] >= '0' && body[i] <= '9' && number < 100000; ++i)
      number = 10 * number + (body[i] - '0');
    if (number > 0) return number;
  }
  return 0;
}

QImage image_with_findings(QSize size, const std::vector<Finding>& findings, bool dark,
                           const std::function<QImage(QSize)>& draw,
                           const std::function<bool(const Finding&)>& concerns) {
  std::vector<Finding> shown;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(shown),
               [](const Finding& one) { return one.severity > Severity::Note; });
  if (shown.empty()) return draw(size);
  std::stable_sort(shown.begin(), shown.end(), [&](const Finding& a, const Finding& b) {
    const bool here = concerns && concerns(a), there = concerns && concerns(b);
    return here != there ? here : a.severity > b.severity;
  });
  const auto warnings = static_cast<int>(shown.size());
  const int room = std::clamp(size.height() / kHeightOfLine, 1, kMostLines);
  QStringList lines;
  for (int k = 0; k < std::min(warnings, room); ++k)
    lines << finding_text(shown[static_cast<std::size_t>(k)]);
  if (warnings > room)
    lines.back() =
        FindingsBar::tr("Findings: %1").arg(QString::fromStdString(findings_line(findings)));
  const int height = kLine * static_cast<int>(lines.size());
  const QImage picture = draw({size.width(), size.height() - height});
  const Theme& colours = theme(dark ? ThemeKind::Dark : ThemeKind::Light);
  QImage out(size, QImage::Format_RGB32);
  out.fill(colours.surface);
  QPainter painter(&out);
  painter.drawImage(0, 0, picture);
  painter.setFont(ui_font(12));
  painter.setPen(colour_of(Severity::Warning, colours));
  QRect line(16, size.height() - height, size.width() - 32, kLine);
  for (const QString& text : lines) {
    painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, line.width()));
    line.translate(0, kLine);
  }
  return out;
}

}  // namespace adore::desktop
