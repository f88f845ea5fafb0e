#pragma once

#include "adrinput/background.hpp"
#include "adrinput/evaluation.hpp"
#include "deck/deck.hpp"
#include "studies/accuracy.hpp"

#include <QWidget>

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace adore::adrinput {

/// The study of `adore accuracy` for the deck in the form: progress, table, and recommended
/// settings, which a button applies to the deck.
class AccuracyPanel : public QWidget {
  Q_OBJECT
 public:
  using Sets = std::vector<std::pair<std::string, std::string>>;
  explicit AccuracyPanel(QWidget* parent = nullptr);

  /// The study; studies::study_accuracy unless a test looks on.
  std::function<studies::AccuracyStudy(const studies::AccuracyRequest&,
                                       const studies::AccuracySink&, std::stop_token)>
      study;

  /// Studies the deck of the form, which has no errors.
  void start(const deck::Deck& deck, const RunOptionValues& options);
  /// The current deck: a study of an older one is marked as out of date.
  void setDeck(const deck::Deck& deck);
  /// Another deck was opened, or its file was reloaded: the recommendation is not for it.
  void invalidateResult(bool reread);
  /// What is stored beside the deck (stored_accuracy.hpp), shown while no study of the window is.
  void setStoredAccuracy(const QString& text);
  [[nodiscard]] bool busy() const { return background_task_.busy(); }
  [[nodiscard]] QString text() const;
  /// Recommended settings; empty before a study or without a recommendation.
  [[nodiscard]] const Sets& recommended() const { return recommended_settings_; }

 public slots:
  void cancel();

 signals:
  /// The button to start was pressed.
  void wanted();
  void finished();
  /// The recommended settings are to be put into the deck.
  void applyRequested();

 private:
  void showRow(const QString& line, const QString& round, double used);
  void show(const studies::AccuracyStudy& study, const QString& failure);
  void showNote();
  void enableButtons();

  QPushButton *start_, *cancel_, *apply_;
  QDoubleSpinBox *target_, *budget_, *revolutions_box_;
  QProgressBar* bar_;
  QLabel* note_;
  QPlainTextEdit* view_;
  BackgroundTask background_task_;
  deck::Deck studied_deck_;
  bool deck_replaced_ = false;  ///< since the study began a deck was opened, perhaps
  bool file_reloaded_ = false;  ///< of the same file
  bool stale_ = false;          ///< the deck is not the one that is studied
  Sets recommended_settings_;
  QString headline_, round_;
};

}  // namespace adore::adrinput
