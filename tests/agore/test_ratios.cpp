#include "agore/example_run.hpp"
#include "agore/race_speeds.hpp"
#include "agore/views.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

using namespace adore;
using namespace adore::agore;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

/// The first steps of an example with other speeds of its races [rpm].
fs::path turned(const testing::TemporaryFolder& folder, const std::string& type, int outer,
                int inner) {
  runs::RunRequest request;
  request.deck = test::source_dir() / "resources/decks" / (type + ".txt");
  request.out = folder / fmt::format("{}{}{}", type, outer, inner);
  request.sets = {{"rpm1", std::to_string(outer)},
                  {"rpm2", std::to_string(inner)},
                  {"kDOF", "0"},
                  {"maxStps", "24"},
                  {"kPltFreq", "1"}};
  (void)runs::run(request);
  return *request.out;
}

/// "... , −8000 rpm": divisor of the ratios in a title.
double named_divisor(const std::string& title) {
  std::smatch found;
  INFO(title);
  REQUIRE(std::regex_search(title, found, std::regex(", ((?:−)?)([0-9.]+) rpm")));
  return (found[1].length() > 0 ? -1.0 : 1.0) * std::stod(found[2]);
}

double last(const std::vector<double>& values) { return values.back(); }

desktop::ChartPage page_of(const Animation& animation, View view) {
  ViewOptions options;
  options.view = view;
  options.element = 1;
  return data_page(animation, options);
}

constexpr std::pair<int, int> kSpeeds[] = {{0, 6000},     {-6000, 0},   {4000, 0},
                                           {-3000, 5000}, {2500, 6000}, {5000, 5000}};

}  // namespace

TEST_CASE("ratios times the divisor that their title names are the speeds of RESULTS.h5",
          "[gui][agore][h5]") {
  const testing::TemporaryFolder folder;
  for (const std::string type : {"ball", "tapered"})
    for (const auto& [outer, inner] : kSpeeds) {
      const Animation a = open_motion(turned(folder, type, outer, inner) / "RESULTS.h5");
      const results::MotionFile& h5 = *a.motion;
      const desktop::ChartPage cage = page_of(a, View::Cage), element = page_of(a, View::Element);
      INFO(type << " " << outer << " " << inner << ": " << cage.title << "; " << element.title);
      const double divisor = named_divisor(cage.title);
      CHECK(named_divisor(element.title) == divisor);
      CHECK(divisor == Approx(outer == inner ? inner : inner - outer));
      const double faster = std::abs(outer) > std::abs(inner) ? outer : inner;
      const auto drawn = [&](const desktop::ChartPage& page, std::size_t panel) {
        return divisor * last(page.panels.at(panel).curves.front().y);
      };
      const double rounding = 2e-3 * std::abs(faster);
      CHECK(drawn(element, 0) ==
            Approx(last(h5.series("element.orbital_velocity", 0))).margin(rounding));
      CHECK(std::abs(drawn(element, 1)) ==
            Approx(std::abs(last(h5.series("element.angular_velocity", 0)))).margin(rounding));
      CHECK(drawn(cage, 1) == Approx(last(h5.series("cage.angular_velocity", 0))).margin(rounding));
      CHECK(drawn(cage, 0) ==
            Approx(faster * last(h5.series("cage.whirl_ratio", 0))).margin(rounding));
      // Cage and elements set out together: neither may seem to overtake or to meet the other.
      CHECK(cage.panels[1].curves[0].y.front() ==
            Approx(element.panels[0].curves[0].y.front()).margin(0.03));
    }
}

TEST_CASE("header line: rotating outer race → both races named", "[gui][agore][h5]") {
  const testing::TemporaryFolder folder;
  const auto text = [&](int outer, int inner) {
    return speed_text(open_motion(turned(folder, "ball", outer, inner) / "RESULTS.h5"));
  };
  CHECK(text(0, 6000) == "runs at 6000 rpm");
  CHECK(text(0, -6000) == "runs at −6000 rpm");
  CHECK(text(-8000, 0) == "races at −8000 (outer) and 0 rpm (inner)");
  CHECK(text(-3000, 5000) == "races at −3000 (outer) and 5000 rpm (inner)");
  CHECK(text(5000, 5000) == "races at 5000 (outer) and 5000 rpm (inner)");
}

TEST_CASE("without RESULTS.h5 no ratio is over a speed that its title does not name",
          "[gui][agore][h5]") {
  const testing::TemporaryFolder folder;
  const fs::path whole = turned(folder, "ball", -3000, 5000), alone = folder / "alone";
  fs::create_directories(alone);
  fs::copy_file(whole / "SOL8", alone / "SOL8");
  const Animation a = open_motion(alone / "SOL8");
  CHECK(speed_text(a) == "races at 8000 rpm relative to each other");
  // How far a race turns between two frames no SOL8 tells.
  for (const View view : {View::Cage, View::Element})
    CHECK_THAT(page_of(a, view).panels.at(1).message, Contains("outer race rotates"));
  fs::copy_file(whole / "SOL3", alone / "SOL3");
  CHECK_THAT(page_of(open_motion(alone / "SOL8"), View::Cage).title, Contains("faster race"));
}

TEST_CASE("curves with two values per period of the fastest contact → note next to the picture",
          "[gui][agore][h5]") {
  const testing::TemporaryFolder folder;
  const fs::path run = turned(folder, "ball", 0, 6000);
  const Animation a = open_motion(run / "RESULTS.h5");
  const std::string said = "stored steps per period";
  for (const View view : {View::Cage, View::Element})
    CHECK_THAT(page_of(a, view).note, Contains(said));
  // These have the extremes between the steps.
  for (const View view : {View::Section, View::Pocket})
    CHECK_THAT(page_of(a, view).note, !Contains(said));
  std::ifstream in(run / "RUN.json");
  nlohmann::json json = nlohmann::json::parse(in);
  json["plan"]["estimates"]["fastest_frequency_Hz"] = 500.0;
  std::ofstream(run / "RUN.json") << json;
  CHECK(page_of(a, View::Cage).note.empty());
}
