#include "agore/agore_window.hpp"
#include "agore/example_run.hpp"
#include "agore/scene_page.hpp"
#include "agore/solid_view.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <fstream>

/// The 3D scene as an HTML file.
using namespace adore;
using namespace adore::agore;
namespace fs = std::filesystem;

namespace {

QJsonObject data_of(const std::string& html) {
  const QByteArray page = QByteArray::fromStdString(html);
  const QByteArray begin = "id=\"data\">";
  const auto from = page.indexOf(begin) + begin.size(), to = page.indexOf("</script>", from);
  return QJsonDocument::fromJson(page.mid(from, to - from)).object();
}

template <class Number>
std::vector<Number> numbers(const QJsonValue& value) {
  const QByteArray bytes = QByteArray::fromBase64(value.toString().toLatin1());
  std::vector<Number> out(static_cast<std::size_t>(bytes.size()) / sizeof(Number));
  std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Number));
  return out;
}

/// Stands for three.js where the package is not installed.
fs::path stub(const testing::TemporaryFolder& folder) {
  const fs::path file = folder / "three.js";
  std::ofstream(file) << "var THREE = {end: '</script>'};\n";
  return file;
}

}  // namespace

TEST_CASE("scene page: every type → positions and pressures of the file in SI, no foreign address",
          "[gui][agore][slow]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  for (const std::string& type : test::kTypes) {
    INFO(type);
    const Animation animation = open_motion(test::example_run(type));
    ScenePageOptions options;
    options.view.exaggeration = 1.0;
    const ScenePage page = scene_page(animation, options, stub(folder));
    const ScenePageSize size = scene_page_size(animation, options);
    CHECK(page.frames == size.frames);
    CHECK(page.every == size.every);
    for (const char* address : {"src=", "http://", "https://", "@import", "{{"})
      CHECK(page.html.find(address) == std::string::npos);
    CHECK(page.html.find("MIT License") != std::string::npos);
    const QJsonObject data = data_of(page.html);
    const auto time = numbers<double>(data["time"]);
    REQUIRE(time.size() == page.frames);
    CHECK(time.back() == animation.time[(page.frames - 1) * static_cast<std::size_t>(page.every)]);
    const auto n = static_cast<std::size_t>(data["elements"].toInt());
    REQUIRE(n == static_cast<std::size_t>(animation.file.elements));
    const auto parts = static_cast<std::size_t>(data["cage"].toArray().size());
    const auto bodies = numbers<float>(data["bodies"]);
    REQUIRE(bodies.size() == page.frames * (8 + 7 * parts + 7 * n));
    const auto contacts = numbers<float>(data["contacts"]);
    const auto quantities = static_cast<std::size_t>(data["quantities"].toArray().size());
    REQUIRE(contacts.size() == page.frames * n * 2 * quantities);
    const std::size_t last = page.frames - 1, frame = last * static_cast<std::size_t>(page.every);
    for (std::size_t k = 0; k < n; ++k) {
      const float* at = &bodies[last * (8 + 7 * parts + 7 * n) + 8 + 7 * parts + 7 * k];
      const QPointF centre = element_centre(animation, frame, 1.0, k);
      if (animation.file.bearing_type == 1) {
        CHECK(at[1] == Approx(centre.x()).margin(1e-7));
        CHECK(at[2] == Approx(centre.y()).margin(1e-7));
      }
      CHECK(std::hypot(at[3], at[4]) <= 1.0F + 1e-6F);
      CHECK(at[3] * at[3] + at[4] * at[4] + at[5] * at[5] + at[6] * at[6] == Approx(1.0));
      for (const std::size_t race : {0U, 1U}) {
        const float* of = &contacts[((last * n + k) * 2 + race) * quantities];
        CHECK(of[0] == Approx(animation.value("contact.load", frame, 2 * k + race)));
        CHECK(of[1] == Approx(animation.value("contact.pressure", frame, 2 * k + race)));
      }
    }
    CHECK(data["quantities"].toArray()[1].toObject()["unit"] == "Pa");
  }
}

TEST_CASE("scene page: range, interval and size → as stated before", "[gui][agore][slow]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  const Animation animation = open_motion(test::example_run("ball"));
  ScenePageOptions options;
  options.first = 3, options.last = 20, options.every = 5;
  const ScenePage page = scene_page(animation, options, stub(folder));
  CHECK(page.frames == 4);
  const auto time = numbers<double>(data_of(page.html)["time"]);
  CHECK(time.front() == animation.time[2]);
  CHECK(time.back() == animation.time[17]);
  const ScenePageSize size = scene_page_size(animation, options);
  CHECK(size.bytes > 0.87e6);
  options.first = 30, options.last = 20;
  CHECK_THROWS_WITH(scene_page(animation, options, stub(folder)), Catch::Contains("frames 1 to"));
  CHECK_THROWS_WITH(scene_page(animation, {}, folder / "missing.js"),
                    Catch::Contains("libjs-three"));
  CHECK_THROWS_WITH(write_scene_page(animation, {}, folder / "scene.mp4", true),
                    Catch::Contains(".html"));
  CHECK_THROWS_AS(scene_page(prepare(test::synthetic_sol8()), {}, stub(folder)), InputError);
}

TEST_CASE("scene page: headless Chromium → it draws, and a link opens it at a frame",
          "[gui][agore][slow]") {
  test::use_qt();
  const QString chromium = QStandardPaths::findExecutable("chromium");
  if (chromium.isEmpty() || !is_threejs_installed()) {
    WARN("skipped: chromium or libjs-three is not installed (./setup.sh --tests)");
    return;
  }
  const testing::TemporaryFolder folder;
  const Animation animation = open_motion(test::example_run("ball"));
  const ScenePage page = write_scene_page(animation, {}, folder / "scene.html", true);
  QProcess browser;
  browser.start(
      chromium,
      {"--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader",
       "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--timeout=60000",
       "--user-data-dir=" + QString::fromStdString((folder / "profile").string()), "--dump-dom",
       "file://" + QString::fromStdString((folder / "scene.html").string()) + "#frame=7"});
  REQUIRE(browser.waitForFinished(180000));
  const QString dom = QString::fromUtf8(browser.readAllStandardOutput());
  const auto body = dom.mid(dom.indexOf("<body"), 200);
  INFO(body.toStdString());
  CHECK(body.contains("data-state=\"ready\""));
  CHECK(body.contains("data-frame=\"7\""));
  CHECK(body.contains(QString("data-frames=\"%1\"").arg(page.frames)));
  CHECK(dom.contains("frame 7 of"));
}
