#include "agore/agore_window.hpp"
#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/shown_window.hpp"
#include "agore/view_scene.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <catch2/catch.hpp>

#include <cmath>

/// A run that was killed, or still runs: RESULTS.h5 ends before SOL8.
using namespace adore;
using namespace adore::agore;

namespace {

constexpr std::size_t kFrames = 31;

/// SOL8 has all frames, RESULTS.h5 ends with the step `last`.
void write_cut(const testing::TemporaryFolder& folder, long last) {
  test::write_run(folder);
  test::write_text(folder / "SOL8",
                   test::sol8_text(results::MotionFile::open(folder / "RESULTS.h5").frames()));
  std::filesystem::remove(folder / "RESULTS.h5");
  test::write_run(folder, last);
}

}  // namespace

TEST_CASE("frames after the end of RESULTS.h5: taken from SOL8 with a note", "[gui][h5]") {
  test::use_qt();
  for (const long last : {16L, 20L, 29L, 30L}) {
    const testing::TemporaryFolder folder;
    write_cut(folder, last);
    const Animation a = open_motion(folder / "SOL8");
    INFO("to step " << last << ": " << a.source << a.no_contacts);
    REQUIRE(a.motion);
    REQUIRE(a.frames() == kFrames);
    const auto exact = static_cast<std::size_t>(last) + 1;
    const std::string words = "frames from " + std::to_string(exact + 1) + " on are only in SOL8";
    CHECK((a.source.find(words) != std::string::npos) == (exact < kFrames));
    const results::Sol8File sol8 = results::read_sol8(folder / "SOL8");
    MotionPicture picture(a);
    for (std::size_t i = 0; i < kFrames; ++i) {
      const bool behind = i >= exact;
      CHECK(a.behind(i) == behind);
      CHECK((a.contacts_at(i) == nullptr) == behind);
      CHECK(std::isnan(a.value("contact.load", i, 0)) == behind);
      if (behind) CHECK(a.frame(i).elements[2].theta == sol8.frames[i].elements[2].theta);
      CHECK((element_colors(a, i, ColourBy::Load).why_none == "no colors: " + words) == behind);
      ViewOptions options;
      options.contacts = true;
      for (const View view : {View::Bearing, View::Element, View::Section, View::Solid}) {
        options.view = view;
        const QString svg = QString::fromUtf8(picture.svg({900, 700}, i, options));
        INFO(view_title(view) << ", frame " << i + 1);
        CHECK(svg.contains(QString::fromStdString("loads: " + words)) == behind);
        CHECK(svg.contains("from SOL8 only   ·   frame") == behind);
      }
      if (i > 1 && i + 2 < exact) i = exact - 2;  // a few of them are enough
    }
  }
}

TEST_CASE("curves after the end of RESULTS.h5 → values of SOL8, or end", "[gui][h5]") {
  const testing::TemporaryFolder folder;
  write_cut(folder, 19);
  const Animation a = open_motion(folder / "SOL8");
  REQUIRE(a.frames() == kFrames);
  const results::Sol8File sol8 = results::read_sol8(folder / "SOL8");
  const auto goes_on = [&](const History& history, auto value) {
    REQUIRE(history.time.size() == kFrames);
    REQUIRE(history.value.size() == kFrames);
    for (std::size_t i = 20; i < kFrames; ++i) {
      CHECK(history.time[i] == sol8.frames[i].time);
      CHECK(history.value[i] == Approx(value(sol8.frames[i])).epsilon(0.05));
    }
  };
  goes_on(land_force(a, 1), [](const auto& frame) { return frame.land_force[1]; });
  goes_on(pocket_force(a, 3), [](const auto& frame) { return frame.elements[3].pocket_force; });
  goes_on(race_position(a, 1, 1), [](const auto& frame) { return frame.races[1].position[1]; });
  const History load = contact_load(a, 2, 0);
  REQUIRE(load.value.size() == kFrames);
  for (std::size_t i = 0; i < kFrames; ++i) CHECK(std::isnan(load.value[i]) == (i >= 20));
  ViewOptions options;
  options.view = View::Section;
  const desktop::ChartPage page = data_page(a, options);
  REQUIRE(page.marks.size() == 1);
  CHECK(page.marks[0].x == Approx(a.time[19]));
  CHECK(page.x.back() == a.time.back());
}

TEST_CASE("frames after the end of RESULTS.h5: truncated SOL8 → complete frames only", "[h5]") {
  const testing::TemporaryFolder folder;
  write_cut(folder, 25);
  const std::string text = testing::read_bytes(folder / "SOL8");
  const results::Sol8File whole = results::read_sol8(folder / "SOL8");
  for (std::size_t less = 1; less < text.size() / 8; less += 37) {
    test::write_text(folder / "SOL8", text.substr(0, text.size() - less));
    const Animation a = open_motion(folder / "SOL8");
    CAPTURE(less);
    REQUIRE(a.frames() >= 26);
    for (std::size_t i = 26; i < a.frames(); ++i) {
      CHECK(a.frame(i).time == whole.frames[i].time);
      CHECK(a.frame(i).races[1].angles == whole.frames[i].races[1].angles);
    }
  }
}

TEST_CASE("RESULTS.h5 that does not belong to SOL8 → not used, reason given", "[gui][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  write_cut(folder, 30);
  const auto path = folder / "RESULTS.h5";
  const auto told = [&] {
    const Animation a = open_motion(folder / "SOL8");
    CHECK((a.source.find("RESULTS.h5 is not used") != std::string::npos) == !a.unused.empty());
    CHECK(a.unused.empty() == (a.motion || !std::filesystem::exists(path)));
    AgoreWindow window;
    window.show();
    REQUIRE(window.openFile(folder / "SOL8"));
    const QString message = test::take_message(window);
    INFO(message.toStdString());
    CHECK(message.contains("RESULTS.h5 is not used: " + QString::fromStdString(a.unused)) ==
          !a.unused.empty());
    return a.unused;
  };
  CHECK(told().empty());
  const auto size = std::filesystem::file_size(path);
  for (const auto part : {size / 2, size / 10, std::uintmax_t{100}, std::uintmax_t{0}}) {
    std::filesystem::resize_file(path, part);
    INFO("cut after " << part);
    CHECK_FALSE(told().empty());
  }
  std::filesystem::remove(path);
  CHECK(told().empty());
  test::write_run(folder, 8);  // almost nothing of SOL8
  CHECK_FALSE(told().empty());
}
