#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

#include <regex>
#include <vector>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

namespace {

/// Runs an example deck quasi-statically and keeps what it says and writes.
struct StaticRun {
  Folder folder;
  Result result;
  std::string print;

  StaticRun(const std::string& example, const std::string& arguments) {
    const std::string deck = (folder / "deck.txt").string();
    REQUIRE(run_adore("new " + example + " --out " + deck).code == 0);
    result = run_adore("run " + deck + " " + arguments);
    INFO(result.out);
    REQUIRE(result.code == 0);
    print = read(folder / "PRINT.txt");
  }
};

/// Pages of a listing with that title, without those that only continue it.
std::vector<std::string> pages(const std::string& print, const std::string& title) {
  std::vector<std::string> out;
  std::size_t at = print.find('\f');
  while (at != std::string::npos) {
    const std::size_t next = print.find('\f', at + 1);
    const std::string page = print.substr(at, next == std::string::npos ? next : next - at);
    if (contains(page.substr(0, page.find('\n')), title)) out.push_back(page);
    at = next;
  }
  return out;
}

}  // namespace

TEST_CASE("a quasi-static run ends with its results and says its notes on the terminal", "[cli]") {
  const StaticRun run("cylindrical-nu209", "--set appLoadZ=50.");
  for (const char* text :
       {"displacement of the inner race: x ",
        "largest contact load: ", "largest pressure: ", " Pa (roller ",
        "life at 90 % survival: ", "quasi-static solution computed in", "is not stable"})
    CHECK(contains(run.result.out, text));
  CHECK_FALSE(contains(run.result.out, "0 steps"));
  const StaticRun split("deep-groove-6205", "--set shimThickness2=2e-4");
  CHECK(contains(split.result.out, "split inner race"));
  const StaticRun english("ball-english", "--set mode=-1");
  for (const char* text : {" in, y ", " lbf (ball ", " lbf/in^2 (ball "})
    CHECK(contains(english.result.out, text));
}

TEST_CASE("the quasi-static summary fits one page in SI and in English units", "[cli]") {
  struct Case {
    const char *example, *arguments;
    std::vector<std::string> parts;
  };
  const std::vector<std::string> always{"displacement",
                                        "load from the shaft",
                                        "stiffness in this direction",
                                        "largest contact load",
                                        "largest pressure",
                                        "loaded ",
                                        "diametral clearance",
                                        "inner race on shaft",
                                        "Original Lundberg-Palmgren",
                                        "ISO 281",
                                        "ISO 16281",
                                        "calibrated",
                                        "Warnings: ",
                                        "Datum of displacements"};
  for (const Case& c : {Case{"angular-218", "", {"free contact angle", "ball 1", "N/m"}},
                        Case{"ball-english", "--set mode=-1", {"lbf/in", "cage: ", "ball "}},
                        Case{"ball", "--set mode=-1", {"cage: ", "pocket clearance"}},
                        Case{"cylindrical-nu209", "", {"roller 1", "at a corner or land edge"}},
                        Case{"spherical-22210", "", {"roller "}}}) {
    INFO(c.example);
    const StaticRun run(c.example, c.arguments);
    const auto found = pages(run.print, "QUASI-STATIC SOLUTION: SUMMARY");
    REQUIRE(found.size() == 1);  // a second one would be its continuation
    INFO(found[0]);
    for (const std::string& part : always) CHECK(contains(found[0], part));
    for (const std::string& part : c.parts) CHECK(contains(found[0], part));
    CHECK_FALSE(contains(found[0], "nan"));
    // It leads the quasi-static part.
    CHECK(run.print.find("SOLUTION: SUMMARY") < run.print.find("QUASI-STATIC EQUILIBRIUM"));
    CHECK(run.print.find("QUASI-STATIC EQUILIBRIUM") < run.print.find("OPERATING FITS"));
  }
}

TEST_CASE("the datum of displacements is printed, and the 6205 example carries a pure radial load",
          "[cli]") {
  const StaticRun run("deep-groove-6205", "");
  CHECK(contains(run.print, "At x = 0, the planes of the"));
  const json summary = json::parse(read(run.folder / "RUN.json")).at("summary");
  CHECK(std::abs(summary.at("load_x_N").get<double>()) < 1e-6 * 1400.0);
  CHECK(summary.at("load_z_N").get<double>() == Approx(1400.0).epsilon(1e-9));
  const std::string page = pages(run.print, "SOLUTION: SUMMARY").at(0);
  // A radial load on a radial bearing has no contact angle.
  CHECK(std::regex_search(page, std::regex("largest contact angle +0 deg")));
  CHECK(std::regex_search(run.print, std::regex("Dynamic load rating C [^\n]* 140[0-9][0-9]")));
  // Below e the factors in use are 1 and 0.
  CHECK(std::regex_search(run.print, std::regex("    X +1\n")));
  CHECK(std::regex_search(run.print, std::regex("    Y +0\n")));
}

TEST_CASE("soft balls yield: said on the terminal, on the page and in RUN.json; no false limit",
          "[cli]") {
  const StaticRun brass("deep-groove-6205", "--set kReMat=161");
  const std::regex sentence("ball \\d+ \\(Brass[^)]*\\)+ yields at the contact of ball");
  CHECK(std::regex_search(brass.result.out, sentence));
  CHECK(contains(pages(brass.print, "SOLUTION: SUMMARY").at(0), "yields at the contact"));
  CHECK(contains(read(brass.folder / "RUN.json"), "yields at the contact"));
  CHECK(std::regex_search(
      brass.print,
      std::regex("Fatigue limit stress \\(von Mises\\) +N/m\\^2|Pa +- +6\\.84e\\+08")));
  const StaticRun steel("deep-groove-6205", "");
  CHECK_FALSE(contains(steel.result.out, "yields"));
}

TEST_CASE("the plan of a quasi-static deck names its unknowns and switches", "[cli]") {
  const Folder folder;
  const auto plan = [&](const std::string& example, const std::string& arguments) {
    const std::string deck = (folder / (example + ".txt")).string();
    if (!fs::exists(deck)) REQUIRE(run_adore("new " + example + " --out " + deck).code == 0);
    const Result result = run_adore("plan " + deck + " " + arguments);
    INFO(result.out);
    REQUIRE(result.code == 0);
    return result.out;
  };
  const auto line = [](const std::string& text, const std::string& pattern) {
    INFO(text);
    INFO(pattern);
    return std::regex_search(text, std::regex(pattern));
  };
  const std::string ball = plan("angular-218", "");
  CHECK(line(ball, "total +35\n"));  // 16 balls of 2, and x, y, z
  CHECK(line(ball, "unknown: x \\(kFS1 = 0\\), y \\(kFS2 = 0\\), z \\(kFS3 = 0\\)"));
  CHECK(line(ball, "on +ball / race contact"));
  CHECK(line(ball,
             "on +ball speeds +friction equilibrium .*kAngVel = 1.*, spin axis from race control"));
  CHECK(line(plan("angular-218", "--opt ballFriction=spin-rule"),
             "on +ball speeds +kAngVel = 1: .*race control"));
  CHECK(line(ball, "on +stiffness over speed +kStif = 11"));
  CHECK(line(ball, "off +fits of the races"));
  CHECK(line(ball, "equilibrium +[0-9.e+-]+ ms, \\d+ iterations"));
  const std::string free = plan("angular-218", "--set kFS4=0 --set kFS5=0 --set raceFit2=1e-6");
  CHECK(line(free, "total +37\n"));
  CHECK(line(free, "on +fits of the races"));
  const std::string roller = plan("cylindrical-nu209", "--opt rollerSlices=15");
  CHECK(line(roller, "on +roller / race contact +.*in 15 slices"));
}

TEST_CASE("the stiffness table gives clearance and angle at each speed and warns of lost clearance",
          "[cli]") {
  const StaticRun run("angular-218", "--set kStif=3 --set rpmRange12=0. --set rpmRange22=12000.");
  const std::regex clearance("Diametral clearance at this speed +([0-9.e-]+) +m");
  std::vector<double> found;
  for (std::sregex_iterator at(run.print.begin(), run.print.end(), clearance), end; at != end; ++at)
    found.push_back(std::stod((*at)[1]));
  REQUIRE(found.size() == 3);
  CHECK(found[0] > found[1]);  // the inner race grows with the square of its speed
  CHECK(found[0] - found[2] == Approx(4.0 * (found[0] - found[1])).epsilon(0.01));
  CHECK(contains(run.print, "Free contact angle at this speed"));
  const StaticRun tight("deep-groove-6205",
                        "--set kStif=2 --set pctDisp=1. --set rpmRange11=0. "
                        "--set rpmRange21=0. --set rpmRange12=3000. --set "
                        "rpmRange22=80000.");
  CHECK(contains(tight.print, "Warning: the diametral clearance becomes negative"));
  CHECK(contains(
      tight.result.out,
      "stiffness over speed: from rpm1 = 0 and rpm2 = 80000 upwards, the diametral clearance"));
}
