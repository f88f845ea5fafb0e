#include "adrinput/notice_bar.hpp"

#include "desktop/theme.hpp"

#include <QBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace adore::adrinput {

NoticeBar::NoticeBar(const QString& name, QWidget* parent)
    : QWidget(parent), buttons_(new QHBoxLayout), label_(new QLabel(this)) {
  setObjectName(name);
  label_->setObjectName("notice-text");
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(20, 8, 20, 8);
  row->addWidget(label_, 1);
  row->addLayout(buttons_);
  hide();
}

/// Painted by hand: a style sheet here would fix the colors of the buttons.
void NoticeBar::paintEvent(QPaintEvent* /*event*/) {
  const desktop::Theme& theme = desktop::current_theme();
  QPainter painter(this);
  painter.fillRect(rect(), theme.raised);
  painter.fillRect(0, height() - 2, width(), 2, theme.accent);
}

QString NoticeBar::text() const { return label_->text(); }

void NoticeBar::ask(const QString& text, std::vector<Answer> answers) {
  label_->setText(text);
  setAccessibleName(text);
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    item->widget()->hide();  // its letter is free at once
    item->widget()->deleteLater();
    delete item;
  }
  for (Answer& answer : answers) {
    auto* button = new QPushButton(answer.text, this);
    button->setObjectName(answer.name);
    button->setAutoDefault(true);
    connect(button, &QPushButton::clicked, this, [this, act = std::move(answer.act)] {
      const auto after = act;  // the button is deleted with its functions by the next question
      hide();
      if (after) after();
    });
    buttons_->addWidget(button);
  }
  show();
}

}  // namespace adore::adrinput
