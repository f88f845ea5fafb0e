#include "adrinput/design_page.hpp"

#include "adrinput/design_card.hpp"
#include "adrinput/design_form.hpp"
#include "adrinput/design_solver.hpp"
#include "adrinput/drawing_view.hpp"
#include "adrinput/moving_dialog.hpp"
#include "adrinput/window_words.hpp"
#include "design/moving_deck.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/static_pages.hpp"

#include <QBoxLayout>
#include <QGuiApplication>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>

#include <algorithm>
#include <exception>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kPictureWidth = 200;  // at least
constexpr int kBar = 16;            // of a scroll bar

/// Scrolls up and down in a low window; never sideways.
QScrollArea* scrolled(QWidget* widget, const QString& name) {
  class Area : public QScrollArea {
   public:
    [[nodiscard]] QSize minimumSizeHint() const override {
      return {widget()->minimumSizeHint().width() + kBar, 120};
    }
  };
  auto* area = new Area;
  area->setAccessibleName(name);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(widget);
  return area;
}

/// Short titles and no note: the pane is narrow.
desktop::ChartPage narrow_page(desktop::ChartPage page) {
  if (!page.equal_axes) return page;
  page.note.clear();
  page.x_title = page.x_title.substr(0, page.x_title.find(' '));
  for (desktop::ChartPanel& panel : page.panels)
    panel.title = panel.title.substr(0, panel.title.find(' '));
  return page;
}

/// The drawing of an incomplete deck, or the reason why there is none.
drawing::Drawing section_of(const deck::Deck& deck) {
  try {
    return drawing::draw(drawing::View::CrossSection, deck);
  } catch (const std::exception& error) {
    drawing::Drawing none;
    none.reason = error.what();
    return none;
  }
}

}  // namespace

DesignPage::DesignPage(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      form_(new DesignForm(document)),
      results_panel_(new DesignResultsPanel),
      drawing_(new DrawingView(this)),
      load_chart_(new desktop::ChartView(this)),
      solver_(new DesignSolver(this)) {
  setObjectName("design-page");
  auto* move = new QPushButton(tr("&Make it move …"), this);
  move->setObjectName("design-move");
  move->setToolTip(
      tr("Complete the deck for a simulation of motion. The assumptions are shown "
         "before the deck changes."));
  move->setAutoDefault(true);
  auto* records = new QPushButton(tr("Al&l records"), this);
  records->setObjectName("design-records");
  records->setToolTip(tr("Show all values of this deck in the record forms"));
  records->setAutoDefault(true);
  connect(move, &QPushButton::clicked, this, &DesignPage::convertToDynamicDeck);
  connect(records, &QPushButton::clicked, this, &DesignPage::recordsRequested);
  connect(form_, &DesignForm::catalogRequested, this, &DesignPage::catalogRequested);
  connect(results_panel_, &DesignResultsPanel::findingChosen, this, &DesignPage::findingChosen);
  solver_->found = [this](std::optional<design::DesignSummary> summary, const QString& failure) {
    results_panel_->setSummary(std::move(summary), failure);
    showFindings();
    if (!failure.isEmpty() || !results_panel_->summary()) return;
    const auto pages = desktop::static_pages(results_panel_->summary()->tables);
    if (pages.empty()) return;
    load_chart_->showPage(narrow_page(pages.front()));
    load_chart_->setToolTip(QString::fromStdString(pages.front().note));
  };
  drawing_->setObjectName("design-drawing");
  drawing_->setMinimumHeight(160);
  load_chart_->setObjectName("design-loads");
  load_chart_->setAccessibleName(tr("Load distribution"));
  load_chart_->setMinimumSize(kPictureWidth, 300);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(12, 0, 8, 8);
  buttons->addWidget(move);
  buttons->addWidget(records);
  auto* inputs = new QWidget(this);
  auto* column = new QVBoxLayout(inputs);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scrolled(form_, tr("Inputs")), 1);
  column->addLayout(buttons);
  auto* pictures = new QSplitter(Qt::Vertical, this);
  pictures->addWidget(drawing_);
  pictures->addWidget(load_chart_);
  pictures->setStretchFactor(0, 1);
  pictures->setStretchFactor(1, 1);
  pictures->setChildrenCollapsible(false);
  auto* parts = new QSplitter;
  parts->addWidget(inputs);
  QScrollArea* results = scrolled(results_panel_, tr("Results"));
  parts->addWidget(results);
  connect(results_panel_, &DesignResultsPanel::rowsBuilt, results, [results, parts] {
    results->updateGeometry();
    const int least = results->minimumSizeHint().width();
    QList<int> sizes = parts->sizes();
    const int more = std::max(least - sizes[1], 0);
    sizes[1] += more;
    sizes[2] -= more;
    parts->setSizes(sizes);
  });
  parts->addWidget(pictures);
  parts->setStretchFactor(1, 1);
  parts->setStretchFactor(2, 1);
  parts->setChildrenCollapsible(false);
  auto* whole = new QScrollArea(this);  // scrolls in a window that is smaller than the page
  whole->setObjectName("design-area");
  whole->setWidgetResizable(true);
  whole->setFrameShape(QFrame::NoFrame);
  whole->setFocusPolicy(Qt::NoFocus);
  whole->setWidget(parts);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(whole);
}

DesignPage::~DesignPage() { solver_->found = nullptr; }

bool DesignPage::computing() const { return solver_->pending(); }

void DesignPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  sync();
}

void DesignPage::sync() {
  if (!isVisible()) return;  // the next showEvent() does it
  form_->sync();
  compute();
  showFindings();
  draw();
}

void DesignPage::compute() {
  if (document_.has_errors()) {
    solver_->cancel();
    results_panel_->setSummary(std::nullopt,
                               tr("The deck has errors. Correct them to see results."));
    return;
  }
  solver_->ask({document_.deck(), document_.options()});
  results_panel_->setStale(solver_->pending());
}

void DesignPage::draw() {
  if (drawn_deck_ == document_.deck()) return;
  drawn_deck_ = document_.deck();
  drawing_->setDrawing(section_of(drawn_deck_));
}

/// Problems of the deck, and findings of the solution that are not among them.
void DesignPage::showFindings() {
  std::vector<Finding> all;
  for (const Problem& problem : document_.problems()) all.emplace_back(problem.issue);
  if (results_panel_->summary() && !document_.has_errors())
    for (const Finding& one : results_panel_->summary()->findings)
      if (std::none_of(all.begin(), all.end(),
                       [&](const Finding& other) { return other.message == one.message; }))
        all.push_back(one);
  results_panel_->setFindings(std::move(all));
}

void DesignPage::convertToDynamicDeck() {
  form_->commitFields();
  document_.end_undo_step();
  if (document_.has_errors())
    return desktop::show_message(window(), tr("The deck has errors. Correct them first (F8)."),
                                 true);
  design::DynamicDeckProposal moving;
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  QString failure;
  try {
    moving = design::propose_dynamic_deck(document_.deck(), document_.options());
  } catch (const std::exception& error) {
    failure = QString::fromStdString(replace_cli_terms(error.what()));
  }
  QGuiApplication::restoreOverrideCursor();
  if (!failure.isEmpty()) return desktop::show_message(window(), failure, true);
  auto* dialog = new MotionAssumptionsDialog(moving.assumptions, window());
  connect(dialog, &MotionAssumptionsDialog::assumptionsAccepted, this,
          [this, sets = moving.sets](bool run) {
            try {
              document_.change(sets);
              emit convertedToDynamicDeck(run);
            } catch (const std::exception& error) {
              desktop::show_message(window(), QString::fromUtf8(error.what()), true);
            }
          });
  dialog->open();
}

void DesignPage::restyle() {
  results_panel_->restyle();
  load_chart_->chartScene().setTheme(desktop::current_theme());
  drawing_->update();
  form_->sync();
}

}  // namespace adore::adrinput
