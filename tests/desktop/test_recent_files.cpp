#include "desktop/chrome.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::desktop;

TEST_CASE("recent files: the newest first, each once, those that are gone left out", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QSettings("Adore", "recent-test").clear();
  for (const char* name : {"a", "b", "c"}) {
    QFile file(folder.filePath(name));
    REQUIRE(file.open(QIODevice::WriteOnly));
    remember_file("recent-test", folder.filePath(name));
  }
  remember_file("recent-test", folder.filePath("a"));
  CHECK(recent_files("recent-test") ==
        QStringList{folder.filePath("a"), folder.filePath("c"), folder.filePath("b")});
  QFile::remove(folder.filePath("c"));
  CHECK(recent_files("recent-test").size() == 2);
  // A folder is one entry, however many of its files are opened; none where nothing was.
  remember_as_folder("recent-test", folder.path(), [&] {
    for (const char* name : {"b", "a", "b"}) remember_file("recent-test", folder.filePath(name));
  });
  const QStringList one{folder.path(), folder.filePath("a"), folder.filePath("b")};
  CHECK(recent_files("recent-test") == one);
  remember_as_folder("recent-test", "/", [] {});
  CHECK(recent_files("recent-test") == one);
  QSettings("Adore", "recent-test").clear();
}

TEST_CASE("recent files: the files of one run do not take the places of others", "[gui]") {
  test::use_qt();
  QTemporaryDir folder, other;
  QSettings("Adore", "recent-test").clear();
  const auto open = [](const QString& path) {
    QFile file(path);
    REQUIRE(file.open(QIODevice::WriteOnly));
    add_recent_run_file("recent-test", path);
  };
  open(other.filePath("SOL1"));
  for (int i = 1; i <= 8; ++i) open(folder.filePath(QString("SOL%1").arg(i)));
  CHECK(recent_files("recent-test") == QStringList{folder.filePath("SOL8"), folder.filePath("SOL7"),
                                                   folder.filePath("SOL6"),
                                                   other.filePath("SOL1")});
  QSettings("Adore", "recent-test").clear();
}
