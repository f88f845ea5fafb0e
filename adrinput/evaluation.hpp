#pragma once

#include "adrinput/background.hpp"
#include "base/finding.hpp"
#include "deck/deck.hpp"
#include "results/static_tables.hpp"

#include <QWidget>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPlainTextEdit;

namespace adore::desktop {
class FindingsBar;
}

namespace adore::adrinput {

using RunOptionValues = std::map<std::string, std::string>;

struct Evaluation {
  std::string headline;  ///< key results in one sentence, or empty
  std::string text;
  std::optional<results::StaticTables> tables = std::nullopt;  ///< of a quasi-static solution
  std::vector<Finding> findings = {};
};

/// Plan of this deck; its quasi-static equilibrium as in PRINT.txt. Both throw InputError or
/// SolverError with the reason. `path` is for messages only.
[[nodiscard]] Evaluation evaluate_plan(const deck::Deck& deck, const std::filesystem::path& path,
                                       const RunOptionValues& options);
[[nodiscard]] Evaluation evaluate_quasi_static(const deck::Deck& deck,
                                               const std::filesystem::path& path,
                                               const RunOptionValues& options);

/// Runs one of them in the background and shows its text, or the reason for its failure. A text of
/// an older deck is marked as out of date.
class EvaluationPanel : public QWidget {
  Q_OBJECT
 public:
  using Function = Evaluation (*)(const deck::Deck&, const std::filesystem::path&,
                                  const RunOptionValues&);
  EvaluationPanel(Function function, const QString& invitation, QWidget* parent = nullptr);
  /// Accessible name of its text.
  void setTextAccessibleName(const QString& name);

  void start(const deck::Deck& deck, const std::filesystem::path& path,
             const RunOptionValues& options);
  /// Another deck was opened: earlier results do not belong to it.
  void invalidateResult();
  /// The deck is this one now.
  void setDeck(const deck::Deck& deck, const RunOptionValues& options);
  [[nodiscard]] QString headline() const;
  [[nodiscard]] bool busy() const { return background_task_.busy(); }
  [[nodiscard]] QString text() const;
  /// Tables of the last result; nullptr: none.
  [[nodiscard]] const results::StaticTables* tables() const {
    return tables_ ? &*tables_ : nullptr;
  }
  [[nodiscard]] bool stale() const { return stale_; }

 signals:
  void finished();
  void findingChosen(const adore::Finding& finding);

 private:
  void showNote();
  void show(const Evaluation& result, bool failed);

  Function function_;
  QString initial_note_;
  QLabel* note_;
  desktop::FindingsBar* findings_;
  QPlainTextEdit* view_;
  BackgroundTask background_task_;
  deck::Deck evaluated_deck_;
  RunOptionValues evaluated_options_;
  QString headline_;
  std::optional<results::StaticTables> tables_;
  bool stale_ = false;
  bool deck_replaced_ = false;  ///< the running computation is for a previous deck
};

}  // namespace adore::adrinput
