#pragma once

#include "adrinput/background.hpp"
#include "design/design_summary.hpp"

#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <string>

class QTimer;

namespace adore::adrinput {

/// Computes the design summary of the current deck in the background: after a short pause without a
/// change, and only of the last deck. A computation for an older deck is canceled.
class DesignSolver : public QObject {
  Q_OBJECT
 public:
  struct Request {
    deck::Deck deck;
    std::map<std::string, std::string> options;
    bool operator==(const Request& other) const {
      return deck == other.deck && options == other.options;
    }
  };
  explicit DesignSolver(QObject* parent = nullptr);

  /// Called in the thread of this object: the summary, or the reason why there is none.
  std::function<void(std::optional<design::DesignSummary>, const QString& failure)> found;

  /// Nothing happens for the deck that is computed or being computed.
  void ask(Request request);
  /// No deck can be computed now: an open request is dropped.
  void cancel();
  /// Is a result on its way?
  [[nodiscard]] bool pending() const;

 private:
  void start();

  QTimer* delay_timer_;
  std::optional<Request> pending_request_;  ///< not started
  std::optional<Request> active_request_;   ///< active; nothing: canceled
  std::optional<Request> solved_request_;
  BackgroundTask background_task_;  ///< last: ends first
};

}  // namespace adore::adrinput
