#include "adrplot/channel_tree.hpp"
#include "adrplot/element_curves.hpp"
#include "adrplot/formula_dialog.hpp"
#include "adrplot/plot_window.hpp"
#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/run_link.hpp"

#include <QComboBox>
#include <QMenu>
#include <QMimeData>
#include <QTabWidget>
#include <QTreeWidget>

#include <algorithm>
#include <map>

/// Charts of chosen channels, and channels computed from others.
namespace adore::adrplot {
namespace {

PlotDocument document_of_chart(const std::shared_ptr<UserChart>& chart, int number) {
  PlotDocument out;
  out.path = QString("chart-%1").arg(number).toStdString();
  out.subject = "own chart";
  out.pages = {
      {chart->how == Combine::Difference ? "Differences" : "Selected curves", PageKind::History}};
  out.build = [chart](int, const PageOptions& options) {
    return combine_curves(chart->curves, chart->how, options);
  };
  return out;
}

int next_group(const UserChart& chart) {
  int out = 0;
  for (const CurvePick& pick : chart.curves) out = std::max(out, pick.group + 1);
  return out;
}

}  // namespace

void PlotWindow::makeChannelTab(QWidget* pages) {
  auto* tabs = qobject_cast<QTabWidget*>(pages);
  channel_tree_ = new ChannelTree(this);
  tabs->addTab(channel_tree_, tr("Channels"));
  connect(channel_tree_, &ChannelTree::addToChartRequested, this, [this] {
    if (auto picks = selectedPicks(); !picks.empty()) addToChart(std::move(picks), std::nullopt);
  });
  connect(channel_tree_, &ChannelTree::newChartRequested, this, [this] {
    if (const auto picks = selectedPicks(); !picks.empty()) addChart(picks, Combine::Overlay);
  });
  connect(channel_tree_, &ChannelTree::formulaRequested, this,
          [this] { openFormulaDialog(channel_tree_->selected()); });
  connect(channel_tree_, &ChannelTree::pageRequested, this, [this] {
    if (const auto chosen = channel_tree_->selected(); !chosen.empty()) showPageOf(chosen.front());
  });
  view_->enableDrops({kChannelsMime, desktop::ChartView::kCurveMime});
  connect(view_, &desktop::ChartView::dropped, this, &PlotWindow::handleDrop);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(view_, &QWidget::customContextMenuRequested, this, &PlotWindow::showChartMenu);
}

void PlotWindow::fillChannels() {
  std::vector<const PlotDocument*> files;
  for (const auto& document : documents_) files.push_back(document->own ? nullptr : document.get());
  channel_tree_->fill(files);
}

void PlotWindow::showPageOf(const ChannelRef& ref) {
  if (ref.file < 0 || ref.file >= fileCount()) return;
  if (QTreeWidgetItem* item = tree_->topLevelItem(ref.file)->child(ref.page - 1))
    tree_->setCurrentItem(item);
}

CurvePick PlotWindow::curvePickOf(const ChannelRef& ref) const {
  const Document& file = *documents_.at(static_cast<std::size_t>(ref.file));
  PageOptions history = options_;
  history.domain = Domain::History;
  const desktop::ChartPage page = file.build(ref.page, history);
  CurvePick out{&file, ref.page, static_cast<std::size_t>(ref.panel), 0};
  if (out.panel >= page.panels.size() || page.panels[out.panel].curves.empty())
    throw InputError(file.path.string() + ": the channel has no values");
  out.curve = curve_index(page, out.panel, ref.curve);
  return out;
}

/// Empty after a message.
std::vector<CurvePick> PlotWindow::selectedPicks() {
  std::vector<CurvePick> out;
  try {
    for (const ChannelRef& ref : channel_tree_->selected()) out.push_back(curvePickOf(ref));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    out.clear();
  }
  return out;
}

void PlotWindow::addUserChart(std::shared_ptr<UserChart> chart) {
  stopFollowingElement();
  try {
    (void)combine_curves(chart->curves, chart->how, options_);
  } catch (const std::exception& error) {
    return desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
  int number = 1;
  for (const auto& document : documents_) number += document->own ? 1 : 0;
  PlotDocument page = document_of_chart(chart, number);
  addDocument(std::move(page), {}, false, std::move(chart));
}

void PlotWindow::addChart(const std::vector<CurvePick>& picks, Combine how) {
  auto chart = std::make_shared<UserChart>();
  chart->how = how;
  for (const CurvePick& pick : picks) chart->add(pick);
  addUserChart(std::move(chart));
}

/// Panels as on the page.
UserChart PlotWindow::userChartOfPage() {
  UserChart out;
  const Document* doc = document();
  if (doc == nullptr || doc->own) return out;
  PageOptions history = options_;
  history.domain = Domain::History;
  const desktop::ChartPage page = doc->build(page_, history);
  if (page.equal_axes || page.study) return out;
  const auto& shown = view_->chartScene().page().panels;
  for (std::size_t p = 0; p < page.panels.size(); ++p)
    for (std::size_t c = 0; c < page.panels[p].curves.size(); ++c) {
      const bool hidden =
          p < shown.size() && c < shown[p].curves.size() && shown[p].curves[c].hidden;
      if (!hidden) out.add({doc, page_, p, c, static_cast<int>(p)});
    }
  return out;
}

/// Panel and curve of each pick on the page that combine_curves() makes.
std::vector<std::pair<std::size_t, std::size_t>> PlotWindow::curvePositions(
    const UserChart& chart) const {
  std::vector<std::pair<int, std::string>> panels;
  std::vector<std::size_t> count;
  std::vector<std::pair<std::size_t, std::size_t>> out;
  PageOptions history = options_;
  history.domain = Domain::History;
  for (const CurvePick& pick : chart.curves) {
    const desktop::ChartPage page = pick.file->build(pick.page, history);
    const std::pair key(pick.group, page.panels.at(pick.panel).unit);
    const auto known = std::find(panels.begin(), panels.end(), key);
    const auto panel = static_cast<std::size_t>(known - panels.begin());
    if (known == panels.end()) {
      panels.push_back(key);
      count.push_back(0);
    }
    out.emplace_back(panel, count[panel]++);
  }
  return out;
}

void PlotWindow::updateUserChart() {
  view_->zoomAll();
  showCurrentPage();
}

void PlotWindow::addToChart(std::vector<CurvePick> picks, std::optional<std::size_t> panel) {
  if (picks.empty()) return;
  Document* doc = document();
  std::shared_ptr<UserChart> chart = doc != nullptr ? doc->own : nullptr;
  const bool existing = chart != nullptr && chart->how == Combine::Overlay;
  try {
    if (!existing) {
      chart = std::make_shared<UserChart>();
      if (panel) *chart = userChartOfPage();
    } else if (next_group(*chart) == 0) {  // made by unit
      const std::vector<int> groups = groups_by_unit(chart->curves, options_);
      for (std::size_t i = 0; i < groups.size(); ++i) chart->curves[i].group = groups[i];
    }
    // Curves are added to those that are shown.
    if (existing && followed_element_ > 0 && link_->isActive())
      if (auto shown = chart_of_element(*chart, followed_element_, openFiles()))
        *chart = std::move(*shown);
    const auto places = curvePositions(*chart);
    int group = next_group(*chart);
    if (panel)
      for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].first == *panel) group = chart->curves[i].group;
    const UserChart before = *chart;
    for (CurvePick& pick : picks) {
      pick.group = group;
      chart->add(pick);
    }
    try {
      (void)combine_curves(chart->curves, chart->how, options_);
    } catch (...) {
      *chart = before;
      throw;
    }
    if (!existing) return addUserChart(std::move(chart));
    stopFollowingElement();
    updateUserChart();
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void PlotWindow::moveCurve(std::size_t panel, std::optional<std::size_t> curve,
                           std::optional<std::size_t> target) {
  Document* doc = document();
  if (doc == nullptr || (target && *target == panel)) return;
  if (options_.domain != Domain::History)
    return desktop::show_in_status_bar(this,
                                       tr("Select \"history\" to move curves between panels."));
  const desktop::ChartPage page = view_->chartScene().page();
  if (page.equal_axes || panel >= page.panels.size()) return;
  if (target && page.panels.at(*target).unit != page.panels[panel].unit)
    return desktop::show_in_status_bar(this,
                                       tr("Curves with different units do not share a panel."));
  if (doc->own && doc->own->how == Combine::Difference)
    return desktop::show_in_status_bar(this, tr("Differences stay in one panel."));
  try {
    std::shared_ptr<UserChart> chart = doc->own;
    const bool existing = chart != nullptr;
    if (!existing) {
      chart = std::make_shared<UserChart>(userChartOfPage());
    } else if (next_group(*chart) == 0) {
      const std::vector<int> groups = groups_by_unit(chart->curves, options_);
      for (std::size_t i = 0; i < groups.size(); ++i) chart->curves[i].group = groups[i];
    }
    const auto places = curvePositions(*chart);
    int group = next_group(*chart);
    for (std::size_t i = 0; target && i < places.size(); ++i)
      if (places[i].first == *target) group = chart->curves[i].group;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i].first == panel && (!curve || places[i].second == *curve))
        chart->curves[i].group = group;
    if (!existing) return addUserChart(std::move(chart));
    updateUserChart();
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void PlotWindow::removeCurve(std::size_t panel, std::size_t curve) {
  Document* doc = document();
  if (doc == nullptr || !doc->own || doc->own->curves.size() < 2) return;
  UserChart& chart = *doc->own;
  if (next_group(chart) == 0) {
    const std::vector<int> groups = groups_by_unit(chart.curves, options_);
    for (std::size_t i = 0; i < groups.size(); ++i) chart.curves[i].group = groups[i];
  }
  const auto places = curvePositions(chart);
  const auto at = std::find(places.begin(), places.end(), std::pair(panel, curve));
  if (at == places.end()) return;
  chart.curves.erase(chart.curves.begin() + (at - places.begin()));
  chart.files.erase(chart.files.begin() + (at - places.begin()));
  updateUserChart();
}

void PlotWindow::handleDrop(const QMimeData* mime, std::optional<std::size_t> panel) {
  if (mime->hasFormat(kChannelsMime)) {
    try {
      std::vector<CurvePick> picks;
      for (const ChannelRef& ref : channels_in(*mime))
        if (ref.file >= 0 && ref.file < fileCount()) picks.push_back(curvePickOf(ref));
      return addToChart(std::move(picks), panel);
    } catch (const std::exception& error) {
      return desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  }
  const QList<QByteArray> words = mime->data(desktop::ChartView::kCurveMime).split(' ');
  if (words.size() != 2) return;
  const int curve = words[1].toInt();
  moveCurve(words[0].toULong(),
            curve < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(curve)), panel);
}

void PlotWindow::showChartMenu(const QPoint& at) {
  Document* doc = document();
  if (doc == nullptr) return;
  const QPointF position = view_->mapToScene(at);
  const auto name = view_->legendAt(position);
  auto panel = view_->chartScene().panelAt(position);
  if (!panel) panel = view_->panelTitleAt(position);
  if (name) panel = name->panel;
  const bool plain = !view_->chartScene().page().equal_axes && !view_->chartScene().page().study &&
                     options_.domain == Domain::History;
  auto* menu = new QMenu(this);
  menu->setObjectName("chartMenu");
  connect(menu, &QMenu::aboutToHide, menu, &QObject::deleteLater);
  if (name) {
    menu->addAction(tr("Move to &New Panel"), this,
                    [this, name] { moveCurve(name->panel, name->curve, std::nullopt); })
        ->setEnabled(plain);
    menu->addAction(tr("Re&move Curve"), this,
                    [this, name] { removeCurve(name->panel, name->curve); })
        ->setEnabled(plain && doc->own && doc->own->curves.size() > 1);
    menu->addSeparator();
  }
  auto* types = menu->addMenu(tr("Chart &Type"));
  types->setEnabled(domain_->isEnabled());
  for (int i = 0; i < domain_->count(); ++i) {
    auto* type =
        types->addAction(domain_->itemText(i), this, [this, i] { domain_->setCurrentIndex(i); });
    type->setCheckable(true);
    type->setChecked(i == domain_->currentIndex());
  }
  menu->addSeparator();
  menu->addAction(tr("Show &Everything"), view_, &desktop::ChartView::zoomAll);
  menu->addAction(tr("Zoom &Back"), view_, &desktop::ChartView::zoomBack);
  menu->addSeparator();
  menu->addAction(tr("&Statistics Table"), this, [this] { showStatistics(true); });
  menu->addAction(tr("&Copy Picture"), this, &PlotWindow::copyPicture);
  menu->addAction(tr("E&xport Page..."), this, &PlotWindow::exportPage);
  menu->popup(view_->viewport()->mapToGlobal(at));
}

// Computed channels.

int PlotWindow::formulaDocumentIndex() const {
  for (int d = 0; d < fileCount(); ++d) {
    const Document& one = *documents_[static_cast<std::size_t>(d)];
    if (!one.on_disk && !one.own) return d;
  }
  return -1;
}

std::shared_ptr<const PlotDocument> PlotWindow::copyDocument(int document) const {
  return std::make_shared<PlotDocument>(*documents_.at(static_cast<std::size_t>(document)));
}

FormulaInput PlotWindow::formulaInputOf(const ChannelRef& ref) const {
  return {"", copyDocument(ref.file), ref.page, static_cast<std::size_t>(ref.panel), ref.curve};
}

void PlotWindow::openFormulaDialog(const std::vector<ChannelRef>& channels) {
  if (documents_.empty()) return askForFile();
  std::vector<const PlotDocument*> files;
  for (const auto& document : documents_) files.push_back(document->own ? nullptr : document.get());
  auto* dialog = new FormulaDialog(
      files, [this](const ChannelRef& ref) { return formulaInputOf(ref); }, options_, this);
  dialog->setObjectName("formulaDialog");
  dialog->setModal(true);
  dialog->addChannels(channels);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { addFormula(dialog->channel()); });
  dialog->open();
}

void PlotWindow::askForFormula() { openFormulaDialog(channel_tree_->selected()); }

void PlotWindow::addFormula(const FormulaChannel& channel) {
  stopFollowingElement();
  formulas_.push_back(channel);
  int place = formulaDocumentIndex();
  if (place < 0) {
    addDocument(formula_document(formulas_), {}, false);
    place = fileCount() - 1;
  } else {
    static_cast<PlotDocument&>(*documents_[static_cast<std::size_t>(place)]) =
        formula_document(formulas_);
  }
  current_ = place;
  page_ = static_cast<int>(formulas_.size());
  fillTree();
}

}  // namespace adore::adrplot
