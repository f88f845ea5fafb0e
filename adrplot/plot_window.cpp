#include "adrplot/plot_window.hpp"

#include "adrplot/range_dialog.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <array>
#include <exception>

namespace adore::adrplot {
namespace {

const QString kApp = "adrplot";
constexpr int kPageRole = Qt::UserRole, kFileRole = Qt::UserRole + 1;

struct PairChoice {
  const char* text;
  OrbitPair pair;
};
constexpr std::array<PairChoice, 3> kPairs{
    {{"Z over Y", {1, 2}}, {"Z over X", {0, 2}}, {"Y over X", {0, 1}}}};

}  // namespace

PlotWindow::PlotWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle("AdrPlot");
  setAcceptDrops(true);
  desktop::open_at_size(*this, {1280, 860});

  tree_ = new QTreeWidget(this);
  tree_->setObjectName("pages");
  tree_->setHeaderHidden(true);
  tree_->setMinimumWidth(180);
  tree_->setFrameShape(QFrame::NoFrame);
  note_ = new QLabel(this);
  note_->setObjectName("note");
  note_->setWordWrap(true);
  note_->setMargin(8);
  note_->hide();
  view_ = new desktop::ChartView(this);
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(note_);
  column->addWidget(view_, 1);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(tree_);
  splitter->addWidget(side);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({270, 1010});
  setCentralWidget(splitter);
  makeButtons();

  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!item) return;
    current_ = item->data(0, kFileRole).toInt();
    page_ = item->data(0, kPageRole).toInt();
    showCurrent();
  });
  connect(view_, &desktop::ChartView::readoutChanged, this,
          [this](const QString& text) { statusBar()->showMessage(text); });
  showCurrent();
}

PlotWindow::~PlotWindow() = default;

void PlotWindow::makeButtons() {
  auto* bar = addToolBar(tr("Plots"));
  bar->setObjectName("buttons");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  const auto button = [&](const QString& text, const QList<QKeySequence>& keys, auto slot,
                          const QString& help) {
    auto* action = bar->addAction(text);
    action->setShortcuts(keys);
    action->setToolTip(help + " (" + keys.front().toString(QKeySequence::NativeText) + ")");
    connect(action, &QAction::triggered, this, slot);
  };
  button(tr("Open Plot File"), {QKeySequence::Open}, &PlotWindow::askForFile,
         tr("Choose a file SOL1 to SOL7"));
  button(tr("Prev Plot"), {Qt::Key_PageUp}, &PlotWindow::previousPage, tr("One page back"));
  button(tr("Next Plot"), {Qt::Key_PageDown}, &PlotWindow::nextPage, tr("One page on"));
  button(tr("Plot Number"), {Qt::CTRL | Qt::Key_G}, &PlotWindow::askForPage,
         tr("Go to a page by its number"));
  button(tr("Print"), {QKeySequence::Print}, &PlotWindow::print, tr("Print this page"));
  button(tr("Save JPG"), {QKeySequence::Save}, &PlotWindow::savePicture,
         tr("Save this page as JPEG or PNG"));
  button(tr("Reload"), {Qt::Key_F5}, &PlotWindow::reload,
         tr("Read the file again, for a run that goes on"));
  button(tr("Dark/Light"), {Qt::CTRL | Qt::Key_D}, &PlotWindow::switchTheme,
         tr("Change the colours"));
  button(tr("Quit"), {Qt::CTRL | Qt::Key_Q}, &PlotWindow::close, tr("End AdrPlot"));
  bar->addSeparator();
  makeChoices(bar);
}

void PlotWindow::makeChoices(QToolBar* bar) {
  abscissa_ = new QComboBox(this);
  abscissa_->setObjectName("abscissa");
  abscissa_->addItems({tr("over revolutions"), tr("over time")});
  connect(abscissa_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.abscissa = index == 1 ? Abscissa::Time : Abscissa::Revolutions;
    showCurrent();
  });
  orbit_ = new QComboBox(this);
  orbit_->setObjectName("orbit");
  for (const auto& choice : kPairs) orbit_->addItem(choice.text);
  connect(orbit_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.orbit = kPairs.at(static_cast<std::size_t>(index)).pair;
    showCurrent();
  });
  bar->addWidget(abscissa_);
  orbit_action_ = bar->addWidget(orbit_);
}

PlotWindow::Document* PlotWindow::document() {
  return current_ >= 0 && current_ < fileCount()
             ? documents_[static_cast<std::size_t>(current_)].get()
             : nullptr;
}

int PlotWindow::pageCount() const {
  return current_ >= 0 && current_ < fileCount()
             ? static_cast<int>(documents_[static_cast<std::size_t>(current_)]->pages.size())
             : 0;
}

bool PlotWindow::openFile(const std::filesystem::path& path, const results::SolRange& range) {
  try {
    addDocument(open_document(path, range), range);
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void PlotWindow::addFile(results::SolFile file, const results::SolRange& range) {
  addDocument(make_document(std::move(file)), range);
}

void PlotWindow::addDocument(PlotDocument document, const results::SolRange& range) {
  documents_.push_back(std::make_unique<Document>(Document{std::move(document), range}));
  current_ = fileCount() - 1;
  page_ = 1;
  fillTree();
}

void PlotWindow::fillTree() {
  const int file = current_, page = page_;
  {
    const QSignalBlocker quiet(tree_);
    tree_->clear();
    for (int d = 0; d < fileCount(); ++d) {
      const Document& doc = *documents_[static_cast<std::size_t>(d)];
      const QString name = QString::fromStdString(doc.path.filename().string());
      auto* root = new QTreeWidgetItem(tree_, {name + " — " + QString::fromStdString(doc.subject)});
      root->setToolTip(0, QString::fromStdString(doc.path.string()));
      root->setFlags(Qt::ItemIsEnabled);
      for (std::size_t p = 0; p < doc.pages.size(); ++p) {
        auto* item = new QTreeWidgetItem(
            root, {QString("%1  %2").arg(p + 1).arg(QString::fromStdString(doc.pages[p].title))});
        item->setData(0, kPageRole, static_cast<int>(p + 1));
        item->setData(0, kFileRole, d);
      }
      root->setExpanded(d == file);
    }
  }
  current_ = file;
  showPage(page);
}

void PlotWindow::showPage(int number) {
  if (number < 1 || number > pageCount()) return;
  auto* item = tree_->topLevelItem(current_)->child(number - 1);
  if (tree_->currentItem() == item)
    showCurrent();
  else
    tree_->setCurrentItem(item);
}

void PlotWindow::setAbscissa(Abscissa abscissa) {
  abscissa_->setCurrentIndex(abscissa == Abscissa::Time ? 1 : 0);
}

void PlotWindow::showCurrent() {
  Document* doc = document();
  desktop::ChartPage chart;
  if (doc) {
    chart = doc->build(page_, options_);
    const PageKind kind = doc->pages[static_cast<std::size_t>(page_ - 1)].kind;
    orbit_action_->setVisible(kind == PageKind::Orbit);
    abscissa_->setEnabled(kind == PageKind::History);
    note_->setText(doc->note.empty()
                       ? QString()
                       : tr("This file is incomplete: %1.").arg(QString::fromStdString(doc->note)));
    setWindowTitle(QString("%1 — page %2 of %3 — AdrPlot")
                       .arg(QString::fromStdString(doc->path.filename().string()))
                       .arg(page_)
                       .arg(pageCount()));
  } else {
    chart.title = "AdrPlot";
    chart.note = "Open a plot file (SOL1 to SOL7, RUN.json, SWEEP.csv), or drop one here.";
    orbit_action_->setVisible(false);
  }
  note_->setVisible(!note_->text().isEmpty());
  view_->chartScene().setPage(std::move(chart));
}

void PlotWindow::askForFile() {
  desktop::ask_file(this, kApp, tr("Open plot file"), "SOL* RUN.json SWEEP.csv",
                    [this](const QString& name) { askForRange(name); });
}

void PlotWindow::askForRange(const QString& path) {
  if (!has_steps(path.toStdString())) {
    openFile(path.toStdString());
    return;
  }
  long stored = 0;
  try {
    // The origin is checked before the user is asked for numbers in vain.
    if (results::sol_kind(path.toStdString()) == results::SolKind::Animation)
      plot_pages(results::SolKind::Animation, {});
    stored = results::stored_steps(path.toStdString());
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return;
  }
  auto* dialog = new RangeDialog(QFileInfo(path).fileName(), stored, this);
  dialog->setObjectName("range");
  connect(dialog, &QDialog::accepted, this,
          [this, dialog, path] { openFile(path.toStdString(), dialog->range()); });
  dialog->open();
}

void PlotWindow::previousPage() {
  if (!document()) return askForFile();
  if (page_ <= 1) return desktop::show_message(this, tr("This is the first plot."));
  showPage(page_ - 1);
}

void PlotWindow::nextPage() {
  if (!document()) return askForFile();
  if (page_ >= pageCount()) return desktop::show_message(this, tr("This is the last plot."));
  showPage(page_ + 1);
}

void PlotWindow::askForPage() {
  if (!document()) return askForFile();
  desktop::ask_number(this, tr("Plot number"), tr("Plot (1 to %1):").arg(pageCount()), page_, 1,
                      pageCount(), [this](int number) { showPage(number); });
}

void PlotWindow::reload() {
  Document* doc = document();
  if (!doc) return;
  try {
    static_cast<PlotDocument&>(*doc) = open_document(doc->path, doc->range);
    page_ = std::min(page_, pageCount());
    fillTree();
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void PlotWindow::print() {
  if (!document()) return askForFile();
  desktop::print_picture(this,
                         [this] { return view_->chartScene().image(view_->viewport()->size()); });
}

void PlotWindow::savePicture() {
  Document* doc = document();
  if (!doc) return askForFile();
  const QString fallback = QString("%1-page-%2.jpg")
                               .arg(QString::fromStdString(doc->path.filename().string()))
                               .arg(page_);
  desktop::save_picture(this, kApp, fallback,
                        [this] { return view_->chartScene().image(view_->viewport()->size()); });
}

void PlotWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  view_->chartScene().setTheme(desktop::current_theme());
}

void PlotWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void PlotWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  event->acceptProposedAction();
  if (urls.size() == 1) return askForRange(urls.front().toLocalFile());
  for (const auto& url : urls) openFile(url.toLocalFile().toStdString());
}

}  // namespace adore::adrplot
