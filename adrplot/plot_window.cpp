#include "adrplot/plot_window.hpp"

#include "adrplot/curve_dialog.hpp"
#include "adrplot/range_dialog.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/page_export.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QActionGroup>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QProgressDialog>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <exception>
#include <set>

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
  cursors_ = new QLabel(this);
  cursors_->setObjectName("cursors");
  cursors_->setMargin(8);
  cursors_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  cursors_->hide();
  column->addWidget(cursors_);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(tree_);
  splitter->addWidget(side);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({270, 1010});
  setCentralWidget(splitter);
  tree_->setAccessibleName(tr("Files and pages"));
  makeButtons();
  makeMenus();
  growth_ = new QTimer(this);
  growth_->setInterval(1000);
  connect(growth_, &QTimer::timeout, this, &PlotWindow::lookForGrowth);
  connect(view_, &desktop::ChartView::cursorsChanged, this, [this] {
    cursors_->setText(view_->cursorReport());
    cursors_->setVisible(!cursors_->text().isEmpty());
  });

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

void PlotWindow::makeMenus() {
  auto* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open..."), this, &PlotWindow::askForFile);
  file->addAction(tr("Open &Folder..."), Qt::CTRL | Qt::SHIFT | Qt::Key_O, this,
                  &PlotWindow::askForFolder);
  desktop::add_recent_menu(*file, kApp, [this](const QString& name) { askForRange(name); });
  file->addAction(tr("&Close File"), QKeySequence::Close, this, &PlotWindow::closeFile);
  file->addSeparator();
  file->addAction(tr("&Reload"), this, &PlotWindow::reload);
  follow_ = file->addAction(tr("&Follow a Running Solver"));
  follow_->setCheckable(true);
  connect(follow_, &QAction::toggled, this, &PlotWindow::follow);
  file->addSeparator();
  file->addAction(tr("&Export Page..."), Qt::CTRL | Qt::Key_E, this, &PlotWindow::exportPage);
  file->addAction(tr("Export &All Pages..."), Qt::CTRL | Qt::SHIFT | Qt::Key_E, this,
                  &PlotWindow::exportAll);
  file->addAction(tr("Cop&y Picture"), QKeySequence::Copy, this, &PlotWindow::copyPicture);
  file->addAction(tr("&Print..."), this, &PlotWindow::print);
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &PlotWindow::close);

  auto* view = menuBar()->addMenu(tr("&View"));
  view->addAction(tr("Zoom &Back"), Qt::ALT | Qt::Key_Left, view_, &desktop::ChartView::zoomBack);
  view->addAction(tr("Zoom &Forward"), Qt::ALT | Qt::Key_Right, view_,
                  &desktop::ChartView::zoomForward);
  view->addAction(tr("Show &Everything"), Qt::Key_Home, view_, &desktop::ChartView::zoomAll);
  view->addAction(tr("&Take Cursors Away"), Qt::Key_Escape, view_,
                  &desktop::ChartView::clearCursors);
  view->addSeparator();
  auto* log_x = view->addAction(tr("Logarithmic &Abscissa"));
  auto* log_y = view->addAction(tr("Logarithmic &Values"), Qt::CTRL | Qt::Key_L, this, [] {});
  for (QAction* action : {log_x, log_y}) {
    action->setCheckable(true);
    connect(action, &QAction::toggled, this,
            [this, log_x, log_y] { setLogAxes(log_x->isChecked(), log_y->isChecked()); });
  }
  view->addAction(tr("&Dark/Light"), this, &PlotWindow::switchTheme);
  makeChartMenu(menuBar()->addMenu(tr("&Chart")));
  desktop::add_help_menu(
      *this, "AdrPlot", tr("AdrPlot draws what a run of Adore stored."),
      {{tr("Page Up, Page Down"), tr("one page back, on")},
       {tr("Ctrl+G"), tr("a page by its number")},
       {tr("wheel"), tr("zooms along the abscissa; with Ctrl along a panel's own axis")},
       {tr("drag"), tr("moves; with Shift zooms into a box")},
       {tr("double click, Home"), tr("shows everything")},
       {tr("Alt+Left, Alt+Right"), tr("earlier and later views")},
       {tr("click on a name in a legend"), tr("hides its curve, or shows it")},
       {tr("Ctrl+click, Ctrl+Shift+click"), tr("cursor A, cursor B; Esc takes them away")}});
}

void PlotWindow::makeChartMenu(QMenu* menu) {
  menu->addAction(tr("&Curves for One Chart..."), Qt::CTRL | Qt::Key_K, this,
                  &PlotWindow::askForCurves);
  menu->addSeparator();
  const auto choices = [this, menu](const QString& title, const QStringList& names, auto set) {
    auto* sub = menu->addMenu(title);
    auto* group = new QActionGroup(sub);
    for (int i = 0; i < names.size(); ++i) {
      auto* action = sub->addAction(names[i], this, [this, set, i] {
        set(options_, i);
        showCurrent();
      });
      action->setCheckable(true);
      action->setChecked(i == 0);
      group->addAction(action);
    }
  };
  choices(tr("Spectrum: &Amplitude"), {tr("over the largest"), tr("in units"), tr("in dB")},
          [](PageOptions& o, int i) { o.spectrum.scale = static_cast<SpectrumScale>(i); });
  choices(tr("Spectrum: &Window"), {tr("Hann"), tr("flat top"), tr("none")},
          [](PageOptions& o, int i) {
            constexpr std::array kWindows{Window::Hann, Window::FlatTop, Window::None};
            o.spectrum.window = kWindows.at(static_cast<std::size_t>(i));
          });
}

void PlotWindow::makeChoices(QToolBar* bar) {
  abscissa_ = new QComboBox(this);
  abscissa_->setObjectName("abscissa");
  abscissa_->setAccessibleName(tr("Abscissa"));
  abscissa_->addItems({tr("over revolutions"), tr("over time"), tr("over steps")});
  connect(abscissa_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.abscissa = static_cast<Abscissa>(index);
    showCurrent();
  });
  domain_ = new QComboBox(this);
  domain_->setObjectName("domain");
  domain_->setAccessibleName(tr("History or frequencies"));
  domain_->addItems({tr("history"), tr("spectrum"), tr("waterfall")});
  connect(domain_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.domain = static_cast<Domain>(index);
    showCurrent();
  });
  orbit_ = new QComboBox(this);
  orbit_->setObjectName("orbit");
  orbit_->setAccessibleName(tr("Coordinates of the orbit"));
  for (const auto& choice : kPairs) orbit_->addItem(choice.text);
  connect(orbit_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.orbit = kPairs.at(static_cast<std::size_t>(index)).pair;
    showCurrent();
  });
  bar->addWidget(abscissa_);
  bar->addWidget(domain_);
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

bool PlotWindow::watchReading(double part) {
  if (part >= 1.0) {
    reading_.reset();
    return true;
  }
  if (!reading_) {
    reading_ = std::make_unique<QProgressDialog>(tr("Reading ..."), tr("Stop"), 0, 1000, this);
    reading_->setObjectName("reading");
    reading_->setWindowModality(Qt::WindowModal);
    reading_->setMinimumDuration(400);
    reading_->setAutoClose(false);
    reading_->setAutoReset(false);
  }
  reading_->setValue(static_cast<int>(1000.0 * part));  // lets the window live
  if (!reading_ || !reading_->wasCanceled()) return true;
  reading_.reset();
  return false;
}

bool PlotWindow::openFile(const std::filesystem::path& path, const results::SolRange& range) {
  try {
    addDocument(
        open_document(path, range, kMostValues, [this](double part) { return watchReading(part); }),
        range);
    desktop::remember_file(kApp, QString::fromStdString(path.string()));
    return true;
  } catch (const results::ReadStopped&) {
    return false;  // as was asked for
  } catch (const std::exception& error) {
    reading_.reset();
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void PlotWindow::addFile(results::SolFile file, const results::SolRange& range) {
  addDocument(make_document(std::move(file)), range);
}

void PlotWindow::addDocument(PlotDocument document, const results::SolRange& range, bool on_disk) {
  std::error_code ignored;
  const std::uintmax_t bytes = on_disk ? std::filesystem::file_size(document.path, ignored) : 0;
  documents_.push_back(std::make_unique<Document>(
      Document{std::move(document), range, on_disk, ignored ? 0 : bytes}));
  current_ = fileCount() - 1;
  page_ = 1;
  fillTree();
}

void PlotWindow::addChart(const std::vector<CurvePick>& picks, Combine how) {
  // Copies share what the files have read, and outlive them in the tree.
  auto files = std::make_shared<std::vector<PlotDocument>>();
  std::vector<std::size_t> of;
  for (const CurvePick& pick : picks) {
    of.push_back(files->size());
    files->push_back(*pick.file);
  }
  const auto build = [files, of, picks, how](int, const PageOptions& options) {
    std::vector<CurvePick> own = picks;
    for (std::size_t i = 0; i < own.size(); ++i) own[i].file = &(*files)[of[i]];
    PageOptions history = options;
    history.domain = Domain::History;
    return combine_curves(own, how, history);
  };
  try {
    (void)build(1, options_);
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return;
  }
  int number = 1;
  for (const auto& document : documents_) number += document->on_disk ? 0 : 1;
  PlotDocument chart;
  chart.path = QString("chart-%1").arg(number).toStdString();
  chart.subject = "own chart";
  chart.pages = {{how == Combine::Difference ? "Differences" : "Chosen curves", PageKind::History}};
  chart.build = build;
  addDocument(std::move(chart), {}, false);
}

void PlotWindow::fillTree() {
  const int file = current_, page = page_;
  std::set<std::filesystem::path> folders;
  for (const auto& doc : documents_)
    if (doc->on_disk) folders.insert(doc->path.parent_path());
  {
    const QSignalBlocker quiet(tree_);
    tree_->clear();
    for (int d = 0; d < fileCount(); ++d) {
      const Document& doc = *documents_[static_cast<std::size_t>(d)];
      QString name = QString::fromStdString(doc.path.filename().string());
      if (folders.size() > 1 && doc.on_disk)  // runs told apart
        name = QString::fromStdString(
                   std::filesystem::absolute(doc.path).parent_path().filename().string()) +
               "/" + name;
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
  abscissa_->setCurrentIndex(static_cast<int>(abscissa));
}

void PlotWindow::setDomain(Domain domain) { domain_->setCurrentIndex(static_cast<int>(domain)); }

void PlotWindow::setLogAxes(bool abscissa, bool values) {
  log_x_ = abscissa;
  log_y_ = values;
  showCurrent();
}

desktop::ChartPage PlotWindow::currentPageChart() {
  desktop::ChartPage chart = document()->build(page_, options_);
  if (!chart.equal_axes) {
    chart.log_x = log_x_;
    for (auto& panel : chart.panels) panel.log = log_y_;
  }
  return chart;
}

void PlotWindow::showCurrent() {
  Document* doc = document();
  desktop::ChartPage chart;
  if (doc) {
    try {
      chart = currentPageChart();
    } catch (const std::exception& error) {
      chart = {};
      chart.title = doc->pages[static_cast<std::size_t>(page_ - 1)].title;
      chart.note = error.what();
      reading_.reset();
    }
    const PageKind kind = doc->pages[static_cast<std::size_t>(page_ - 1)].kind;
    orbit_action_->setVisible(kind == PageKind::Orbit);
    abscissa_->setEnabled(kind == PageKind::History && options_.domain == Domain::History);
    domain_->setEnabled(kind == PageKind::History && doc->on_disk);
    note_->setText(doc->note.empty()
                       ? QString()
                       : tr("This file is incomplete: %1.").arg(QString::fromStdString(doc->note)));
    setWindowTitle(QString("%1 — page %2 of %3 — AdrPlot")
                       .arg(QString::fromStdString(doc->path.filename().string()))
                       .arg(page_)
                       .arg(pageCount()));
  } else {
    chart.title = "AdrPlot";
    chart.note =
        "Open a plot file (SOL1 to SOL7, RUN.json, SWEEP.csv, ACCURACY.json), or drop one here.";
    orbit_action_->setVisible(false);
  }
  note_->setVisible(!note_->text().isEmpty());
  view_->showPage(std::move(chart));
}

void PlotWindow::askForFile() {
  desktop::ask_files(this, kApp, tr("Open plot files"), "SOL* RUN.json SWEEP.csv ACCURACY.json",
                     [this](const QStringList& names) { openSeveral(names); });
}

void PlotWindow::askForFolder() {
  auto* dialog = new QFileDialog(this, tr("Open the plot files of a folder"),
                                 QSettings("Adore", kApp).value("open/folder").toString());
  dialog->setObjectName("folder");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& folder) { openFolder(folder); });
  dialog->open();
}

void PlotWindow::openFolder(const QString& folder, const results::SolRange& range) {
  QStringList names;
  const QDir dir(folder);
  for (const QString& name : dir.entryList({"SOL1", "SOL2", "SOL3", "SOL4", "SOL5", "SOL6", "SOL7"},
                                           QDir::Files, QDir::Name))
    names << dir.filePath(name);
  // A quasi-static run, a sweep or a study has no step files.
  if (names.isEmpty())
    for (const QString& name :
         dir.entryList({"RUN.json", "SWEEP.csv", "ACCURACY.json"}, QDir::Files, QDir::Name))
      names << dir.filePath(name);
  if (names.isEmpty())
    return desktop::show_message(
        this, tr("%1 holds no plot file: neither SOL1 to SOL7 nor RUN.json, SWEEP.csv or "
                 "ACCURACY.json.")
                  .arg(folder));
  for (const QString& name : names) openFile(name.toStdString(), range);
}

void PlotWindow::openSeveral(const QStringList& paths) {
  if (paths.size() == 1) {
    if (QFileInfo(paths.front()).isDir()) return openFolder(paths.front());
    return askForRange(paths.front());
  }
  for (const QString& path : paths) {
    if (QFileInfo(path).isDir())
      openFolder(path);
    else
      openFile(path.toStdString());
  }
}

void PlotWindow::closeFile() {
  if (!document()) return;
  documents_.erase(documents_.begin() + current_);
  current_ = std::min(current_, fileCount() - 1);
  page_ = current_ >= 0 ? 1 : 0;
  if (current_ < 0) {
    const QSignalBlocker quiet(tree_);
    tree_->clear();
  } else {
    fillTree();
  }
  showCurrent();
}

void PlotWindow::askForCurves() {
  std::vector<const PlotDocument*> files;
  for (const auto& doc : documents_)
    if (doc->on_disk) files.push_back(doc.get());
  if (files.empty()) return askForFile();
  auto* dialog = new CurveDialog(files, options_, this);
  dialog->setObjectName("curveDialog");
  dialog->setModal(true);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog] { addChart(dialog->picks(), dialog->how()); });
  dialog->open();
}

void PlotWindow::copyPicture() {
  if (!document()) return;
  QGuiApplication::clipboard()->setImage(view_->chartScene().image(view_->viewport()->size()));
}

bool PlotWindow::exportTo(const QString& path, bool all_pages) {
  Document* doc = document();
  if (!doc) return false;
  desktop::ChartScene scene;  // of its own: what is seen stays as it is
  scene.setTheme(desktop::current_theme());
  const QSizeF size = view_->viewport()->size();
  const int shown = page_;
  const auto show = [&](int page) {
    page_ = page;
    scene.setPage(currentPageChart());
    page_ = shown;
  };
  try {
    if (!all_pages) {
      show(shown);
      scene.setZoom(view_->chartScene().zoom());
      desktop::save_page(scene, path.toStdString(), size);
    } else if (QFileInfo(path).suffix().toLower() == "pdf") {
      desktop::save_pdf(scene, path.toStdString(), doc->pages.size(), size,
                        [&](std::size_t i) { show(static_cast<int>(i) + 1); });
    } else {
      const QFileInfo info(path);
      for (int page = 1; page <= pageCount(); ++page) {
        show(page);
        desktop::save_page(scene,
                           info.dir()
                               .filePath(QString("%1-%2.%3")
                                             .arg(info.completeBaseName())
                                             .arg(page, 2, 10, QChar('0'))
                                             .arg(info.suffix()))
                               .toStdString(),
                           size);
      }
    }
    return true;
  } catch (const std::exception& error) {
    page_ = shown;
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void PlotWindow::askForExport(bool all_pages) {
  Document* doc = document();
  if (!doc) return askForFile();
  auto* dialog =
      new QFileDialog(this, all_pages ? tr("Export all pages") : tr("Export page"), QString(),
                      tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;JPEG (*.jpg);;Numbers (*.csv)"));
  dialog->setObjectName("export");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("pdf");
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.section("*.", 1).section(')', 0, 0));
  });
  const QString name = QString::fromStdString(doc->path.filename().string());
  dialog->selectFile(all_pages ? name : QString("%1-page-%2").arg(name).arg(page_));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, all_pages](const QString& path) { exportTo(path, all_pages); });
  dialog->open();
}

void PlotWindow::exportPage() { askForExport(false); }
void PlotWindow::exportAll() { askForExport(true); }

void PlotWindow::follow(bool on) {
  if (follow_->isChecked() != on) follow_->setChecked(on);
  on ? growth_->start() : growth_->stop();
}

void PlotWindow::lookForGrowth() {
  Document* doc = document();
  if (!doc || !doc->on_disk || reading_) return;
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(doc->path, error);
  if (error || bytes == doc->bytes) return;
  reload();
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
  if (!doc || !doc->on_disk) return;
  try {
    std::error_code ignored;
    doc->bytes = std::filesystem::file_size(doc->path, ignored);
    static_cast<PlotDocument&>(*doc) = open_document(
        doc->path, doc->range, kMostValues, [this](double part) { return watchReading(part); });
    page_ = std::min(page_, pageCount());
    fillTree();
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void PlotWindow::showFiles(const QStringList& paths) {
  for (const QString& name : paths) {
    const std::filesystem::path path = name.toStdString();
    std::error_code ignored;
    const auto open = std::find_if(documents_.begin(), documents_.end(), [&](const auto& doc) {
      return doc->on_disk && std::filesystem::equivalent(doc->path, path, ignored);
    });
    if (open == documents_.end()) {
      openFile(path, {});
      continue;
    }
    current_ = static_cast<int>(open - documents_.begin());
    reload();
  }
  raise();
  activateWindow();
}

void PlotWindow::print() {
  if (!document()) return askForFile();
  desktop::print_page(this, [this](QPainter& painter, const QRectF& paper) {
    const QSizeF page = view_->viewport()->size();
    desktop::paint_vector(view_->chartScene(), painter, paper, page);
  });
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
  QStringList paths;
  for (const auto& url : event->mimeData()->urls()) paths << url.toLocalFile();
  event->acceptProposedAction();
  openSeveral(paths);
}

}  // namespace adore::adrplot
