#include "desktop/run_link.hpp"
#include "desktop/user_socket.hpp"
#include "support/qt_app.hpp"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

/// Links between windows of one run, in one program and in two.
using namespace adore;
using desktop::LinkState;
using desktop::RunLink;

namespace {

constexpr int kPatience = 10000;  // [ms] of a busy machine
constexpr int kQuiet = 300;       // [ms] in which nothing may arrive

/// A window: its link, and the changes that it received.
struct Window {
  explicit Window(const QString& folder) {
    QObject::connect(&link, &RunLink::told, &link,
                     [this](const LinkState& change) { told.push_back(change); });
    link.join(folder);
  }
  RunLink link{nullptr};
  std::vector<LinkState> told;
  [[nodiscard]] bool knows(double time) {
    return QTest::qWaitFor([&] { return !told.empty() && told.back().time == time; }, kPatience);
  }
  [[nodiscard]] bool joins() {
    return QTest::qWaitFor([&] { return link.isJoined(); }, kPatience);
  }
};

/// A variable of the environment for the time of a test.
class Environment {
 public:
  Environment(const char* name, const QByteArray& value) : name_(name), before_(qgetenv(name)) {
    qputenv(name, value);
  }
  ~Environment() { before_.isNull() ? qunsetenv(name_) : qputenv(name_, before_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  QByteArray before_;
};

/// Not a window: bytes of any program.
void write_bytes(const QString& folder, const QByteArray& bytes) {
  QLocalSocket socket;
  socket.connectToServer(RunLink::socketPath(folder));
  REQUIRE(socket.waitForConnected(kPatience));
  socket.write(bytes);
  socket.flush();
  QTest::qWait(kQuiet / 3);
}

}  // namespace

TEST_CASE("link_message: written message → read as the same state", "[unit][desktop]") {
  for (const desktop::LinkMessage& state :
       {desktop::LinkMessage{{0.1, {}}, 0}, {{{}, 12}, 1}, {{1.0 / 3.0 * 1e-9, 1}, 123456}}) {
    const QByteArray line = desktop::link_message(state);
    CHECK(line.endsWith('\n'));
    CHECK(line.size() <= desktop::kLongestMessage);
    CHECK(desktop::read_link_message(line) == state);
  }
}

TEST_CASE("link_message: anything else → ignored", "[unit][desktop]") {
  for (const QByteArray& line :
       {QByteArray(),
        QByteArray("\n"),
        QByteArray("time 3\n"),
        QByteArray("{\"time\": 3}\n"),
        QByteArray("[1, 2]\n"),
        QByteArray("{\"adore-link\": 2, \"time\": 3}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1}\n"),
        QByteArray("{\"adore-link\": 1, \"time\": 3}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": -1, \"time\": 3}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1e300, \"time\": 3}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"time\": \"3\"}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"time\": 1e999}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"time\": null}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"element\": 0}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"element\": -1}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"element\": 2.5}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"element\": 1e9}\n"),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"time\": 3, \"element\": []}\n"),
        QByteArray(1000, '{'),
        QByteArray("{\"adore-link\": 1, \"action\": 1, \"time\": 3" + QByteArray(300, ' ') +
                   "}\n")}) {
    INFO(line.left(60).toStdString());
    CHECK_FALSE(desktop::read_link_message(line).has_value());
  }
}

TEST_CASE("run_link: a change → told once to each other window, never back", "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder, other;
  Window a(folder.path()), b(folder.path() + "/."), c(folder.path()), elsewhere(other.path());
  REQUIRE((a.joins() && b.joins() && c.joins() && elsewhere.joins()));
  CHECK(a.link.isHub());
  CHECK_FALSE(b.link.isHub());
  b.link.tell({0.25, {}});  // through the hub
  CHECK((a.knows(0.25) && c.knows(0.25)));
  a.link.tell({0.5, 3});
  CHECK((b.knows(0.5) && c.knows(0.5)));
  CHECK(b.told.back().element == 3);
  QTest::qWait(kQuiet);
  CHECK(a.told.size() == 1);
  CHECK(b.told.size() == 1);
  CHECK(c.told.size() == 2);
  CHECK(elsewhere.told.empty());
  // A window that opens later.
  Window late(folder.path());
  CHECK(late.knows(0.5));
  CHECK(late.told.back().element == 3);
  // Another run is shown: the window leaves.
  c.link.join(other.path());
  elsewhere.link.tell({7.0, {}});
  CHECK(c.knows(7.0));
  b.link.tell({0.75, {}});
  CHECK(a.knows(0.75));
  CHECK(c.told.back().time == 7.0);
}

TEST_CASE("run_link: many changes in quick succession → few messages, the last one arrives",
          "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  Window a(folder.path()), b(folder.path());
  REQUIRE((a.joins() && b.joins()));
  for (int i = 1; i <= 1000; ++i) b.link.tell({1e-3 * i, {}});
  CHECK(a.knows(1.0));
  CHECK(a.told.size() <= 3);
}

TEST_CASE("run_link: frames of a playing animation → an action in another window wins",
          "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  Window a(folder.path()), b(folder.path()), c(folder.path());
  REQUIRE((a.joins() && b.joins() && c.joins()));
  const bool hub_plays = GENERATE(false, true);
  Window &player = hub_plays ? a : b, &user = hub_plays ? b : a;
  player.link.tell({0.1, {}});
  REQUIRE((user.knows(0.1) && c.knows(0.1)));
  // None has received the change of the other when it sends its own.
  user.link.tell({0.9, {}});
  player.link.tell({0.2, {}}, RunLink::Cause::Playing);
  CHECK((player.knows(0.9) && c.knows(0.9)));
  QTest::qWait(kQuiet);
  CHECK(user.told.back().time == 0.1);
  CHECK(player.told.back().time == 0.9);
  CHECK(c.told.back().time == 0.9);
  player.link.tell({0.3, {}}, RunLink::Cause::Playing);  // the window plays again
  CHECK((user.knows(0.3) && c.knows(0.3)));
}

TEST_CASE("run_link: the hub closes or is switched off → the others stay linked",
          "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  auto hub = std::make_unique<Window>(folder.path());
  std::vector<std::unique_ptr<Window>> windows;
  for (int i = 0; i < 5; ++i) windows.push_back(std::make_unique<Window>(folder.path()));
  for (auto& window : windows) REQUIRE(window->joins());
  hub.reset();
  // A new window receives the state as soon as there is a hub again.
  const auto linked_again = [&](double time) {
    return QTest::qWaitFor(
        [&] {
          windows.back()->link.tell({time, {}});
          QTest::qWait(50);
          return std::all_of(windows.begin(), windows.end() - 1, [&](const auto& window) {
            return !window->link.isActive() ||
                   (!window->told.empty() && window->told.back().time == time);
          });
        },
        kPatience);
  };
  CHECK(linked_again(0.1));
  for (auto& window : windows)
    if (window->link.isHub() && window != windows.back()) {
      window->link.setActive(false);
      const std::size_t before = window->told.size();
      CHECK(linked_again(0.2));
      CHECK(window->told.size() == before);
      window->link.setActive(true);
      CHECK(window->knows(0.2));
      break;
    }
}

TEST_CASE("run_link: socket of a program that was cut off → replaced", "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  const QString path = RunLink::socketPath(folder.path());
  REQUIRE_FALSE(path.isEmpty());
  {
    QFile left(path);
    REQUIRE(left.open(QIODevice::WriteOnly));
    QFile lock(path + ".lock");
    REQUIRE(lock.open(QIODevice::WriteOnly));
  }
  Window a(folder.path()), b(folder.path());
  CHECK(a.joins());
  CHECK(b.joins());
  b.link.tell({2.0, {}});
  CHECK(a.knows(2.0));
}

TEST_CASE("run_link: bytes of a foreign program → ignored, windows stay linked", "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  Window a(folder.path()), b(folder.path());
  REQUIRE((a.joins() && b.joins()));
  write_bytes(folder.path(), "GET / HTTP/1.1\r\n\r\n\n\n");
  write_bytes(folder.path(), QByteArray(3'000'000, 'x'));  // a line without end
  write_bytes(folder.path(),
              QByteArray(500, '\0') + "\n{\"adore-link\": 1, \"action\": 1, \"time\": nan}\n");
  write_bytes(folder.path(),
              "{\"adore-link\": 1, \"action\": 1, \"element\": 4}");  // without its end
  QByteArray nested(200, '[');
  write_bytes(folder.path(), nested + "\n");
  CHECK(a.told.empty());
  CHECK(b.told.empty());
  b.link.tell({3.0, {}});
  CHECK(a.knows(3.0));
  // Connections that do nothing do not keep windows out.
  std::vector<std::unique_ptr<QLocalSocket>> idle;
  for (int i = 0; i < 40; ++i) {
    idle.push_back(std::make_unique<QLocalSocket>());
    idle.back()->connectToServer(RunLink::socketPath(folder.path()));
  }
  Window late(folder.path());
  CHECK(late.knows(3.0));
}

TEST_CASE("run_link: no run folder → nothing is shared", "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir base;
  CHECK(RunLink::socketPath({}).isEmpty());
  CHECK(RunLink::socketPath(base.filePath("none")).isEmpty());
  Window a(base.filePath("none")), b({});
  a.link.tell({1.0, {}});
  b.link.tell({2.0, {}});
  QTest::qWait(kQuiet);
  CHECK_FALSE(a.link.isJoined());
  CHECK_FALSE(b.link.isJoined());
  CHECK(b.told.empty());
}

TEST_CASE("user_socket: folder that others can read → not used", "[unit][desktop]") {
  const QTemporaryDir base;
  const Environment runtime("XDG_RUNTIME_DIR", base.path().toLocal8Bit());
  CHECK(desktop::user_socket("one") == base.path() + "/one");
  QFile::setPermissions(base.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner |
                                         QFile::ReadOther | QFile::ExeOther);
  CHECK_FALSE(desktop::user_socket("one").startsWith(base.path() + "/one"));
  CHECK(desktop::user_socket(QString(200, 'n')).isEmpty());  // longer than an address
}

/// The other program of the next test: follows the link until it is ended.
TEST_CASE("run_link peer", "[.][peer]") {
  test::use_qt();
  const QString folder = qEnvironmentVariable("ADORE_TEST_LINK");
  if (folder.isEmpty()) return;
  Window window(folder);
  REQUIRE(window.joins());
  // Answers each time with its double.
  QObject::connect(&window.link, &RunLink::told, &window.link, [&](const LinkState& change) {
    if (change.time) window.link.tell({2.0 * *change.time, 5});
  });
  if (!window.link.isHub())
    REQUIRE(QTest::qWaitFor([&] { return !window.link.state().empty(); }, kPatience));
  window.link.tell({window.link.isHub() ? 100.0 : 200.0, {}});
  QTest::qWait(60000);
}

TEST_CASE("run_link: another program → linked, also when it is killed while it is the hub",
          "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder, runtime;  // each test process has its own temporary files
  const Environment shared("XDG_RUNTIME_DIR", runtime.path().toLocal8Bit());
  const auto start = [&](QProcess& process) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("ADORE_TEST_LINK", folder.path());
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    process.setProcessEnvironment(environment);
    process.start(QFile::symLinkTarget("/proc/self/exe"), {"[peer]"});
    REQUIRE(process.waitForStarted());
  };
  QProcess first;
  start(first);
  REQUIRE(QTest::qWaitFor([&] { return QFile::exists(RunLink::socketPath(folder.path())); },
                          3 * kPatience));
  Window window(folder.path());
  CHECK(window.knows(100.0));  // the other one is the hub
  window.link.tell({3.0, {}});
  CHECK(window.knows(6.0));
  CHECK(window.told.back().element == 5);
  first.kill();
  REQUIRE(first.waitForFinished());
  CHECK(QTest::qWaitFor([&] { return window.link.isHub(); }, kPatience));
  QProcess second;
  start(second);
  CHECK(window.knows(200.0));
  window.link.tell({4.0, {}});
  CHECK(window.knows(8.0));
  second.kill();
  second.waitForFinished();
}

TEST_CASE("run_link: action while the hub ends → known to all windows afterwards",
          "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  Window hub(folder.path()), a(folder.path()), b(folder.path());
  REQUIRE((hub.joins() && a.joins() && b.joins()));
  REQUIRE(hub.link.isHub());
  hub.link.tell({1.0, {}});
  REQUIRE((a.knows(1.0) && b.knows(1.0)));
  hub.link.setActive(false);
  b.link.tell({2.0, 7});  // it does not know yet that its hub has ended
  CHECK(a.knows(2.0));
  CHECK(a.told.back().element == 7);
  hub.link.setActive(true);
  CHECK(hub.knows(2.0));
  CHECK(b.link.state() == LinkState{2.0, 7});
}
