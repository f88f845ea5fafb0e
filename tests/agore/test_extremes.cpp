#include "agore/animation.hpp"
#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/views.hpp"
#include "support/qt_app.hpp"

#include <algorithm>

using namespace adore;
using namespace adore::agore;
using namespace adore::testing;

TEST_CASE("curves next to the pictures → extremes between stored steps", "[gui][h5][step-band]") {
  test::use_qt();
  constexpr long kEvery = 3, kLast = 30;
  const auto force = [](long step) { return 20.0 + static_cast<double>(step % 2 == 0 ? step : 0); };
  const auto load = [](long step) { return 100.0 - static_cast<double>(step % 2 == 0 ? 0 : step); };
  TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing(8);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  results::StepBand band;
  for (long step = 0; step <= kLast; ++step) {
    scene::Snapshot snapshot = make_snapshot(bearing, step);
    for (auto& element : snapshot.elements) {
      for (auto& pocket : element.pocket) pocket.force = force(step);
      for (auto& race : element.race) race.load = load(step);
    }
    const auto& record = recorder.record(snapshot, &band);
    if (step % kEvery != 0) continue;
    h5.write(record);
    band.clear();
  }
  h5.close();
  const Animation animation = open_motion(folder / "RESULTS.h5");
  ViewOptions options;
  options.element = 4;
  const auto check = [&](View view, std::size_t panel, const auto& value) {
    options.view = view;
    const desktop::ChartPage page = data_page(animation, options);
    const desktop::ChartCurve& curve = page.panels.at(panel).curves.front();
    REQUIRE(curve.y.size() == kLast / kEvery + 1);
    REQUIRE(curve.low.size() == curve.y.size());
    REQUIRE(curve.high.size() == curve.y.size());
    for (long i = 1; i <= kLast / kEvery; ++i) {
      double low = value(i * kEvery), high = low;
      for (long k = (i - 1) * kEvery + 1; k < i * kEvery; ++k) {
        low = std::min(low, value(k));
        high = std::max(high, value(k));
      }
      const auto at = static_cast<std::size_t>(i);
      CHECK(curve.y[at] == Approx(value(i * kEvery)));
      CHECK(curve.low[at] == Approx(low));
      CHECK(curve.high[at] == Approx(high));
    }
  };
  check(View::Pocket, 0, force);
  check(View::Section, 0, load);
  CHECK(animation.source.find("peaks between") == std::string::npos);
  MotionPicture picture(animation);
  const auto told = [&](View view) {
    options.view = view;
    return picture.svg({1280, 800}, 1, options).contains("Min–max band between stored steps.");
  };
  CHECK(told(View::Pocket));         // with separate peaks
  CHECK_FALSE(told(View::Element));  // of speeds, which have none
}

TEST_CASE("curves of a file without extremes → note on missing peaks", "[unit][h5][step-band]") {
  const bearing::Bearing bearing = make_bearing(8);
  // As an earlier program wrote it: no channel of extremes.
  std::vector<std::string_view> plain;
  const results::ChannelTable today = channel_table();
  for (const results::Channel& channel : today.all())
    if (!channel.id.ends_with("_low") && !channel.id.ends_with("_high") &&
        !channel.id.ends_with("_mean"))
      plain.push_back(channel.id);
  REQUIRE(plain.size() < today.all().size());
  const results::ChannelTable earlier = today.only(plain);
  for (const long every : {1, 3}) {
    CAPTURE(every);
    TemporaryFolder folder;
    results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, earlier);
    results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, earlier);
    for (long step = 0; step <= 30; step += every)
      h5.write(recorder.record(make_snapshot(bearing, step)));
    h5.close();
    const Animation animation = open_motion(folder / "RESULTS.h5");
    CHECK((animation.source.find("peaks between stored steps are missing") != std::string::npos) ==
          (every > 1));
  }
}
