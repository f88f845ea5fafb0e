#pragma once

#include "desktop/instance_lock.hpp"

#include <QObject>
#include <QString>

#include <filesystem>
#include <optional>
#include <vector>

class QTimer;

namespace adore::adrinput {

class DeckWindow;

/// State that survives a crash: the deck being typed, stored shortly after each change, and the
/// page of the user.
class Session : public QObject {
  Q_OBJECT
 public:
  /// `folder` contains the unsaved decks of all running programs, one file each.
  explicit Session(DeckWindow& window, const QString& folder = defaultFolder());
  /// After an orderly end nothing stays behind.
  ~Session() override;

  [[nodiscard]] static QString defaultFolder();

  /// Size and position of the window; the deck and page of the last session unless the user named a
  /// deck; and the question about decks that an interrupted program left.
  void begin(bool deck_named);
  /// Asks about the first unsaved deck of earlier sessions; reports if there is none.
  void offerUnsaved();
  /// Stores unsaved changes now.
  void store();
  /// File of the unsaved deck of this window.
  [[nodiscard]] std::filesystem::path file() const { return file_; }

 private:
  struct Orphan {
    std::filesystem::path file;
    desktop::InstanceLock lock;
  };
  void lookForOrphans();
  bool offerNextOrphan();
  void restore();
  void deleteOrphan(const Orphan& orphan);
  void saveWindowState();
  void reopenLastDeck();

  DeckWindow& window_;
  std::filesystem::path folder_, file_;
  std::optional<desktop::InstanceLock> lock_;  ///< nothing: nothing can be stored
  std::vector<Orphan> orphans_;                ///< unanswered questions; the first one is shown
  QTimer* store_timer_;
  bool storing_failed_ = false;
};

}  // namespace adore::adrinput
