#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "deck/deck.hpp"
#include "design/bearing_candidates.hpp"
#include "runs/check.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::design;
using namespace adore::runs;

namespace {

CandidateReport of(const char* json) { return find_candidates(read_facts(json)); }

bool contradicts(const CandidateReport& report, const std::string& a, const std::string& b) {
  return std::any_of(report.contradictions.begin(), report.contradictions.end(),
                     [&](const Contradiction& one) {
                       return one.first.starts_with(a) && one.second.starts_with(b);
                     });
}

}  // namespace

TEST_CASE("candidates: size and both ratings of a 6203 → 8 balls of 6.747 mm first",
          "[unit][candidates]") {
  const CandidateReport report =
      of(R"({"designation": "6203", "C": "9.6 kN", "C0": "4.8 kN", "clearance": "C3"})");
  REQUIRE_FALSE(report.candidates.empty());
  const BearingCandidate& first = report.candidates.front();
  CHECK(first.count == 8);
  CHECK(first.diameter == Approx(6.747e-3).epsilon(1e-4));
  CHECK(first.pitch == Approx(28.5e-3));
  // Printed for this size: 3.0530, 4.9469, 0.3817, 1.9937.
  CHECK(first.BPFO == Approx(3.0530).epsilon(1e-3));
  CHECK(first.BPFI == Approx(4.9469).epsilon(1e-3));
  CHECK(first.FTF == Approx(0.3817).epsilon(1e-3));
  CHECK(first.BSF == Approx(1.9937).epsilon(1e-3));
  CHECK(first.C == Approx(9600).epsilon(0.03));
  CHECK(first.C0 == Approx(4800).epsilon(0.03));
  const deck::CatalogueBearing chosen = candidate_bearing(report, 1);
  const deck::Deck made = deck::read_deck_text(deck::catalogue_deck(chosen), "chosen").deck;
  CHECK(made.integer("nRe") == 8);
  CHECK(made.real("bReDia") == Approx(first.diameter));
  CHECK(made.real("freeIntCls") == Approx(18e-6));  // 11 to 25 um
  for (const Issue& issue : check_model(made)) CHECK(issue.severity != Severity::Error);
  CHECK_THROWS_AS(candidate_bearing(report, 0), InputError);
  CHECK_THROWS_AS(candidate_bearing(report, 100), InputError);
}

TEST_CASE("candidates: fault-frequency factors → pitch diameter and count", "[unit][candidates]") {
  const CandidateReport report = of(R"({"designation": "6205", "BPFO": 3.5848, "BPFI": 5.4152})");
  REQUIRE(report.candidates.size() == 1);
  CHECK(report.candidates[0].count == 9);
  CHECK(report.candidates[0].diameter / report.candidates[0].pitch ==
        Approx(1.0 - 2.0 * 3.5848 / 9.0).epsilon(1e-3));
  CHECK(report.candidates[0].factor_spread == 0.0);
  // A list that prints twice the spin is read so, with a note.
  const CandidateReport twice = of(R"({"designation": "6205", "BPFO": 3.5848, "BSF": 4.7135})");
  REQUIRE_FALSE(twice.candidates.empty());
  CHECK(twice.candidates[0].count == 9);
  CHECK(twice.candidates[0].BSF == Approx(2.3567).epsilon(5e-3));
  CHECK(twice.fact_use.front().find("twice") != std::string::npos);
}

TEST_CASE("candidates: roller length follows from C0", "[unit][candidates]") {
  // C0 = 44 (1 - D/dm) Z L D of 14 rollers of 10 x 9.6 mm on 65 mm: 50.1 kN.
  const double C0 = 44.0 * (1.0 - 10.0 / 65.0) * 14 * 9.6 * 10.0;
  CHECK(C0 == Approx(50.04e3).epsilon(1e-3));
  const CandidateReport report =
      of(R"({"designation": "NU209", "C0": "50.04 kN", "count": 14, "element_diameter": "10 mm"})");
  REQUIRE(report.candidates.size() == 1);
  CHECK(report.candidates[0].length == Approx(9.6e-3).epsilon(1e-3));
}

TEST_CASE("candidates: contradicting facts → the pair is named", "[unit][candidates]") {
  CHECK(
      contradicts(of(R"({"designation": "6205", "bore": "30 mm"})"), "designation = 6205", "bore"));
  CHECK(contradicts(of(R"({"designation": "6205", "type": "tapered"})"), "designation", "type"));
  CHECK(contradicts(of(R"({"designation": "7208 B", "contact_angle": "15 deg"})"), "designation",
                    "contact_angle"));
  CHECK(contradicts(of(R"({"designation": "6205", "C": "140 kN"})"), "C = 140", "the boundary"));
  CHECK(contradicts(of(R"({"designation": "6205", "C": "14 kN", "C0": "40 kN"})"), "C0 = 40",
                    "the boundary"));
  CHECK(contradicts(of(R"({"designation": "6205", "BPFO": 3.585, "FTF": 0.42})"), "BPFO", "FTF"));
  CHECK(contradicts(of(R"({"designation": "6205", "C0": "7.8 kN", "Cu": "3 kN"})"), "Cu", "C0"));
  CHECK(contradicts(of(R"({"designation": "6205", "mass": "2 kg"})"), "mass", "the boundary"));
  const CandidateReport report = of(R"({"designation": "6205", "BPFO": 3.585, "FTF": 0.42})");
  CHECK(report.candidates.empty());
  CHECK(candidates_text(report).find("CONTRADICTION") != std::string::npos);
}

TEST_CASE("candidates: too few facts → list of missing facts", "[unit][candidates]") {
  const CandidateReport report = of(R"({"C": "14 kN"})");
  CHECK(report.candidates.empty());
  CHECK(report.missing ==
        std::vector<std::string>{"designation or type", "bore", "outside", "width"});
  CHECK(candidates_text(report).find("Missing: designation or type") != std::string::npos);
  CHECK(of(R"({"type": "deep-groove", "bore": "25 mm", "outside": "52 mm"})").missing ==
        std::vector<std::string>{"width"});
}

TEST_CASE("candidates: the decisive fact separates the listed candidates", "[unit][candidates]") {
  const CandidateReport report = of(R"({"designation": "7208 B", "C": "36.5 kN", "C0": "26 kN"})");
  REQUIRE(report.candidates.size() > 1);
  CHECK(report.decisive.find("count") != std::string::npos);
  double sum = 0.0;
  for (const BearingCandidate& one : report.candidates) sum += one.weight;
  CHECK(sum == Approx(1.0));
}

TEST_CASE("facts: unknown members, missing units and values out of range → errors",
          "[unit][candidates]") {
  for (const char* wrong :
       {R"({"bor": "25 mm"})", R"({"bore": 25})", R"({"bore": "25"})", R"({"bore": "25 kg"})",
        R"({"bore": "-25 mm"})", R"({"bore": "0 mm"})", R"({"bore": "x mm"})", R"({"C": "14 mm"})",
        R"({"count": 8.5})", R"({"count": 0})", R"({"BPFO": "3.5"})", R"({"BPFO": -1})", "[1]",
        "nonsense", R"({"bore": "1e300 mm"})", R"({"bore": "mm 25"})"}) {
    INFO(wrong);
    CHECK_THROWS_AS(read_facts(wrong), InputError);
  }
  for (const char* wrong : {R"({"designation": "62O5"})", R"({"type": "plain"})",
                            R"({"designation": "6205", "clearance": "C9"})",
                            R"({"designation": "7208", "contact_angle": "95 deg"})"}) {
    INFO(wrong);
    CHECK_THROWS_AS(of(wrong), InputError);
  }
  const BearingFacts read = read_facts(
      R"({"bore": "1 in", "C": "1000 lbf", "contact_angle": "0.5 rad", "limiting_speed": "100 rad/s",
          "mass": "130 g"})");
  CHECK(*read.bore == Approx(0.0254));
  CHECK(*read.C == Approx(4448.2216));
  CHECK(*read.contact_angle == Approx(28.6479));
  CHECK(*read.limiting_speed == Approx(954.93));
  CHECK(*read.mass == Approx(0.13));
}

TEST_CASE("candidates: published bearings of the test set are listed as often as the page says",
          "[physics][candidates]") {
  const nlohmann::json data = nlohmann::json::parse(
      read_text_file(test::source_dir() / "tests/candidates/published_bearings.json"));
  int all = 0, listed = 0, close = 0;
  std::vector<std::size_t> counts;
  for (const nlohmann::json& b : data["bearings"]) {
    if (b.value("set", "") != "test" || !b.contains("element")) continue;
    BearingFacts facts;
    facts.type = b["type"];
    const auto mm = [&](const char* key) { return 1e-3 * b[key].get<double>(); };
    facts.bore = mm("bore");
    facts.outside = mm("outside");
    facts.width = mm("width");
    facts.C = b["C"].get<double>();
    facts.C0 = b["C0"].get<double>();
    const double angle = b["angle"].get<double>(), D = mm("element");
    if (angle > 0.0) facts.contact_angle = angle;
    const double pitch = b.contains("pitch") ? mm("pitch") : 0.5 * (*facts.bore + *facts.outside);
    const double BPFO = 0.5 * b["count"].get<int>() *
                        (1.0 - D / pitch * std::cos(angle * std::numbers::pi / 180.0));
    const CandidateReport report = find_candidates(facts);
    ++all;
    counts.push_back(report.candidates.size());
    const auto any = [&](auto test) {
      return std::any_of(report.candidates.begin(), report.candidates.end(), test) ? 1 : 0;
    };
    listed += any([&](const BearingCandidate& one) {
      return one.count == b["count"].get<int>() && std::abs(one.diameter / D - 1.0) < 0.01;
    });
    close +=
        any([&](const BearingCandidate& one) { return std::abs(one.BPFO / BPFO - 1.0) < 0.02; });
  }
  std::sort(counts.begin(), counts.end());
  CHECK(all >= 40);
  INFO(listed << " listed, " << close << " with BPFO within 2 %, of " << all);
  CHECK(listed >= 0.85 * all);
  CHECK(close >= 0.85 * all);
  CHECK(counts[counts.size() / 2] <= 5);
}
