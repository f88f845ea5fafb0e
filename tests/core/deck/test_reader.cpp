#include "base/errors.hpp"
#include "core/deck/deck_variants.hpp"
#include "deck/deck.hpp"
#include "deck/lookup.hpp"
#include "deck/schema.hpp"
#include "deck/templates.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <clocale>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <random>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

using namespace adore::deck;
using adore::Issue;
using adore::Severity;

namespace {

namespace fs = std::filesystem;

struct BadDeck {
  const char* file;
  Severity severity;
  const char* record;
  const char* variable;
  const char* phrase;
};

/// One deck per message; each is the ball example (or a roller example) with one mistake.
const BadDeck kBadDecks[] = {
    {"empty", Severity::Error, "", "", "the deck is empty"},
    {"blank", Severity::Error, "", "", "the deck is empty"},
    {"binary", Severity::Error, "", "", "not a text file"},
    {"truncated_line", Severity::Error, "4", "shftID", "the deck ends in this record"},
    {"truncated_records", Severity::Error, "9.1.1", "",
     "the deck ends, but records 9.1.1, 9.1.2, 9.1.3"},
    {"truncated_last", Severity::Error, "11", "", "record 11 (Gravity) is required"},
    {"letters", Severity::Error, "5A", "bReDia", "is not a number"},
    {"nan", Severity::Error, "5A", "pitchDia", "not a finite number"},
    {"infinity", Severity::Error, "9.1.2", "rpm2", "not a finite number"},
    {"overflow", Severity::Error, "9.1.1", "appLoadX", "too large for a number"},
    {"integer_with_point", Severity::Error, "3.2", "nRe", "must be an integer"},
    {"integer_text", Severity::Error, "1", "maxStps", "is not an integer"},
    {"integer_overflow", Severity::Error, "1", "maxStps", "too large for an integer"},
    {"quoted_number", Severity::Error, "5A", "bReDia", "is text, but a number is required"},
    {"short_record", Severity::Error, "4", "raceWidth2", "the record has too few values"},
    {"short_names", Severity::Error, "2.3", "pltNames8", "the record has too few values"},
    {"no_value", Severity::Error, "9.0", "raceFit1", "the value is missing and has no default"},
    {"slash_too_early", Severity::Error, "4", "raceWidth1",
     "the value is missing and has no default"},
    {"zero_repeat", Severity::Error, "9.1.3", "hsngTemp", "repeat count of 0"},
    {"too_many_values", Severity::Warning, "4", "", "has 7 values"},
    {"repeat_too_long", Severity::Warning, "9.1.3", "", "more values than the record has"},
    {"open_quote", Severity::Error, "3.1", "runID", "closing quote is missing"},
    {"open_label", Severity::Error, "4", "recID", "closing quote is missing"},
    {"joined_quote", Severity::Error, "3.1", "runID", "follows directly after the closing quote"},
    {"no_label", Severity::Error, "4", "recID", "the record has no label"},
    {"bare_label", Severity::Warning, "4", "recID", "should be in single quotes"},
    {"bare_text", Severity::Warning, "3.1", "runID", "should be in single quotes"},
    {"surplus_line", Severity::Error, "5A", "recID", "a record label in quotes is expected"},
    {"prose", Severity::Error, "4", "hsngOD", "is not a number"},
    {"decimal_comma", Severity::Warning, "11", "", "has 4 values"},
    {"bare_end", Severity::Note, "11", "", "may be truncated"},
    {"missing_record", Severity::Error, "5A", "", "the record (Ball bearing geometry) is missing"},
    {"missing_land", Severity::Error, "7.2.i", "", "is missing"},
    {"extra_record", Severity::Warning, "2.2", "", "is not needed and is ignored"},
    {"database_material", Severity::Warning, "8.1", "", "is not needed and is ignored"},
    {"double_record", Severity::Error, "4", "", "already has this record"},
    {"surplus_land", Severity::Warning, "7.2.i", "", "more of these records than `nGL`"},
    {"user_lines", Severity::Warning, "12", "", "kept as input of user routines"},
    {"bad_code", Severity::Error, "3.2", "kBrg", "this code does not exist"},
    {"bad_integrator", Severity::Error, "1", "intMet", "this code does not exist"},
    {"bad_material", Severity::Error, "7.0", "kCageMat", "this code does not exist"},
    {"bad_lubricant", Severity::Error, "10.0", "kTrac", "this code does not exist"},
    {"bad_curve", Severity::Error, "10.0", "kCPTracType", "this code does not exist"},
    {"no_elements", Severity::Error, "3.2", "nRe", "is out of range"},
    {"too_many_lands", Severity::Error, "7.0", "nGL", "is out of range"},
    {"negative_steps", Severity::Error, "1", "maxStps", "is out of range"},
    {"negative_length", Severity::Error, "4", "brgBore", "is out of range"},
    {"zero_tolerance", Severity::Error, "2.1", "tol", "is out of range"},
    {"celsius", Severity::Error, "9.0", "roomTemp", "is out of range"},
    {"groove_factor", Severity::Error, "5A", "raceCurFac1", "is out of range"},
    {"long_label", Severity::Warning, "4", "recID", "characters long, but at most 12"},
    {"long_name", Severity::Error, "3.1", "runID", "characters long, but at most 36"},
    {"step_limits", Severity::Error, "2.1", "stpMin", "smallest step is larger"},
    {"first_step", Severity::Warning, "2.1", "stpInit", "above stpMax"},
    {"tiny_first_step", Severity::Warning, "2.1", "stpInit", "below stpMin"},
    {"no_first_step", Severity::Error, "2.1", "stpInit", "0 reuses the last step"},
    {"moment_flags", Severity::Error, "2.2", "kMD31", "must equal kMD21"},
    {"equilibrium_force", Severity::Error, "2.2", "kFD12", "in mode 2"},
    {"static_options", Severity::Warning, "1", "kDCR", "no effect: mode is negative"},
    {"static_names", Severity::Warning, "1", "kFnOpt", "no data files are written"},
    {"same_names", Severity::Error, "2.3", "pltNames2", "already used by pltNames1"},
    {"reserved_name", Severity::Error, "2.3", "finName", "already used by the listing"},
    {"path_name", Severity::Error, "2.3", "masName", "not a valid file name"},
    {"flexible_race", Severity::Error, "3.2", "kRaceFlex", "cannot be simulated"},
    {"bodies_unsorted", Severity::Error, "3.4", "kPltElemInd", "increasing order"},
    {"no_such_body", Severity::Error, "3.4", "kPltElemInd", "there is no body 16"},
    {"many_bodies", Severity::Warning, "3.4", "kNumPltElem", "contain only the first six"},
    {"ball_flange", Severity::Warning, "3.2", "kFlngInd11", "has no effect"},
    {"flange_without_height", Severity::Error, "5F", "flngHt12", "has no height"},
    {"flange_layback", Severity::Error, "5F", "flngAng12", "must lean away"},
    {"no_rib", Severity::Error, "3.2", "kFlngInd12", "need a flange at their large end"},
    {"short_ball_cage", Severity::Error, "7.1", "cageWidth", "bPocCls1 = 0.01295 m, do not fit"},
    {"unused_spin_angle", Severity::Warning, "9.0", "angVelOrient", "because kAngVel = 1"},
    {"roller_spin", Severity::Warning, "3.3", "kAngVel", "no effect on rollers"},
    {"long_diameter_list", Severity::Error, "3.2", "kReGeoImp", "the list of diameters has 40"},
    {"diameter_without_element", Severity::Warning, "5G.1D.2", "reDiaVar13",
     "does not have this element"},
    {"churning_without_oil", Severity::Error, "3.3", "kChrn", "kTrac = 0 has no lubricant"},
    {"coolant_without_oil", Severity::Error, "3.5", "kCoolant", "has no lubricant"},
    {"base_without_coolant", Severity::Error, "3.5", "kBaseTemp", "kCoolant is 0"},
    {"still_coolant", Severity::Warning, "9.7", "cFlowRate", "does not flow"},
    {"thermal_traction", Severity::Warning, "10.0", "iTherm", "has an effect only with kTrac = 12"},
    {"bore_too_large", Severity::Error, "4", "brgBore", "smaller than the outside diameter"},
    {"shaft_wall", Severity::Error, "4", "shftID", "no wall"},
    {"no_housing", Severity::Warning, "4", "hsngOD", "no wall that could hold"},
    {"small_housing", Severity::Error, "4", "hsngOD", "larger than the bearing"},
    {"millimetres", Severity::Warning, "4", "brgBore", "very large for a bearing"},
    {"micrometres", Severity::Warning, "5A", "rmsAspHt1", "very large"},
    {"pitch_too_small", Severity::Error, "5A", "pitchDia", "larger than the ball diameter"},
    {"pitch_outside", Severity::Error, "5A", "pitchDia", "between bore"},
    {"ball_through_race", Severity::Warning, "5A", "bReDia", "through a race"},
    {"too_many_balls", Severity::Error, "3.2", "nRe", "do not fit on the pitch circle"},
    {"no_web", Severity::Warning, "3.2", "nRe", "pockets overlap"},
    {"line_to_line", Severity::Warning, "5A", "freeIntCls",
     "contact angle and clearance are both zero"},
    {"clearance_too_large", Severity::Error, "5A", "freeIntCls", "cannot touch both races"},
    {"angle_and_clearance", Severity::Warning, "5A", "freeIntCls", "is not used"},
    {"thick_shim", Severity::Error, "5A", "shimThickness1", "too thick for a split groove"},
    {"shoulders", Severity::Warning, "5A", "shoulderDia1", "not larger than that of the inner"},
    {"ball_pocket_code", Severity::Error, "7.0", "kPocType", "a pocket for rollers"},
    {"cage_inside_out", Severity::Error, "7.1", "cageDia2", "smaller than the outer diameter"},
    {"cage_off_elements", Severity::Error, "7.1", "cageDia1", "does not reach the elements"},
    {"cage_outside", Severity::Error, "7.1", "cageDia1", "larger than the bearing, whose"},
    {"cage_in_bore", Severity::Error, "7.1", "cageDia2", "not above the bearing bore"},
    {"cage_in_race", Severity::Warning, "7.1", "cageDia1", "whose shoulder has a diameter"},
    {"cage_in_inner_race", Severity::Warning, "7.1", "cageDia2", "whose raceway has a diameter"},
    {"low_shoulder", Severity::Warning, "5A", "shoulderDia1", "inside the pitch circle"},
    {"high_shoulder", Severity::Warning, "5A", "shoulderDia2", "outside the pitch circle"},
    {"tight_roller_pocket", Severity::Warning, "7.1", "bPocCls1", "smaller than the roller"},
    {"narrow_roller_cage", Severity::Warning, "7.1", "cageWidth", "leave no rim"},
    {"tight_pocket", Severity::Warning, "7.1", "bPocCls1", "smaller than the ball"},
    {"huge_pocket", Severity::Warning, "7.1", "bPocCls1", "twice as large"},
    {"cut_without_segments", Severity::Warning, "7.1", "cageAngCut", "no cut"},
    {"high_land", Severity::Warning, "7.2.i", "cageGsDia[1]",
     "above the outer diameter of the cage"},
    {"low_land", Severity::Warning, "7.2.i", "cageGsDia[2]",
     "below the inner diameter of the cage"},
    {"tight_land", Severity::Warning, "7.2.i", "cageGsCls[1]", "clamps the cage"},
    {"wide_land", Severity::Error, "7.2.i", "cageGsWidth[1]", "wider than the cage"},
    {"land_outside", Severity::Warning, "7.2.i", "cageGsPos[2]", "outside the cage"},
    {"hydro_without_land", Severity::Warning, "7.0", "kGsHydro", "no land is guided by a race"},
    {"segment_hydro", Severity::Warning, "7.0", "kPocHydro", "not available for a segmented cage"},
    {"unequal_segments", Severity::Error, "7.0.1", "lSeg", "must be identical"},
    {"mixed_cuts", Severity::Error, "7.0.1", "lSeg", "must be identical"},
    {"segment_beyond", Severity::Error, "7.0.1", "lSeg", "there is no rolling element 13"},
    {"segment_count", Severity::Error, "3.2", "nCseg", "cannot be divided"},
    {"unused_load", Severity::Warning, "9.1.1", "appLoadZ", "is not used, because kFS3 is 1"},
    {"acceleration_times", Severity::Error, "9.4A", "endTime2", "ends before its start"},
    {"cold_room", Severity::Warning, "9.0", "roomTemp", "plausible only for a cryogenic bearing"},
    {"no_peak", Severity::Error, "10.1C", "reRaceTC2", "must be above those at zero slip"},
    {"wrong_slope", Severity::Error, "10.5.1D", "reCageTC3", "does not approach the asymptote"},
    {"growing_traction", Severity::Error, "10.1A", "reRaceTC3", "grows without limit"},
    {"impossible_inertia", Severity::Error, "6.1", "bReMIx", "not possible for a rigid body"},
    {"spherical_flange", Severity::Error, "3.2", "kFlngInd11", "has no flanges"},
    {"roller_pocket_code", Severity::Error, "7.0", "kPocType", "a conical pocket for balls"},
    {"roller_pitch", Severity::Error, "5B.1", "pitchDia", "larger than the roller diameter"},
    {"long_central_land", Severity::Error, "5B.1", "bReCenLen", "longer than the roller"},
    {"roller_corners", Severity::Error, "5B.1", "bReCorRad1", "not below the roller length"},
    {"roller_corner", Severity::Error, "5B.1", "bReCorRad2", "cannot exceed the roller radius"},
    {"cone_angles", Severity::Error, "5D.1", "raceTaper1", "larger than the inner cone angle"},
    {"cones_too_close", Severity::Error, "5D.1", "raceTaper2",
     "are too close: the resulting pitch diameter"},
    {"cones_far_apart", Severity::Error, "5E", "raceTaper2", "are too far apart"},
    {"too_many_tapered", Severity::Error, "3.2", "nRe", "do not fit on the pitch circle"},
};

const fs::path kFolder = adore::test::source_dir() / "tests/decks/bad";

std::string content_of(const fs::path& path) {
  REQUIRE(fs::exists(path));
  return adore::test::bytes_of(path);
}

bool matches(const Issue& issue, const BadDeck& bad) {
  return issue.severity == bad.severity && issue.record == bad.record &&
         issue.variable == bad.variable && issue.message.find(bad.phrase) != std::string::npos;
}

/// The lines of the ball example without the explanations, by record label.
std::vector<std::string> ball_lines() {
  std::vector<std::string> lines;
  for (const RecordData& record : new_deck("ball").records) {
    Deck one;
    one.records.push_back(record);
    lines.push_back(write_deck(one));
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A legal value for every real and text, so that a round trip has something to lose.
void fill_with_numbers(Deck& deck, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit_interval(0.0, 1.0);
  for (RecordData& record : deck.records) {
    const RecordSpec& spec = *find_record(record.id);
    for (std::size_t i = 0; i < spec.variables.size(); ++i) {
      const VariableSpec& variable = spec.variables[i];
      for (Value& value : record.values[i]) {
        if (variable.type == VarType::Real) {
          const double low = std::max(variable.range.min, -1e6);
          const double high = std::min(variable.range.max, 1e6);
          value = low + (high - low) * (0.001 + 0.99 * unit_interval(random));
        } else if (variable.type == VarType::String) {
          value = std::string("a'b, /").substr(0, 3 + random() % 4);
        }
      }
    }
  }
}

class CommaDecimal : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("reader and checks: every error → message with record, variable and remedy",
          "[unit][deck]") {
  for (const BadDeck& bad : kBadDecks) {
    INFO(bad.file);
    const std::string text = content_of(kFolder / (std::string(bad.file) + ".txt"));
    const ReadResult result = read_deck_text(text, bad.file);
    INFO(adore::to_text(result.issues));
    CHECK(std::count_if(result.issues.begin(), result.issues.end(),
                        [&](const Issue& issue) { return matches(issue, bad); }) == 1);
    CHECK(result.ok() == (bad.severity != Severity::Error));
    CHECK(result.issues.size() <= 6);  // one mistake, no avalanche
    for (const Issue& issue : result.issues) {
      CHECK(issue.file == bad.file);
      CHECK_FALSE(issue.remedy.empty());
      CHECK((issue.line > 0 || issue.message == "the deck is empty"));
    }
  }
}

TEST_CASE("bad decks: every deck of the folder is in the table", "[unit][deck]") {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(kFolder))
    files.insert(entry.path().stem().string());
  std::set<std::string> listed;
  for (const BadDeck& bad : kBadDecks) listed.insert(bad.file);
  CHECK(files == listed);
}

TEST_CASE("reader: several errors → reported together", "[unit][deck]") {
  std::vector<std::string> lines = ball_lines();
  lines[0] = replaced(lines[0], "5000", "many");
  lines[3] = replaced(lines[3], "12", "0");
  lines[7] = replaced(lines[7], "0.06", "-0.06");
  lines[9] = replaced(lines[9], "0.066", "0.050");
  lines[18] = "'Rec 10.1C', 0.0\n";
  lines.erase(lines.begin() + 13);  // 9.1.1
  const ReadResult result = read_deck_text(joined(lines), "x.txt");
  std::set<std::string> places;
  for (const Issue& issue : result.issues) places.insert(issue.record + "/" + issue.variable);
  CAPTURE(adore::to_text(result.issues));
  for (const char* place :
       {"1/maxStps", "3.2/nRe", "5A/pitchDia", "7.1/cageDia2", "9.1.1/", "10.1C/reRaceTC2"})
    CHECK(places.count(place) == 1);
}

TEST_CASE("reader: list-directed input as in Fortran", "[unit][deck]") {
  Deck ball = new_deck("ball");
  ball.set("runID", "7208");  // no comma, so that the changes below meet only separators
  const std::string text = write_deck(ball);
  const auto reads_equal = [&](const std::string& other) {
    const ReadResult result = read_deck_text(other, "x");
    INFO(adore::to_text(result.issues));
    CHECK(result.ok());
    CHECK(result.deck == ball);
  };
  const auto each_line = [&](auto change) {
    std::string out;
    for (const RecordData& record : ball.records) {
      Deck one;
      one.records.push_back(record);
      std::string line = write_deck(one);
      line.pop_back();
      out += change(line);
    }
    return out;
  };
  SECTION("blanks separate") {
    std::string blanks = text;
    bool inside = false;
    for (char& c : blanks) {
      if (c == '\'') inside = !inside;
      if (c == ',' && !inside) c = ' ';
    }
    reads_equal(blanks);
  }
  SECTION("tabs, CRLF, lone CR, byte-order mark, end-of-file mark, blank lines") {
    std::string tabs = text;
    std::replace(tabs.begin(), tabs.end(), ',', '\t');
    reads_equal(tabs);
    reads_equal("\xEF\xBB\xBF" +
                each_line([](const std::string& line) { return line + "\r\n\r\n  \t\r\n"; }) +
                "\x1a");
    reads_equal(each_line([](const std::string& line) { return line + "\r"; }));
  }
  SECTION("text after the last value is ignored") {
    reads_equal(
        each_line([](const std::string& line) { return line + " ! 'a comment', 1, 2 / 3\n"; }));
  }
  SECTION("values may span lines") {
    reads_equal(each_line([](std::string line) {
      for (std::size_t at = line.find(", ", line.find('\'', 1)); at != std::string::npos;
           at = line.find(", ", at + 2))
        line.replace(at, 2, ",\n");
      return line + "\n";
    }));
    reads_equal(
        each_line([](std::string line) { return replaced(line, "', ", "'\n  , \n") + "\n"; }));
  }
  SECTION("repeat counts") {
    reads_equal(replaced(text, "293.15, 293.15, 293.15, 293.15, 293.15, 293.15",
                         "2*293.15 3*2.9315d2, 1*293.15"));
    reads_equal(replaced(text, "0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0", "3*0,3*1,8*0"));
  }
  SECTION("numbers without point, with d exponents, with signs") {
    reads_equal(
        replaced(replaced(replaced(text, "3600.0", "3600"), "25.0", "+2.5D+1"), "5.0e-04", "5d-4"));
  }
  SECTION("double quotes and doubled quotes") {
    Deck quoted = ball;
    quoted.set("runID", "it's \"quoted\"");
    const std::string written = write_deck(quoted);
    CHECK_THAT(written, Catch::Contains("'it''s \"quoted\"'"));
    CHECK(read_deck_text(written, "x").deck == quoted);
    CHECK(read_deck_text(replaced(written, "'it''s \"quoted\"'", "\"it's \"\"quoted\"\"\""), "x")
              .deck == quoted);
  }
  SECTION("skipped values keep their default, a slash ends the record") {
    const std::string skipped =
        replaced(text, "0.05, 5.0e-04, 0.5, 3600.0, 1.0e-06", ",, , 3600.0,");
    reads_equal(skipped);
    reads_equal(replaced(text, "'Rec 10.5.1D', 0.0, 0.08, 0.8, 0.0",
                         "'Rec 10.5.1D', 0.0, 0.08, 0.8 / the rest, 'is' ignored"));
    const ReadResult slash =
        read_deck_text(replaced(text, "0.05, 5.0e-04, 0.5, 3600.0, 1.0e-06, 0.0", "/"), "x");
    REQUIRE(slash.issues.size() == 1);  // qFac has no default
    CHECK(slash.issues[0].variable == "qFac");
    CHECK(slash.deck.real("fTime") == 1000.0);
  }
  SECTION("labels do not change the values of a deck that reads well") {
    std::string renamed;
    int number = 0;
    for (std::string line : ball_lines()) {
      const std::string label = number % 3 == 0 ? "Rec 11" : number % 3 == 1 ? "" : "bearing 5A ?";
      renamed += "'" + label + "'" + line.substr(line.find(", ")).insert(0, "");
      ++number;
    }
    const ReadResult result = read_deck_text(renamed, "x");
    CHECK_FALSE(result.issues.empty());
    for (const Issue& issue : result.issues) {  // values are read; labels of others are a warning
      CHECK(issue.severity == Severity::Warning);
      CHECK(issue.value == "Rec 11");
      CHECK(issue.message.find("the label names record 11") == 0);
    }
    CHECK(result.deck.real("gravityVecZ") == -9.81);
  }
}

TEST_CASE("checks: unusual but valid bearings → no warning", "[unit][deck]") {
  const auto issues_after = [](std::vector<std::pair<std::string_view, std::string>> changes) {
    Deck deck = new_deck("ball");
    deck_variants::set_all(deck, changes);
    return check_deck(deck);
  };
  // Nothing loads or turns it: most likely forgotten, and legal all the same.
  for (const Issue& issue : issues_after({{"appLoadX", "0"}, {"appLoadZ", "0"}, {"rpm2", "0"}}))
    CHECK(issue.severity == Severity::Warning);
  CHECK(issues_after({{"freeConAng", "0"}, {"freeIntCls", "-1e-5"}}).empty());
  CHECK(issues_after({{"nRe", "1"}, {"kNumPltElem", "1"}}).empty());
  for (const std::string count : {"41", "200"}) {
    const std::vector<Issue> issues = issues_after({{"nRe", count},
                                                    {"bReDia", "0.0008"},
                                                    {"bPocCls1", "0.00005"},
                                                    {"kNumPltElem", "1"},
                                                    {"kPltElemInd", "1"}});
    CAPTURE(adore::to_text(issues));
    CHECK(issues.empty());
  }
  CHECK(issues_after({{"mode", "-3"}}).empty());
  CHECK(issues_after({{"intMet", "33"}, {"stpMin", "0.5"}, {"stpInit", "0.5"}}).empty());
  CHECK(
      issues_after({{"kPrtFreq", "0"}, {"nStps", "0"}, {"kIcOpt", "1"}, {"stpInit", "0"}}).empty());
}

TEST_CASE("checks: quasi-static deck → unused options are reported", "[unit][deck]") {
  Deck deck = new_deck("ball");
  deck_variants::set_all(deck, {{"mode", "-1"}, {"kIcOpt", "1"}, {"kFnOpt", "1"}});
  const std::string text = adore::to_text(check_deck(deck));
  INFO(text);
  CHECK(text.find("kIcOpt = 1: has no effect: mode is negative") != std::string::npos);
  CHECK(text.find("kFnOpt = 1: has no effect: mode is negative") != std::string::npos);
}

TEST_CASE("checks: incompatible cones → the remedy works, in both unit systems", "[unit][deck]") {
  for (const double angle : {14.0, 4.0}) {
    Deck deck = new_deck("tapered");
    deck.set("raceTaper2", std::to_string(angle));
    const auto remedy = [&]() -> std::string {
      for (const Issue& issue : check_deck(deck))
        if (issue.variable == "raceTaper2" && issue.severity == Severity::Error)
          return issue.remedy;
      return {};
    };
    const std::string text = remedy();
    INFO(text);
    const std::size_t at = text.find("cone angle of ");
    REQUIRE(at != std::string::npos);
    const double first = std::stod(text.substr(at + 14));
    const double last = std::stod(text.substr(text.find(" to ") + 4));
    CHECK(first < 10.35);
    CHECK(last > 10.35);
    for (const double inner : {first + 0.01, last - 0.01}) {
      deck.set("raceTaper2", std::to_string(inner));
      CHECK(remedy().empty());
    }
  }
}

TEST_CASE("write_deck(): every record → reads back equal", "[unit][deck][schema]") {
  std::set<std::string> records;
  unsigned seed = 1;
  for (Deck deck : deck_variants::all()) {
    fill_with_numbers(deck, seed++);
    const std::string text = write_deck(deck);
    const ReadResult back = read_deck_text(text, "x");
    INFO(text);
    CHECK(back.deck == deck);
    CHECK(write_deck(back.deck) == text);
    for (const RecordData& record : deck.records) records.insert(record.id);
  }
  // All but 12, which the user routines own, and records X, which no option asks for.
  const auto extension = std::count_if(schema().begin(), schema().end(),
                                       [](const auto& spec) { return is_extension(spec.id); });
  CHECK(records.size() + 1 + static_cast<std::size_t>(extension) == schema().size());
}

TEST_CASE("write_deck(): lines of user routines → read back equal", "[unit][deck]") {
  const std::string text = write_deck(new_deck("ball")) + "1.0, 'raw' / line\n\n  0.001 0.002\n";
  const ReadResult result = read_deck_text(text, "x");
  CHECK(result.ok());
  CHECK(result.deck.user_lines == std::vector<std::string>{"1.0, 'raw' / line", "  0.001 0.002"});
  CHECK(read_deck_text(write_deck(result.deck), "x").deck == result.deck);
}

TEST_CASE("write_deck(): decks with missing values → read back equal", "[unit][deck]") {
  Deck deck = new_deck("ball");
  RecordData& envelope = deck.records[6];
  REQUIRE(envelope.id == "4");
  envelope.values[2][0] = std::monostate{};
  CHECK(read_deck_text(write_deck(deck), "x").deck == deck);
  for (std::size_t i = 3; i < 7; ++i) envelope.values[i][0] = std::monostate{};
  CHECK_THAT(write_deck(deck), Catch::Contains("'Rec 4', 0.04 /\n"));
  CHECK(read_deck_text(write_deck(deck), "x").deck == deck);
  for (std::vector<Value>& values : envelope.values) values[0] = std::monostate{};
  CHECK(read_deck_text(write_deck(deck), "x").deck == deck);
}

TEST_CASE("reader: deck cut at any place → error", "[unit][deck][slow]") {
  const std::string text(template_text("ball"));
  const Deck whole = read_deck_text(text, "x").deck;
  std::vector<std::size_t> unnoticed;
  std::size_t noticed = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const ReadResult result = read_deck_text(std::string_view(text).substr(0, size), "x");
    if (!result.issues.empty())
      ++noticed;
    else if (!(result.deck == whole))
      unnoticed.push_back(size);
  }
  CHECK(unnoticed == std::vector<std::size_t>());
  CHECK(noticed > text.size() * 9 / 10);  // not all are the whole deck
}

TEST_CASE("reader: any byte missing → no crash, and valid decks write back equal", "[unit][deck]") {
  const std::string text = write_deck(new_deck("ball-thrust"));
  std::vector<std::size_t> changed;
  std::size_t read_well = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string damaged = text;
    damaged.erase(at, 1);
    const ReadResult result = read_deck_text(damaged, "x");
    if (!result.ok() || !result.deck.user_lines.empty()) continue;
    ++read_well;
    if (!(read_deck_text(write_deck(result.deck), "x").deck == result.deck)) changed.push_back(at);
  }
  CHECK(changed == std::vector<std::size_t>());
  CHECK(read_well > text.size() / 4);  // digits and blanks that a deck can do without
}

TEST_CASE("reader: locale with decimal comma → no effect", "[unit][deck]") {
  const Deck ball = new_deck("ball");
  const std::string text = write_deck(ball);
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new CommaDecimal));
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);
  const std::string text_with_comma = write_deck(ball);
  const ReadResult read = read_deck_text(text, "x");
  const std::string schema_with_comma = schema_json();
  Issue range = check_deck([&] {
                  Deck deck = ball;
                  deck.set("raceCurFac1", "0.25");
                  return deck;
                }())
                    .at(0);
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  CHECK(text_with_comma == text);
  CHECK(read.issues.empty());
  CHECK(read.deck == ball);
  CHECK(schema_with_comma == schema_json());
  CHECK(range.value == "0.25");
  CHECK_THAT(range.remedy, Catch::Contains("above 0.5"));
}

TEST_CASE("files: missing, folder, binary, too large, and a good one", "[unit][deck]") {
  const fs::path folder = adore::test::binary_dir() / ("deck_test_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  CHECK_THROWS_WITH(read_deck(folder / "none.txt"), Catch::Contains("no such file"));
  CHECK_THROWS_WITH(read_deck(folder), Catch::Contains("is a folder"));
  std::ofstream(folder / "binary.txt", std::ios::binary)
      .write(
          "\x7f"
          "ELF\0\1",
          6);
  CHECK_THROWS_WITH(read_deck(folder / "binary.txt"), Catch::Contains("not a text file"));
  std::ofstream(folder / "large.txt") << std::string(17u * 1024 * 1024, ' ');
  CHECK_THROWS_WITH(read_deck(folder / "large.txt"), Catch::Contains("16 MiB"));
  const Deck ball = new_deck("ball");
  write_deck(ball, folder / "DATA.txt");
  const ReadResult result = read_deck(folder / "DATA.txt");
  CHECK(result.issues.empty());
  CHECK(result.deck == ball);
  CHECK(result.deck.file == (folder / "DATA.txt").string());
  CHECK(result.deck.records[4].line == 5);
  CHECK_THROWS_AS(write_deck(ball, folder / "none" / "DATA.txt"), adore::InputError);
  fs::remove_all(folder);
}

TEST_CASE("reader: repeat count too long → message quotes the text", "[unit][deck]") {
  const std::string text = content_of(kFolder / "repeat_too_long.txt");
  for (const auto& [written, said] : {std::pair{"7*293.15", "1 is ignored"},
                                      {"9*293.15", "3 are ignored"},
                                      {"2000000000*293.15", "1999999994 are ignored"}}) {
    INFO(written);
    bool found = false;
    for (const Issue& issue :
         read_deck_text(replaced(text, "9*293.15", written), "DATA.txt").issues)
      found = found || issue.message.find(said) != std::string::npos;
    CHECK(found);
  }
}

TEST_CASE("record labels: a label that names another record → warning, for every record",
          "[unit][deck]") {
  std::set<std::string> seen;
  int warned = 0, misread = 0;
  for (const Deck& deck : deck_variants::all()) {
    for (std::size_t i = 0; i < deck.records.size(); ++i) {
      const std::string id = deck.records[i].id;
      if (id == "12" || !seen.insert(id).second) continue;
      for (const RecordSpec& other : schema()) {
        // All neighbors, and every seventh of the rest.
        const auto apart = &other - find_record(id);
        if (apart == 0 || other.id == "12" || (std::abs(apart) > 2 && apart % 7 != 0)) continue;
        Deck changed = deck;
        changed.records[i].values[0][0] = "Rec " + std::string(other.id);
        const ReadResult back = read_deck_text(write_deck(changed), "x");
        CAPTURE(id, other.id, adore::to_text(back.issues));
        const bool named =
            std::any_of(back.issues.begin(), back.issues.end(), [&](const Issue& issue) {
              return issue.severity == Severity::Warning && issue.record == id &&
                     issue.message.find("the label names record") != std::string::npos;
            });
        const bool error =
            std::any_of(back.issues.begin(), back.issues.end(),
                        [](const Issue& issue) { return issue.severity == Severity::Error; });
        CHECK((named || error));  // a label that misleads the reader ends in an error
        ++(named ? warned : misread);
      }
    }
    // Labels as the program writes them, and those of instances, raise nothing.
    for (const Issue& issue : read_deck_text(write_deck(deck), "x").issues)
      CHECK(issue.message.find("the label names record") == std::string::npos);
  }
  CHECK(seen.size() >= 100);
  CHECK(warned > 5 * misread);
}
