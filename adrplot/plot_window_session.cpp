#include "adrplot/channel_tree.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/session.hpp"
#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/window_place.hpp"

#include <QComboBox>
#include <QFileDialog>
#include <QProgressDialog>
#include <QTreeWidget>

#include <algorithm>
#include <exception>

/// The window as a session file, and back.
namespace adore::adrplot {
namespace {

constexpr int kFormulas = -1, kUnknown = -2;

std::string name_of_pick(const CurvePick& pick, const PageOptions& options) {
  PageOptions history = options;
  history.domain = Domain::History;
  const desktop::ChartPage page = pick.file->build(pick.page, history);
  return page.panels.at(pick.panel).curves.at(pick.curve).name;
}

}  // namespace

int PlotWindow::sessionNumber(const PlotDocument& file) const {
  int number = 0;
  for (const auto& document : documents_) {
    if (document->on_disk && document->path == file.path) return number;
    number += document->on_disk ? 1 : 0;
  }
  return file.path == "formulas" ? kFormulas : kUnknown;
}

bool PlotWindow::saveSession(const QString& path) {
  try {
    Session session;
    for (const auto& document : documents_)
      if (document->on_disk) session.files.push_back({document->path, document->range});
    for (const FormulaChannel& formula : formulas_) {
      SessionFormula& one = session.formulas.emplace_back(
          SessionFormula{formula.title, formula.formula, formula.unit, {}});
      for (const FormulaInput& input : formula.inputs)
        one.inputs.push_back(
            {sessionNumber(*input.file), input.page, input.panel, input.curve, -1, input.name});
    }
    for (const auto& document : documents_) {
      if (!document->own) continue;
      SessionChart& chart = session.charts.emplace_back(SessionChart{document->own->how, {}});
      for (const CurvePick& pick : document->own->curves)
        chart.curves.push_back({sessionNumber(*pick.file), pick.page, pick.panel,
                                name_of_pick(pick, options_), pick.group, ""});
    }
    session.view = options_;
    session.log_x = log_x_;
    session.log_y = log_y_;
    // In the order in which they are opened again.
    const auto rank = [](const Document& one) { return one.on_disk ? 0 : one.own ? 2 : 1; };
    int before = 0;
    for (int d = 0; d < fileCount(); ++d) {
      const Document* one = documents_[static_cast<std::size_t>(d)].get();
      if (current_ >= 0 &&
          (rank(*one) < rank(*document()) || (rank(*one) == rank(*document()) && d < current_)))
        ++before;
    }
    session.document = before;
    session.page = std::max(1, page_);
    save_session(session, path.toStdString());
    desktop::add_recent_run_file(kApp, path);
    desktop::show_in_status_bar(this, tr("Saved %1.").arg(path));
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

bool PlotWindow::openSession(const QString& path) {
  Session session;
  try {
    session = read_session(path.toStdString());
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  QStringList missing;
  std::vector<int> place;  // of each file among the documents; -1: not opened
  const int first = fileCount();
  for (const SessionFile& file : session.files) {
    try {
      addDocument(open_document(file.path, file.range, kMostValues,
                                [this](double part) { return showReadingProgress(part); }),
                  file.range);
      place.push_back(fileCount() - 1);
    } catch (const std::exception& error) {
      reading_progress_dialog_.reset();
      missing << QString::fromUtf8(error.what());
      place.push_back(-1);
    }
  }
  const auto document_at = [&](int file) -> int {
    if (file == kFormulas) return formulaDocumentIndex();
    return file >= 0 && file < static_cast<int>(place.size())
               ? place[static_cast<std::size_t>(file)]
               : -1;
  };
  for (const SessionFormula& formula : session.formulas) {
    FormulaChannel channel{formula.title, formula.formula, formula.unit, {}};
    bool complete = true;
    for (const SessionCurve& input : formula.inputs) {
      const int at = document_at(input.file);
      complete =
          complete && at >= 0 && input.page >= 1 &&
          input.page <= static_cast<int>(documents_[static_cast<std::size_t>(at)]->pages.size());
      if (complete)
        channel.inputs.push_back(
            {input.name, copyDocument(at), input.page, input.panel, input.curve});
    }
    if (complete)
      addFormula(channel);
    else
      missing << tr("Formula \"%1\": a file with one of its channels is missing")
                     .arg(QString::fromStdString(formula.title));
  }
  options_ = session.view;
  log_x_ = session.log_x;
  log_y_ = session.log_y;
  int lost = 0;
  for (const SessionChart& chart : session.charts) {
    auto own = std::make_shared<UserChart>();
    own->how = chart.how;
    for (const SessionCurve& curve : chart.curves) {
      try {
        const int at = document_at(curve.file);
        if (at < 0) throw InputError("missing");
        CurvePick pick = curvePickOf({at, curve.page, static_cast<int>(curve.panel), curve.curve});
        pick.group = curve.group;
        own->add(pick);
      } catch (const std::exception&) {
        ++lost;
      }
    }
    if (!own->curves.empty()) addUserChart(std::move(own));
  }
  if (lost > 0)
    missing << tr("%1 left out of the charts because files or pages are missing")
                   .arg(lost == 1 ? tr("1 curve") : tr("%1 curves").arg(lost));
  {
    const QSignalBlocker quiet_a(abscissa_), quiet_d(domain_);
    abscissa_->setCurrentIndex(static_cast<int>(options_.abscissa));
    domain_->setCurrentIndex(static_cast<int>(options_.domain));
  }
  setSpectrum(options_.spectrum);
  if (fileCount() > first) {
    current_ = std::clamp(first + session.document, 0, fileCount() - 1);
    page_ = std::clamp(session.page, 1, std::max(1, pageCount()));
    fillTree();
  }
  desktop::add_recent_run_file(kApp, path);
  if (!missing.isEmpty())
    desktop::show_message(this, tr("The session was opened without:\n%1").arg(missing.join('\n')),
                          true);
  return true;
}

void PlotWindow::askForSession(bool save) {
  auto* dialog = new QFileDialog(this, save ? tr("Save session") : tr("Open session"), QString(),
                                 tr("Sessions of AdrPlot (*.adrplot)"));
  dialog->setObjectName("session");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog->setDefaultSuffix("adrplot");
  connect(dialog, &QFileDialog::fileSelected, this, [this, save](const QString& path) {
    if (save)
      saveSession(path);
    else
      openSession(path);
  });
  dialog->open();
}

}  // namespace adore::adrplot
