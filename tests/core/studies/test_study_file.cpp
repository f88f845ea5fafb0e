#include "base/errors.hpp"
#include "studies/points.hpp"
#include "studies/study.hpp"
#include "studies/study_check.hpp"
#include "studies/study_splice.hpp"
#include "studies/study_text.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace adore;
using namespace adore::studies;
using Catch::Contains;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

const std::string kSmall = R"({"adore_study": 1, "kind": "sweep", "deck": "DATA.txt",
  "variables": [{"name": "appLoadX", "grid": [500, 1500, 3]}],
  "quantities": ["largest_contact_load_N"]})";

}  // namespace

TEST_CASE("study file: every example is read, with its number of runs", "[unit][studies]") {
  const std::pair<const char*, long> expected[] = {{"sweep", 18},       {"tolerance", 600},
                                                   {"cage-map", 25},    {"sensitivity", 25},
                                                   {"worst-case", 145}, {"what-if", 4}};
  for (const auto& [kind, runs] : expected) {
    INFO(kind);
    Study study = parse_study(example_study(kind), "study.json");
    CHECK(kind_name(study.kind) == kind);
    expand_lots(study, 12);
    CHECK(count_points(study) == runs);
  }
  CHECK_THROWS_WITH(example_study("swep"), Contains("sweep, tolerance, cage-map"));
}

TEST_CASE("study file: error → sentence with file, key, value and valid values",
          "[unit][studies]") {
  const auto refused = [](const std::string& from, const std::string& to) {
    try {
      (void)parse_study(replaced(kSmall, from, to), "a.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK_THAT(refused("\"sweep\"", "\"swep\""),
             Contains("a.json: kind = \"swep\"") && Contains("most similar name is \"sweep\""));
  CHECK_THAT(refused("appLoadX", "apLoadX"),
             Contains("a.json: variables[1].name = \"apLoadX\"") && Contains("\"appLoadX\""));
  CHECK_THAT(refused("[500, 1500, 3]", "[500, 1500]"),
             Contains("variables[1].grid = [500,1500]") && Contains("[first, last, count]"));
  CHECK_THAT(refused("[500, 1500, 3]", "[500, 1500, 2.5]"), Contains("count from 2"));
  CHECK_THAT(refused("\"grid\": [500, 1500, 3]", "\"grd\": [500, 1500, 3]"),
             Contains("exactly one of \"grid\", \"list\", \"uniform\" and \"normal\""));
  CHECK_THAT(refused("largest_contact_load_N", "largest_contact_load"),
             Contains("quantities[1] = \"largest_contact_load\"") &&
                 Contains("most similar name is \"largest_contact_load_N\""));
  CHECK_THAT(refused("\"deck\": \"DATA.txt\",", "\"deck\": \"DATA.txt\", \"untill\": \"5rev\","),
             Contains("a.json: untill is not used here") && Contains("do you mean \"until\""));
  CHECK_THAT(refused("\"deck\": \"DATA.txt\",", ""), Contains("a.json: deck is missing"));
  CHECK_THAT(refused("\"grid\": [500, 1500, 3]", "\"normal\": [500, -1]"),
             Contains("variables[1].normal = [500,-1]") && Contains("above 0"));
  CHECK_THAT(refused("\"grid\": [500, 1500, 3]", "\"uniform\": [500, 600]"),
             Contains("sampling.runs is missing"));
  CHECK_THAT(refused("\"adore_study\": 1", "\"adore_study\": 2"), Contains("adore_study = 2"));
  CHECK_THAT(refused("[\"largest_contact_load_N\"]",
                     R"([{"channel": "contact.lod", "statistic": "mean"}])"),
             Contains("channel = \"contact.lod\"") && Contains("\"contact.load\""));
  CHECK_THAT(refused("[\"largest_contact_load_N\"]",
                     R"([{"channel": "contact.load", "statistic": "median"}])"),
             Contains("statistic = \"median\"") && Contains("percentile"));
  CHECK_THAT(refused("[\"largest_contact_load_N\"]",
                     R"([{"channel": "contact.load", "statistic": "mean", "window": [0.5, 1.5]}])"),
             Contains("window = [0.5,1.5]") && Contains("from 0 to 1"));
  CHECK_THAT(refused("{\"adore_study\"", "{{"), Contains("a.json") && Contains("JSON"));
}

TEST_CASE("study points: grids in all combinations, the last one fastest, with all samples",
          "[unit][studies]") {
  Study study = parse_study(
      R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
      "variables": [{"name": "appLoadX", "list": [1, 2]}, {"name": "freeConAng", "normal": [25, 1]},
                    {"name": "rpm2", "list": [10, 20, 30]}],
      "sampling": {"runs": 2}, "bearing_seeds": [4, 5],
      "quantities": ["largest_contact_load_N"]})",
      "a.json");
  const auto points = make_points(study);
  REQUIRE(points.size() == 24);
  CHECK(columns_of(study).names ==
        std::vector<std::string>{"appLoadX", "rpm2", "freeConAng", "seed"});
  CHECK(points[0].values[1] == 10.0);
  CHECK(points[4].values[1] == 20.0);
  CHECK(points[12].values[0] == 2.0);
  // The same samples everywhere: differences between grid points are not scatter.
  CHECK(points[0].values[2] == points[4].values[2]);
  CHECK(points[0].values[2] != points[2].values[2]);
  CHECK(points[1].options == Settings{{"seed", "5"}});
  CHECK(points[0].sets.front() == std::pair<std::string, std::string>{"appLoadX", "1"});
}

TEST_CASE("study points: lots have the specified distribution and correlation", "[unit][studies]") {
  Study study = parse_study(
      R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
      "variables": [{"name": "reDiaVar#", "normal": [1e-6, 2e-7], "common": 0.4},
                    {"name": "freeConAng", "normal": [25, 1], "within": [24, 26]},
                    {"name": "raceCurFac1", "uniform": [0.51, 0.53]}],
      "correlation": [["freeConAng", "raceCurFac1", 0.7]],
      "sampling": {"method": "random", "runs": 4000},
      "quantities": ["largest_contact_load_N"]})",
      "a.json");
  expand_lots(study, 4);
  const auto points = make_points(study);
  const auto n = static_cast<double>(points.size());
  const auto mean = [&](auto&& f) {
    double sum = 0.0;
    for (const Point& point : points) sum += f(point.values) / n;
    return sum;
  };
  using V = std::vector<double>;
  const auto score = [](double v) { return (v - 1e-6) / 2e-7; };
  // Standard errors: 1/√n = 0.016 of a mean, √(2/n) = 0.022 of a variance; four of them.
  CHECK(mean([&](const V& v) { return score(v[0]); }) == Approx(0.0).margin(0.063));
  CHECK(mean([&](const V& v) { return score(v[3]) * score(v[3]); }) == Approx(1.0).margin(0.089));
  CHECK(mean([&](const V& v) { return score(v[1]) * score(v[2]); }) == Approx(0.4).margin(0.068));
  // Cut at one deviation to both sides: variance 1 - 2 φ(1)/(2Φ(1) - 1) = 0.29112509.
  CHECK(mean([&](const V& v) { return v[4] - 25.0; }) == Approx(0.0).margin(0.034));
  CHECK(mean([&](const V& v) { return (v[4] - 25.0) * (v[4] - 25.0); }) ==
        Approx(0.29112509).margin(0.02));
  // Rank correlation of a Gaussian copula: 6/π asin(ρ/2) = 0.6829; here by shares of both.
  const auto uniform = [](double v) { return (v - 0.51) / 0.02; };
  CHECK(mean([&](const V& v) { return uniform(v[5]); }) == Approx(0.5).margin(0.018));
  double least = 1.0, largest = 0.0, low = 25.0, high = 25.0;
  for (const Point& point : points) {
    least = std::min(least, point.values[5]);
    largest = std::max(largest, point.values[5]);
    low = std::min(low, point.values[4]);
    high = std::max(high, point.values[4]);
  }
  CHECK(low >= 24.0);
  CHECK(high <= 26.0);
  CHECK(least >= 0.51);
  CHECK(largest <= 0.53);
}

TEST_CASE("study file: TOML and JSON → same study and remarks", "[unit][studies]") {
  for (const char* kind :
       {"sweep", "tolerance", "cage-map", "sensitivity", "worst-case", "what-if"}) {
    INFO(kind);
    const auto json = read_study_text(example_study(kind), "a.json").json;
    CHECK(read_study_text(write_study_text(json, false), "a.json").json == json);
    const StudyText toml = read_study_text(write_study_text(json, true), "a.toml");
    CHECK_FALSE(toml.loose_comments);
    auto plain = toml.json, wanted = json;
    for (auto* one : {&plain, &wanted})
      for (auto item = one->begin(); item != one->end();)
        item = item.key().starts_with("//") ? one->erase(item) : std::next(item);
    CHECK(plain == wanted);
    CHECK(
        write_study_text(toml.json, true) ==
        write_study_text(read_study_text(write_study_text(toml.json, true), "a.toml").json, true));
    CHECK(count_points(parse_study(write_study_text(json, true), "a.toml")) ==
          count_points(parse_study(example_study(kind), "a.json")));
  }
  CHECK(read_study_text("a = 1 # behind a value\n", "a.toml").loose_comments);
}

TEST_CASE("study file: TOML value changed → changed in place, comments kept", "[unit][studies]") {
  const std::string text =
      "# of the spring\n"
      "kind = \"sweep\"   # what it is\n"
      "deck = \"Große/DATA.txt\" # umlaut before\n"
      "variables = [  # two of them\n"
      "  {name = \"appLoadX\", grid = [500, 1500, 3]}, # thrust\n"
      "  # the speed\n"
      "  {name = \"raceVel[2]\", list = [1000, 2000]} # rpm\n"
      "]\n"
      "quantities = [\"L10_hours\"]  # one\n"
      "\n"
      "[budget]  # no more\n"
      "runs = 50 # small\n";
  const std::filesystem::path file = "a.toml";
  const auto values = read_study_text(text, file).json;
  const auto edited = [&](auto&& change) {
    auto next = values;
    change(next);
    const EditedText out = edited_study_text(text, next, file);
    CHECK_FALSE(out.rewritten);
    return out.text;
  };
  CHECK(edited([](auto&) {}) == text);
  CHECK(edited([](auto& v) { v["deck"] = "b.txt"; }) ==
        replaced(text, "\"Große/DATA.txt\"", "\"b.txt\""));
  CHECK(edited([](auto& v) { v["budget"]["runs"] = 7; }) ==
        replaced(text, "runs = 50", "runs = 7"));
  CHECK(edited([](auto& v) { v["variables"][0]["grid"][1] = 2500; }) ==
        replaced(text, "1500", "2500"));
  // Another sort of range: the row alone is new.
  CHECK(edited([](auto& v) {
          v["variables"][1] = {{"name", "raceVel[2]"}, {"grid", {1, 2, 3}}};
        }) == replaced(text, "list = [1000, 2000]", "grid = [1, 2, 3]"));
  CHECK(edited([](auto& v) { v["quantities"].push_back("cage_force_N"); }) ==
        replaced(text, "\"L10_hours\"", "\"L10_hours\", \"cage_force_N\""));
  // Rows and keys come with a line, and go with it and what stood behind them.
  CHECK(edited([](auto& v) {
          v["variables"].push_back({{"name", "mode"}, {"list", {0, 1}}});
        }) ==
        replaced(text, "2000]} # rpm\n", "2000]}, # rpm\n  {name = \"mode\", list = [0, 1]}\n"));
  CHECK(edited([](auto& v) { v["variables"].erase(0); }) ==
        replaced(text, "  {name = \"appLoadX\", grid = [500, 1500, 3]}, # thrust\n", ""));
  CHECK(edited([](auto& v) { v["variables"].erase(1); }) ==
        replaced(text, "  {name = \"raceVel[2]\", list = [1000, 2000]} # rpm\n", ""));
  CHECK(edited([](auto& v) { v.erase("deck"); }) ==
        replaced(text, "deck = \"Große/DATA.txt\" # umlaut before\n", ""));
  CHECK(edited([](auto& v) { v["seed"] = 3; }) == replaced(text, "# one\n", "# one\nseed = 3\n"));
  CHECK(edited([](auto& v) { v["budget"]["hours"] = 2; }) == text + "hours = 2\n");
}

TEST_CASE("study file: TOML after any change → reads back equal", "[unit][studies]") {
  const std::string text =
      "kind = \"sweep\"\ndeck = \"a.txt\"\nbudget.runs = 5 # dotted\n"
      "[[variables]] # first\nname = \"appLoadX\" # thrust\ngrid = [500, 1500, 3]\n"
      "[[variables]]\nname = \"mode\"\nlist = [0, 1]\n";
  const std::filesystem::path file = "a.toml";
  const auto values = read_study_text(text, file).json;
  const auto check = [&](bool rewritten, auto&& change) {
    auto next = values;
    change(next);
    const EditedText out = edited_study_text(text, next, file);
    CHECK(out.rewritten == rewritten);
    CHECK(nlohmann::json(read_study_text(out.text, file).json) == nlohmann::json(next));
  };
  check(false, [](auto& v) { v["variables"][0]["grid"][0] = 1; });
  check(false, [](auto& v) { v["variables"][1]["name"] = "kDOF"; });
  check(false, [](auto& v) { v["budget"]["runs"] = 6; });
  check(true, [](auto& v) { v["variables"].erase(0); });
  check(true, [](auto& v) { v.erase("budget"); });
  check(false, [](auto& v) { v.erase("deck"); });
  // JSON has no comments to lose.
  CHECK(edited_study_text("{}", values, "a.json").rewritten);
}

TEST_CASE("study file: error in TOML → with its line", "[unit][studies]") {
  const std::string text =
      "adore_study = 1\nkind = \"sweep\"\ndeck = \"DATA.txt\"\n"
      "quantities = [\"largest_contact_load_N\"]\n\n"
      "[[variables]]\nname = \"appLoadX\"\ngrid = [500, 1500, 3]\n";
  CHECK(count_points(parse_study(text, "a.toml")) == 3);
  CHECK_THROWS_WITH(parse_study(replaced(text, "1500, 3", "1500, 1"), "a.toml"),
                    Contains("a.toml, line 8: variables[1].grid = [500,1500,1]: give [first"));
  CHECK_THROWS_WITH(parse_study(replaced(text, "grid", "grd"), "a.toml"),
                    Contains("a.toml, line 7: variables[1].name: give exactly one of \"grid\""));
  CHECK_THROWS_WITH(parse_study(replaced(text, "kind =", "kind"), "a.toml"),
                    Contains("a.toml, line 2: this is not valid TOML"));
}

TEST_CASE("named_key(): key of a sentence about a study", "[unit][studies]") {
  CHECK(key_in_message("b/a.json: variables[2].grid = [1]: give", "b/a.json") ==
        "variables[2].grid");
  CHECK(key_in_message("a.toml, line 4: kind is missing: give", "a.toml") == "kind");
  CHECK(key_in_message("a.json: a what-if study compares \"cases\"; remove", "a.json").empty());
  CHECK(key_in_message("there is no deck DATA.txt", "a.json").empty());
}

TEST_CASE("TOML text nested deeper than the limit → error with its line, no stack overflow",
          "[unit][studies]") {
  const auto parts = [](int count, const std::string& part, const std::string& between = ".") {
    std::string out = part;
    for (int i = 1; i < count; ++i) out += between + part;
    return out;
  };
  const auto outcome = [](const std::string& text) -> std::string {
    try {
      (void)read_study_text(text, "a.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "read";
  };
  const int deep = 12000;  // parts of a header that once ended the stack
  const std::vector<std::string> rejected = {
      "# comment\n[" + parts(deep, "a") + "]\nb = 1\n",
      "[[" + parts(deep, "a") + "]]\nb = 1\n",
      parts(deep, "a", " . ") + " = 1\n",
      parts(deep, "\"a.b\"") + " = 1\n",
      parts(deep, "'a'") + " = 1\n",
      "k = {" + parts(deep, "a") + " = 1}\n",
      "k = [[1], {x = {" + parts(deep, "a") + " = 1}}]\n",
      "[" + parts(40, "a") + "]\n" + parts(40, "b") + " = 1\n",
      "\xEF\xBB\xBF[" + parts(40, "a") + "]\n" + parts(40, "b") + " = 1\n",
      "t = \"\"\"\"\"x\"\"\"\"\"\n" + parts(deep, "a") + " = 1\n",
      "t = '''[''\n#'''\n" + parts(deep, "a") + " = 1\n",
      "t = \"\\\\\"\n" + parts(deep, "a") + " = 1\n",
      "t = " + std::string(deep, '[') + std::string(deep, ']') + "\n",
  };
  for (const std::string& text : rejected) {
    INFO(text.substr(0, 60));
    CHECK_THAT(outcome(text), Contains("nested more than 64 levels") && Contains("a.toml, line "));
  }
  CHECK_THAT(outcome(rejected.front()), Contains("line 2"));
  CHECK(outcome("[" + parts(64, "a") + "]\n") == "read");
  // Dots in numbers, texts and comments are no levels, nor are keys of other lines.
  CHECK(outcome("# " + parts(200, "a") + "\nt = \"" + parts(200, "a") + "\"\nl = [" +
                parts(200, "1.5", ", ") + "]\nm = \"\"\"" + parts(200, "a\n") +
                "\"\"\"\nx.y = 1\n") == "read");
  CHECK_THAT(outcome(std::string(2000, 'a') + " = 1\n"), Contains("more than 1000 bytes"));
}
