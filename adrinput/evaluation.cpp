#include "adrinput/evaluation.hpp"

#include "desktop/theme.hpp"
#include "facade/prepare.hpp"
#include "results/print_file.hpp"
#include "results/print_life.hpp"

#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QThread>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <memory>

namespace adore::adrinput {
namespace {

facade::Prepared prepared(const deck::Deck& deck, const std::filesystem::path& path) {
  facade::LoadedDeck input;
  input.path = path.empty() ? std::filesystem::path("new deck") : path;
  input.deck = deck;
  if (!path.empty()) input.option_values = facade::options_beside(path);
  return facade::prepare(std::move(input));
}

}  // namespace

std::string plan_of(const deck::Deck& deck, const std::filesystem::path& path) {
  const facade::Prepared ready = prepared(deck, path);
  return facade::plan_text(ready, facade::plan_with_estimates(ready));
}

std::string quasi_static_of(const deck::Deck& deck, const std::filesystem::path& path) {
  deck::Deck still = deck;
  still.set("mode", "-1");  // the equilibrium only, whatever the deck would run
  still.complete();
  const facade::Prepared ready = prepared(still, path);
  results::Report report(ready.bearing.run_id, deck.units());
  if (ready.rollers)
    results::print_quasi_static(report, *ready.rollers, ready.bearing);
  else
    results::print_quasi_static(report, ready.statics, ready.bearing);
  results::print_life(report, ready.life);
  std::string text = report.take();
  std::replace(text.begin(), text.end(), '\f', '\n');
  return text;
}

EvaluationPanel::EvaluationPanel(Function function, const QString& invitation, QWidget* parent)
    : QWidget(parent),
      function_(function),
      note_(new QLabel(invitation, this)),
      view_(new QPlainTextEdit(this)) {
  note_->setWordWrap(true);
  note_->setObjectName("note");
  view_->setObjectName("text");
  view_->setReadOnly(true);
  view_->setLineWrapMode(QPlainTextEdit::NoWrap);
  view_->setTabChangesFocus(true);
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setFamily("DejaVu Sans Mono");
  font.setStyleHint(QFont::Monospace);
  font.setPixelSize(12);
  view_->setFont(font);
  view_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->addWidget(note_);
  layout->addWidget(view_, 1);
  layout->setAlignment(note_, Qt::AlignTop);
}

EvaluationPanel::~EvaluationPanel() {
  if (thread_ != nullptr) thread_->wait();
}

QString EvaluationPanel::text() const { return view_->toPlainText(); }

void EvaluationPanel::show(const QString& text) {
  view_->setPlainText(text);
  view_->show();
}

void EvaluationPanel::start(const deck::Deck& deck, const std::filesystem::path& path) {
  if (busy()) return;
  evaluated_ = deck;
  stale_ = false;
  note_->setText(tr("Computing …"));
  note_->show();
  struct Outcome {
    std::string text;
    bool failed = false;
  };
  auto outcome = std::make_shared<Outcome>();
  thread_ = QThread::create([function = function_, deck, path, outcome] {
    try {
      outcome->text = function(deck, path);
    } catch (const std::exception& error) {
      outcome->text = error.what();
      outcome->failed = true;
    }
  });
  thread_->setParent(this);
  connect(thread_, &QThread::finished, this, [this, outcome] {
    thread_->deleteLater();
    thread_ = nullptr;
    note_->setText(outcome->failed ? tr("There is no result, for this reason:")
                   : stale_        ? tr("Of the deck as it was before the last change.")
                                   : QString());
    note_->setVisible(!note_->text().isEmpty());
    show(QString::fromStdString(outcome->text));
    emit finished();
  });
  thread_->start();
}

void EvaluationPanel::setDeck(const deck::Deck& deck) {
  if (busy()) {
    stale_ = !(deck == evaluated_);
    return;
  }
  if (!view_->isVisibleTo(this) || evaluated_.records.empty()) return;
  const bool stale = !(deck == evaluated_);
  if (stale == stale_) return;
  stale_ = stale;
  note_->setText(stale ? tr("Of the deck as it was before the last change.") : QString());
  note_->setVisible(stale);
}

}  // namespace adore::adrinput
