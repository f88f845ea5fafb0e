#pragma once

#include "adrinput/background.hpp"
#include "adrinput/document.hpp"
#include "runs/rehearsal.hpp"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace adore::adrinput {

/// Finds out in the background whether `adore run` would begin with a deck, and why not.
class StartCheck : public QObject {
  Q_OBJECT
 public:
  explicit StartCheck(QObject* parent = nullptr) : QObject(parent) {}

  /// Called in the thread of this object with the deck of the last request.
  std::function<void(const Document::Candidate&, runs::DryRunResult)> found;

  /// An earlier question that is open is given up.
  void ask(Document::Candidate candidate);
  /// The running check is obsolete: files have changed since the request.
  void invalidateResult();
  [[nodiscard]] bool busy() const { return background_task_.busy(); }

 private:
  void start(Document::Candidate candidate);

  std::optional<Document::Candidate> running_candidate_;  ///< current request; none: idle
  std::optional<Document::Candidate> next_candidate_;
  BackgroundTask background_task_;
};

}  // namespace adore::adrinput
