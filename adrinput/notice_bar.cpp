#include "adrinput/notice_bar.hpp"

#include "desktop/theme.hpp"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QPushButton>

namespace adore::adrinput {

NoticeBar::NoticeBar(const QString& name, QWidget* parent)
    : QFrame(parent), buttons_(new QHBoxLayout), label_(new QLabel(this)) {
  setObjectName(name);
  label_->setObjectName("notice-text");
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(20, 8, 20, 8);
  row->addWidget(label_, 1);
  row->addLayout(buttons_);
  paintFrame();
  hide();
}

void NoticeBar::paintFrame() {
  const desktop::Theme& theme = desktop::current_theme();
  const QString sheet = QString("#%1 { background: %2; border-bottom: 1px solid %3; }")
                            .arg(objectName(), theme.raised.name(), theme.accent.name());
  if (styleSheet() != sheet) setStyleSheet(sheet);
}

void NoticeBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) paintFrame();
  QFrame::changeEvent(event);
}

QString NoticeBar::text() const { return label_->text(); }

void NoticeBar::ask(const QString& text, std::vector<Answer> answers) {
  label_->setText(text);
  setAccessibleName(text);
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (Answer& answer : answers) {
    auto* button = new QPushButton(answer.text, this);
    button->setObjectName(answer.name);
    button->setAutoDefault(true);
    connect(button, &QPushButton::clicked, this, [this, act = std::move(answer.act)] {
      const auto after = act;  // the button goes with its functions when the next question comes
      hide();
      if (after) after();
    });
    buttons_->addWidget(button);
  }
  show();
}

}  // namespace adore::adrinput
