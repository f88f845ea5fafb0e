#pragma once

#include "adrinput/solver_run.hpp"
#include "deck/deck.hpp"

#include <QStringList>
#include <QWidget>

#include <functional>

class QCheckBox;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace adore::adrinput {

/// The whole run of a saved deck: start, progress, cancel, what came out, and the way to the plots,
/// the animation and PRINT.txt.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(QWidget* parent = nullptr);

  /// Starts a viewer; desktop::start_program unless a test looks on.
  std::function<void(const QString& program, const QStringList& arguments)> launch;

  /// Runs the deck file, whose content is `deck`. Results go beside it.
  void start(const std::filesystem::path& file, const deck::Deck& deck);
  /// The deck is this one now: results of an older one say so.
  void setDeck(const deck::Deck& deck);
  [[nodiscard]] bool busy() const { return run_.busy(); }
  [[nodiscard]] QString text() const;

 public slots:
  void cancel();
  void openPlots();
  void openAnimation();
  void showListing();

 signals:
  /// The Run button was pressed.
  void wanted();
  void finished();

 private:
  void show(const facade::Progress& progress);
  void show(const RunEnd& end);
  void showNote();
  void enableButtons();
  void view(const QString& program, const QStringList& files);
  [[nodiscard]] QStringList plotFiles() const;
  [[nodiscard]] QString fileNamed(const QString& name) const;

  QPushButton *start_, *cancel_, *plots_, *animation_, *listing_;
  QCheckBox *plots_at_end_, *animation_at_end_;
  QProgressBar* bar_;
  QLabel* note_;
  QPlainTextEdit* view_;
  QString headline_;
  QStringList files_;
  deck::Deck computed_;
  bool stale_ = false;
  SolverRun run_;  ///< last: ends before the widgets that it reports to
};

}  // namespace adore::adrinput
