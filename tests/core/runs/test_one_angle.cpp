#include "base/constants.hpp"
#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/h5_reader.hpp"
#include "results/sol_file.hpp"
#include "results/sol_writer.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// An angle is told alike by every file of a run: PRINT.txt, SOL1 to SOL7 and RESULTS.h5.
using namespace adore;
namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 5> kTypes{"ball", "cylindrical", "spherical", "tapered",
                                            "spherical-tapered"};

/// Steps 0, 10 ... 60 in every file: the whirling cage passes 180 degrees on its way.
deck::Deck deck_of(const char* type) {
  deck::Deck deck = deck::new_deck(type);
  const std::vector<std::pair<std::string, std::string>> sets{
      {"maxStps", "60"}, {"nStps", "2"}, {"kPltFreq", "10"}, {"kPrtFreq", "10"}, {"kPrtOpt", "1"}};
  deck.set_all(sets);
  return deck;
}

/// An angle of a printed step: where it stands, and what.
struct Printed {
  long step = 0;
  std::string table;  ///< the first title of its columns
  std::string title, row;
  std::size_t race = 0;  ///< that the section is of
  double degrees = 0.0;
};

struct Word {
  std::string text;
  std::size_t end = 0;  ///< columns are flush right: what stands in one ends at one place
};

std::vector<Word> words(const std::string& line, const char* pattern) {
  const std::regex word(pattern);
  std::vector<Word> out;
  for (std::sregex_iterator it(line.begin(), line.end(), word), end; it != end; ++it)
    out.push_back({it->str(), static_cast<std::size_t>(it->position() + it->length())});
  return out;
}

std::string ending_at(const std::vector<Word>& words, std::size_t end) {
  for (const Word& word : words)
    if (word.end == end) return word.text;
  return {};
}

/// Every number of the printed steps whose column is in degrees.
std::vector<Printed> printed_angles(const std::string& print) {
  const std::regex step(".*STEP (\\d+)( \\(continued\\))?\\s*");
  std::vector<Printed> out;
  std::vector<Word> titles, units;
  std::size_t race = 0;
  std::string before, name;
  std::smatch found;
  long at = -1;
  std::istringstream lines(print);
  for (std::string line; std::getline(lines, line); before = line) {
    if (std::regex_match(line, found, step)) at = std::stol(found[1]);
    if (line.find("Contacts with the") != std::string::npos)
      race = line.find("inner race") == std::string::npos ? 0 : 1;
    if (at < 0) continue;
    const std::vector<Word> brackets = words(line, "\\[[^\\]]+\\]");
    if (!brackets.empty() && line.find_first_not_of(' ') == line.find('[')) {
      units = brackets;
      titles = words(before, "\\S+( \\S+)*");
      name = ending_at(titles, units.front().end);
      continue;
    }
    if (line.find_first_not_of(' ') == std::string::npos) units.clear();
    const std::vector<Word> values = words(line, "\\S+");
    static const std::regex number("-?[0-9.]+(e[-+]?[0-9]+)?");
    for (const Word& unit : units)
      if (const std::string value = ending_at(values, unit.end);
          unit.text == "[deg]" && std::regex_match(value, number))
        out.push_back({at, name, ending_at(titles, unit.end),
                       words(line, "\\S+( \\S+)*").front().text, race, std::stod(value)});
  }
  return out;
}

/// The channel and the place in it of a printed angle; empty for one that nobody has thought of.
std::pair<std::string, std::size_t> channel_of(const Printed& p, std::size_t surfaces,
                                               std::size_t lands) {
  const auto element = [&] { return std::stoul(p.row) - 1; };
  const std::map<std::string, std::string> of_elements{
      {"axial/orbital", "element.orbital_position"},
      {"axial/theta", "element.angular_velocity_theta"},
      {"axial/phi", "element.angular_velocity_phi"},
      {"theta/theta", "element.theta"},
      {"theta/phi", "element.phi"},
      {"theta/rotation", "element.rotation"}};
  if (const auto at = of_elements.find(p.table + "/" + p.title); at != of_elements.end())
    return {at->second, element()};
  if (p.table == "load" && p.title == "angle") return {"contact.angle", 2 * element() + p.race};
  if (p.table == "force" && (p.title == "theta" || p.title == "phi")) {
    const std::size_t dot = p.row.find('.');
    const std::size_t s = dot == std::string::npos ? 0 : std::stoul(p.row.substr(dot + 1)) - 1;
    return {"pocket." + p.title, element() * surfaces + s};
  }
  if (p.table == "force" && p.title == "angle")
    return {"land.angle", (std::stoul(p.row.substr(5)) - 1) % lands};
  const std::map<std::string, std::string> of_bodies{{"x/theta", "theta"},
                                                     {"x/phi", "phi"},
                                                     {"x/rotation", "rotation"},
                                                     {"x vel/theta", "angular_velocity_theta"},
                                                     {"x vel/phi", "angular_velocity_phi"},
                                                     {"orbit rad/orbit pos", "orbital_position"}};
  if (const auto at = of_bodies.find(p.table + "/" + p.title); at != of_bodies.end()) {
    if (p.row == "cage") return {"cage." + at->second, 0};
    return {"race." + at->second, p.row == "outer race" ? 0U : 1U};
  }
  return {};
}

}  // namespace

TEST_CASE("angles: PRINT.txt, the plot files and RESULTS.h5 have the same values",
          "[validation][outputs]") {
  for (const char* type : kTypes) {
    const testing::TemporaryFolder folder;
    INFO(type);
    const testing::Ran ran = testing::run_deck(deck_of(type), folder / "run");
    const results::H5Reader reader(folder / "run/RESULTS.h5");
    const std::vector<long> steps = reader.step_numbers();
    std::map<std::string, std::vector<double>> stored;
    const auto radians = [&](const std::string& id, long step, std::size_t place) {
      if (!stored.count(id)) stored[id] = reader.read(id);
      const std::size_t width = stored[id].size() / steps.size();
      const auto at = std::find(steps.begin(), steps.end(), step);
      REQUIRE(place < width);
      REQUIRE(at != steps.end());
      return stored[id][static_cast<std::size_t>(at - steps.begin()) * width + place];
    };

    const std::size_t elements = reader.find("element.theta")->size();
    const std::size_t surfaces = reader.find("pocket.theta")->size() / elements;
    const auto* land = reader.find("land.angle");
    const std::vector<Printed> printed = printed_angles(ran.print);
    std::map<std::string, int> compared;
    for (const Printed& one : printed) {
      INFO("step " << one.step << ", " << one.table << ": " << one.title << " of " << one.row);
      const auto [id, place] = channel_of(one, surfaces, land == nullptr ? 1 : land->size());
      REQUIRE(!id.empty());
      if (reader.find(id) == nullptr) continue;
      const double value = radians(id, one.step, place) / kDegree;
      CHECK(one.degrees == Approx(value).epsilon(6e-5).margin(1e-9));
      ++compared[id];
    }
    for (const char* id : {"element.orbital_position", "element.angular_velocity_theta",
                           "contact.angle", "pocket.theta", "cage.orbital_position", "cage.theta",
                           "race.orbital_position", "race.rotation"})
      CHECK(compared[id] >= 7);
    if (land != nullptr && land->size() > 0) CHECK(compared["land.angle"] >= 7);

    int columns = 0;
    for (int n = 1; n <= 4; ++n) {
      const results::SolFile file = results::read_sol(folder / fmt::format("run/SOL{}", n));
      INFO("SOL" << n);
      const std::vector<results::SolColumn> names = results::sol_columns(file.header);
      for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k].channel < 0) continue;
        const results::Channel& channel =
            results::channels()[static_cast<std::size_t>(names[k].channel)];
        if (channel.unit != &results::unit::kAngle) continue;
        INFO(channel.id);
        ++columns;
        for (const results::SolStep& step : file.steps)
          CHECK(step.values[k] ==
                Approx(radians(std::string(channel.id), step.step, names[k].at) / kDegree)
                    .epsilon(2e-7)
                    .margin(1e-12));
      }
    }
    CHECK(columns > 20);
  }
}
