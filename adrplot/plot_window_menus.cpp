#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/chrome.hpp"
#include "desktop/link_action.hpp"
#include "desktop/spoken_name.hpp"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include <array>

/// Menus, buttons and choices of the window.
namespace adore::adrplot {
namespace {

struct PairChoice {
  const char* text;
  OrbitAxes pair;
};
constexpr std::array<PairChoice, 3> kPairs{
    {{"Z over Y", {1, 2}}, {"Z over X", {0, 2}}, {"Y over X", {0, 1}}}};

}  // namespace

void PlotWindow::makeButtons() {
  auto* bar = addToolBar(tr("Plots"));
  bar->setObjectName("buttons");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  // The shortcut of a button with a menu entry belongs to the menu, which shows it.
  const auto button = [&](const QString& text, const QKeySequence& key, auto slot,
                          const QString& help, bool in_menu = false) {
    auto* action = bar->addAction(text);
    if (!in_menu) action->setShortcut(key);
    action->setToolTip(help + " (" + key.toString(QKeySequence::NativeText) + ")");
    connect(action, &QAction::triggered, this, slot);
  };
  button(tr("Open Plot File"), QKeySequence::Open, &PlotWindow::askForFile,
         tr("Select a plot file (SOL1 to SOL7)"), true);
  button(tr("Prev Plot"), Qt::Key_PageUp, &PlotWindow::previousPage, tr("Previous page"));
  button(tr("Next Plot"), Qt::Key_PageDown, &PlotWindow::nextPage, tr("Next page"));
  button(tr("Plot Number"), Qt::CTRL | Qt::Key_G, &PlotWindow::askForPage,
         tr("Go to a page by its number"));
  button(tr("Print"), QKeySequence::Print, &PlotWindow::print, tr("Print this page"), true);
  button(tr("Save JPG"), QKeySequence::Save, &PlotWindow::savePicture,
         tr("Save this page as JPEG or PNG"));
  button(tr("Reload"), Qt::Key_F5, &PlotWindow::reload,
         tr("Reload the file, e.g. while a run is active"), true);
  button(tr("Dark/Light"), Qt::CTRL | Qt::Key_D, &PlotWindow::switchTheme,
         tr("Dark or light theme"), true);
  button(tr("Quit"), Qt::CTRL | Qt::Key_Q, &PlotWindow::close, tr("Quit AdrPlot"), true);
  bar->addSeparator();
  makeChoiceBoxes(bar);
}

void PlotWindow::makeMenus() {
  auto* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open..."), QKeySequence::Open, this, &PlotWindow::askForFile);
  file->addAction(tr("Open &Folder..."), Qt::CTRL | Qt::SHIFT | Qt::Key_O, this,
                  &PlotWindow::askForFolder);
  file->addAction(tr("Open Pro&ject..."), this, &PlotWindow::askForProject);
  desktop::add_recent_menu(*file, kApp, [this](const QString& name) { openFiles({name}); });
  file->addAction(tr("Ope&n Session..."), this, [this] { askForSession(false); });
  file->addAction(tr("Save Sess&ion As..."), Qt::CTRL | Qt::SHIFT | Qt::Key_S, this,
                  [this] { askForSession(true); });
  file->addAction(tr("&Close File"), QKeySequence::Close, this, &PlotWindow::closeFile);
  file->addSeparator();
  file->addAction(tr("Re&load"), Qt::Key_F5, this, &PlotWindow::reload);
  follow_action_ = file->addAction(tr("Follow a Running &Solver"));
  follow_action_->setCheckable(true);
  connect(follow_action_, &QAction::toggled, this, &PlotWindow::follow);
  file->addSeparator();
  file->addAction(tr("&Export Page..."), Qt::CTRL | Qt::Key_E, this, &PlotWindow::exportPage);
  file->addAction(tr("Export &All Pages..."), Qt::CTRL | Qt::SHIFT | Qt::Key_E, this,
                  &PlotWindow::exportAll);
  file->addAction(tr("Export Fi&gure for Print..."), this, &PlotWindow::exportFigure);
  file->addAction(tr("Write Repor&t..."), this, &PlotWindow::askForReport);
  file->addAction(tr("Cop&y Picture"), QKeySequence::Copy, this, &PlotWindow::copyPicture);
  file->addAction(tr("Copy &Values at the Cursors"), Qt::CTRL | Qt::SHIFT | Qt::Key_C, this,
                  &PlotWindow::copyCursorReport);
  file->addAction(tr("&Print..."), QKeySequence::Print, this, &PlotWindow::print);
  file->addSeparator();
  file->addAction(tr("&Quit"), Qt::CTRL | Qt::Key_Q, this, &PlotWindow::close);

  auto* view = menuBar()->addMenu(tr("&View"));
  view->setToolTipsVisible(true);
  addChartAction(view, desktop::ChartAction::ZoomIn, tr("Zoom &In"), {Qt::Key_Plus, Qt::Key_Equal});
  addChartAction(view, desktop::ChartAction::ZoomOut, tr("Zoom &Out"), {Qt::Key_Minus});
  addChartAction(view, desktop::ChartAction::ZoomToCursors, tr("Zoom to &Cursors"), {Qt::Key_Z});
  view->addAction(tr("Zoom &Back"), Qt::ALT | Qt::Key_Left, view_, &desktop::ChartView::zoomBack);
  view->addAction(tr("Zoom &Forward"), Qt::ALT | Qt::Key_Right, view_,
                  &desktop::ChartView::zoomForward);
  view->addAction(tr("Show &Everything"), Qt::Key_Home, view_, &desktop::ChartView::zoomAll);
  view->addAction(tr("Remove C&ursors"), Qt::Key_Escape, view_, &desktop::ChartView::clearCursors);
  makeKeyMenus(view);
  view->addSeparator();
  auto* log_x = view->addAction(tr("Logarithmic &Abscissa"));
  auto* log_y = view->addAction(tr("Logarithmic &Values"), Qt::CTRL | Qt::Key_L, this, [] {});
  for (QAction* action : {log_x, log_y}) {
    action->setCheckable(true);
  }
  log_x_action_ = log_x;
  log_y_action_ = log_y;
  connect(log_x, &QAction::toggled, this, [this](bool on) { setLogAxes(on, log_y_); });
  connect(log_y, &QAction::toggled, this, [this](bool on) { setLogAxes(log_x_, on); });
  view->addAction(statistics_action_);
  desktop::add_link_action(*view, *link_, kApp);
  view->addAction(tr("&Dark/Light"), Qt::CTRL | Qt::Key_D, this, &PlotWindow::switchTheme);
  makeChartMenu(menuBar()->addMenu(tr("&Chart")));
  desktop::add_help_menu(
      *this, "AdrPlot", tr("AdrPlot plots the results of Adore."),
      {{tr("Page Up, Page Down"), tr("previous or next page")},
       {tr("Ctrl+G"), tr("go to a page by number")},
       {tr("F5"), tr("reload the file")},
       {tr("wheel"), tr("zoom the horizontal axis (Ctrl: vertical axis; orbits: both axes)")},
       {tr("drag"), tr("move the curves; with Shift: zoom to a box")},
       {tr("double click, Home"), tr("show all")},
       {tr("Alt+Left, Alt+Right"), tr("previous or next view")},
       {tr("click a panel"), tr("use the first curve of the panel for spectrograms")},
       {tr("drag a name in a legend or the title of a panel"),
        tr("move the curves to another panel, or to a new one")},
       {tr("drag a channel from the list to a panel"), tr("add its curve")},
       {tr("Ctrl+T"), tr("statistics table")},
       {tr("click a name in a legend"), tr("show or hide the curve")},
       {tr("Ctrl+click or drag, Ctrl+Shift+click or drag"),
        tr("set or move cursor A or B (Esc removes both cursors)")},
       {tr("Tab"), tr("focus the chart for the keys below (a frame shows the focus)")},
       {tr("+ or =, -"), tr("zoom in or out at the current point or the center")},
       {tr("Left, Right"), tr("move by a tenth of the visible range")},
       {tr("Shift+Left, Shift+Right"), tr("move by the whole visible range")},
       {tr("Up, Down"), tr("move an orbit or the enlarged values of a panel")},
       {tr("Ctrl++, Ctrl+-"), tr("zoom the vertical axis of a panel")},
       {tr("Ctrl+Up, Ctrl+Down"), tr("select the panel that keys act on (marked by a bar)")},
       {tr("Ctrl+Left, Ctrl+Right"),
        tr("read the previous or next stored point; with Shift: move several points")},
       {tr("A, B"), tr("place or remove cursor A or B at the current point")},
       {tr("Z"), tr("zoom to the range between the cursors")},
       {tr("1 to 9"), tr("show or hide curve 1 to 9 of the legends")}});
}

void PlotWindow::makeChartMenu(QMenu* menu) {
  menu->setToolTipsVisible(true);
  menu->addAction(tr("&Combine Curves..."), Qt::CTRL | Qt::Key_K, this, &PlotWindow::askForCurves);
  menu->addAction(tr("&Formula Channel..."), Qt::CTRL | Qt::SHIFT | Qt::Key_F, this,
                  &PlotWindow::askForFormula);
  curve_names_menu_ = menu->addMenu(tr("Cur&ves Shown"));
  curve_names_menu_->setObjectName("names");
  menu->addSeparator();
  const auto choices = [this, menu](const QString& title, const QStringList& names, auto set) {
    auto* sub = menu->addMenu(title);
    spectrum_actions_ << sub->menuAction();
    auto* group = new QActionGroup(sub);
    for (int i = 0; i < names.size(); ++i) {
      auto* action = sub->addAction(names[i], this, [this, set, i] {
        set(options_, i);
        showCurrentPage();
      });
      action->setCheckable(true);
      action->setChecked(i == 0);
      group->addAction(action);
    }
  };
  choices(
      tr("Spectrum: &Amplitude"),
      {tr("automatic (spectrogram: in dB)"), tr("in units"), tr("in dB"), tr("relative")},
      [](PageOptions& o, int i) { o.spectrum.scale = kScales.at(static_cast<std::size_t>(i)); });
  choices(tr("Spectrum: &Window"), {tr("Hann"), tr("flat top"), tr("none")},
          [](PageOptions& o, int i) {
            constexpr std::array kWindows{Window::Hann, Window::FlatTop, Window::None};
            o.spectrum.window = kWindows.at(static_cast<std::size_t>(i));
          });
  choices(tr("Spectrogram: Vertical A&xis"), {tr("time"), tr("shaft speed")},
          [](PageOptions& o, int i) { o.spectrum.over_speed = i == 1; });
  choices(tr("Orders &Of"),
          {tr("automatic (order spectrum: shaft orders; envelope spectrum: no orders, Hz)"),
           tr("shaft"), tr("cage"), tr("rolling element")},
          [](PageOptions& o, int i) { o.spectrum.orders_of = static_cast<OrderReference>(i); });
  band_action_ = menu->addAction(tr("Envelope: &Band..."), this, &PlotWindow::askForBand);
  band_action_->setObjectName("band");
  spectrogram_curve_menu_ = menu->addMenu(tr("Spectrogram: Cu&rve"));
  spectrogram_curve_menu_->setObjectName("curves");
}

namespace {

/// Disabled entries show the reason in a tooltip.
template <class Choice>
void offer(Choice* choice, bool applies, const QString& why_not) {
  choice->setEnabled(applies);
  choice->setToolTip(applies ? QString() : why_not);
}

}  // namespace

void PlotWindow::enableChoices(PageKind kind, const desktop::ChartPage& chart) {
  const bool steps = kind == PageKind::History, over_time = options_.domain == Domain::History;
  const QString not_of_steps = kind == PageKind::Chart
                                   ? tr("This page has its own horizontal axis.")
                                   : tr("This page has only one chart type.");
  offer(abscissa_, steps && over_time, steps ? tr("Spectra have a frequency axis.") : not_of_steps);
  offer(domain_, steps, not_of_steps);
  const QString no_axes = chart.study        ? tr("Charts of a study have fixed axes.")
                          : chart.equal_axes ? tr("This page uses equal axis scales.")
                                             : tr("There are no curves on this page.");
  const bool axes = !chart.equal_axes && !chart.study && !chart.panels.empty();
  offer(log_x_action_, axes, no_axes);
  const bool decibels = std::any_of(chart.panels.begin(), chart.panels.end(),
                                    [](const auto& panel) { return is_decibel(panel.unit); });
  offer(log_y_action_, axes && !decibels,
        axes ? tr("The unit dB is already logarithmic.") : no_axes);
  const bool spectra = kind == PageKind::Spectrum || (steps && !over_time);
  for (QAction* action : spectrum_actions_)
    offer(action, spectra, tr("This page shows no spectra. Select \"spectrum\" in the toolbar."));
  offer(band_action_, steps && options_.domain == Domain::Envelope,
        tr("This page shows no envelope. Select \"envelope spectrum\" in the toolbar."));
}

void PlotWindow::fillSpectrogramCurves(const desktop::ChartPage& chart) {
  spectrogram_curve_box_->clear();
  for (const std::string& name : chart.choices)
    spectrogram_curve_box_->addItem(QString::fromStdString(name));
  spectrogram_curve_box_->setCurrentIndex(static_cast<int>(chart.chosen));
  spectrogram_curve_action_->setVisible(!chart.choices.empty());
  spectrogram_curve_menu_->clear();
  for (std::size_t i = 0; i < chart.choices.size(); ++i) {
    auto* action = spectrogram_curve_menu_->addAction(
        QString::fromStdString(chart.choices[i]), this,
        [this, name = chart.choices[i]] { setSpectrogramCurve(name); });
    action->setCheckable(true);
    action->setChecked(i == chart.chosen);
  }
  spectrogram_curve_menu_->menuAction()->setEnabled(!chart.choices.empty());
  spectrogram_curve_menu_->menuAction()->setToolTip(
      chart.choices.empty()
          ? tr("This page shows no spectrogram. Select \"spectrogram\" in the toolbar.")
          : tr("Curve of the spectrogram"));
}

void PlotWindow::makeChoiceBoxes(QToolBar* bar) {
  abscissa_ = new QComboBox(this);
  abscissa_->setObjectName("abscissa");
  desktop::set_accessible_name(*abscissa_, tr("Abscissa"));
  abscissa_->addItems({tr("over revolutions"), tr("over time"), tr("over steps")});
  connect(abscissa_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.abscissa = static_cast<Abscissa>(index);
    showCurrentPage();
  });
  domain_ = new QComboBox(this);
  domain_->setObjectName("domain");
  desktop::set_accessible_name(*domain_, tr("Chart type"));
  domain_->addItems({tr("history"), tr("spectrum"), tr("spectrogram"), tr("envelope spectrum"),
                     tr("order spectrum")});
  connect(domain_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.domain = static_cast<Domain>(index);
    log_x_.reset();  // the setting for times does not apply to frequencies
    showCurrentPage();
  });
  orbit_axes_box_ = new QComboBox(this);
  orbit_axes_box_->setObjectName("orbit");
  desktop::set_accessible_name(*orbit_axes_box_, tr("Orbit coordinates"));
  for (const auto& choice : kPairs) orbit_axes_box_->addItem(choice.text);
  connect(orbit_axes_box_, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.orbit = kPairs.at(static_cast<std::size_t>(index)).pair;
    showCurrentPage();
  });
  spectrogram_curve_box_ = new QComboBox(this);
  spectrogram_curve_box_->setObjectName("curve");
  desktop::set_accessible_name(*spectrogram_curve_box_, tr("Curve of the spectrogram"));
  spectrogram_curve_box_->setToolTip(tr("Curve of the spectrogram"));
  spectrogram_curve_box_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(spectrogram_curve_box_, &QComboBox::activated, this, [this](int index) {
    setSpectrogramCurve(spectrogram_curve_box_->itemText(index).toStdString());
  });
  bar->addWidget(abscissa_);
  bar->addWidget(domain_);
  spectrogram_curve_action_ = bar->addWidget(spectrogram_curve_box_);
  orbit_action_ = bar->addWidget(orbit_axes_box_);
}

}  // namespace adore::adrplot
