#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/shown_window.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <string>

/// Values that are not finite, from stars or damage, in files that are otherwise complete.
using namespace adore;
using namespace adore::agore;

namespace {

std::string warnings;  ///< messages of Qt about the drawing

/// Everything of two frames that can be drawn.
void draw_all(const Animation& animation, std::size_t frame) {
  MotionPicture picture(animation);
  for (int view = 0; view <= static_cast<int>(View::Solid); ++view)
    for (const std::size_t at : {frame, frame + 1}) {
      ViewOptions options;
      options.view = static_cast<View>(view);
      if (!why_not(options.view, animation).empty()) break;
      options.element = 3;
      options.trails = true;
      options.contacts = true;
      options.colour = ColourBy::Load;
      (void)picture.image({360, 240}, at, options);
    }
}

/// Keeps them while it lives.
class Watched {
 public:
  Watched() : before_(qInstallMessageHandler(keep)) { warnings.clear(); }
  ~Watched() { qInstallMessageHandler(before_); }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  static void keep(QtMsgType, const QMessageLogContext&, const QString& text) {
    warnings += text.toStdString() + "\n";
  }
  QtMessageHandler before_;
};

using Change = std::function<void(results::Sol8Frame&, double)>;

/// Every number of a frame.
std::vector<std::pair<std::string, Change>> numbers_of_frames() {
  using results::Sol8Frame;
  std::vector<std::pair<std::string, Change>> out{
      {"element x", [](Sol8Frame& f, double v) { f.elements[2].x = v; }},
      {"element r", [](Sol8Frame& f, double v) { f.elements[2].r = v; }},
      {"element theta", [](Sol8Frame& f, double v) { f.elements[2].theta = v; }},
      {"pocket force", [](Sol8Frame& f, double v) { f.elements[2].pocket_force = v; }},
      {"pocket angle", [](Sol8Frame& f, double v) { f.elements[2].pocket_angle = v; }},
      {"revolutions", [](Sol8Frame& f, double v) { f.revolutions = v; }}};
  for (const std::size_t i : {0U, 1U, 2U}) {
    const auto of = [&out, i](const char* name, auto part) {
      out.emplace_back(std::string(name) + " " + std::to_string(i),
                       [part, i](Sol8Frame& f, double v) { part(f)[i] = v; });
    };
    of(
        "element angles", [](Sol8Frame & f) -> auto& { return f.elements[2].angles; });
    of(
        "pocket vector", [](Sol8Frame & f) -> auto& { return f.elements[2].pocket_vector; });
    of(
        "cage position", [](Sol8Frame & f) -> auto& { return f.cage.position; });
    of(
        "cage angles", [](Sol8Frame & f) -> auto& { return f.cage.angles; });
    of(
        "race position", [](Sol8Frame & f) -> auto& { return f.races[1].position; });
    of(
        "race angles", [](Sol8Frame & f) -> auto& { return f.races[1].angles; });
    if (i > 1) continue;
    of(
        "land force", [](Sol8Frame & f) -> auto& { return f.land_force; });
    of(
        "land angle", [](Sol8Frame & f) -> auto& { return f.land_angle; });
  }
  return out;
}

constexpr std::array kNoNumbers{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(), -1e300};

}  // namespace

TEST_CASE("no_numbers: invalid number in SOL8 → pictures drawn without it", "[gui]") {
  test::use_qt();
  const results::Sol8File whole = test::synthetic_sol8(test::short_run(8));
  for (const auto& [name, change] : numbers_of_frames())
    for (const double value : kNoNumbers) {
      INFO(name << " " << value);
      const Watched watched;
      results::Sol8File file = whole;
      change(file.frames[3], value);
      draw_all(prepare(std::move(file)), 3);
      INFO(warnings.substr(0, 300));
      CHECK(warnings.empty());
    }
}

TEST_CASE("no_numbers: channel of RESULTS.h5 without values at a step → pictures drawn",
          "[gui][h5][slow]") {
  test::use_qt();
  using namespace adore::testing;
  const testing::TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing(8);
  std::size_t channels = 1;
  for (std::size_t c = 0; c < channels; ++c)
    for (const double value : kNoNumbers) {
      results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
      const auto path = folder / "RESULTS.h5";
      std::filesystem::remove(path);
      results::H5Writer h5 = results::H5Writer::create(path, bearing, channel_table());
      for (long step = 0; step < 6; ++step) {
        results::StepRecord record = recorder.record(make_snapshot(bearing, step));
        channels = record.values.size();
        if (step == 3)
          for (double& number : record.values[c]) number = value;
        h5.write(record);
      }
      h5.close();
      const Watched watched;
      INFO("channel " << c << " of " << channels << ": " << value);
      draw_all(open_motion(path), 3);
      INFO(warnings.substr(0, 300));
      CHECK(warnings.empty());
    }
}

TEST_CASE("no_numbers: stars in SOL8 → reported in the picture", "[gui]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  results::Sol8File file = test::synthetic_sol8(test::short_run(20));
  file.frames[3].elements[2].theta = std::numeric_limits<double>::quiet_NaN();
  test::write_text(folder / "SOL8", test::sol8_text(file));
  const Animation a = open_motion(folder / "SOL8");
  REQUIRE(a.notes().size() == 1);
  CHECK(a.notes().front().find("1 value is not finite") == 0);
  CHECK(a.source.find(a.notes().front()) != std::string::npos);
}
