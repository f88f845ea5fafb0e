#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

namespace {

/// A motion and an equilibrium, each in a folder of its own.
struct Runs {
  Folder folder;
  std::string motion, statics;

  Runs() : motion((folder / "motion").string()), statics((folder / "statics").string()) {
    for (const auto& [run, example] :
         {std::pair{motion, "ball"}, std::pair{statics, "deep-groove-6205"}}) {
      fs::create_directories(run);
      REQUIRE(run_adore("new " + std::string(example) + " --out " + run + "/DATA.txt").code == 0);
      REQUIRE(run_adore("run " + run + " --quiet --set maxStps=40").code == 0);
    }
  }
  [[nodiscard]] Result report(const std::string& words) const {
    return run_adore("report --progress none " + words);
  }
};

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("report: two runs → results of RUN.json, pictures inside, equal bytes when repeated",
          "[cli]") {
  const Runs runs;
  const std::string one = (runs.folder / "one").string(), two = (runs.folder / "two").string();
  const Result result = runs.report(runs.motion + " " + runs.statics + " --out " + one);
  INFO(result.out);
  REQUIRE(result.code == 0);
  const std::string html = read(fs::path(one) / "report.html");
  for (const std::string& run : {runs.motion, runs.statics}) {
    const json file = json::parse(read(fs::path(run) / "RUN.json"));
    CHECK(contains(html, file["run"].get<std::string>()));
    for (const auto& [id, value] : file["summary"].items()) {
      INFO(id);
      if (value.is_number() && value != 0)
        // In the table of the run and in the comparison.
        CHECK(count(html, fmt::format(">{:.5g}</td>", value.get<double>())) >= 2);
    }
    for (const json& finding : file["findings"])
      if (finding["severity"] == "warning")
        CHECK(contains(html, finding["sentence"].get<std::string>().substr(0, 40)));
  }
  CHECK(count(html, "<img ") >= 8);
  CHECK(count(html, "src=\"data:image/png;base64,") == count(html, "<img "));
  // With the colon, which no text of a picture has (base64).
  CHECK_FALSE(contains(html, "http:"));
  CHECK_FALSE(contains(html, "https:"));
  const std::string pdf = read(fs::path(one) / "report.pdf");
  CHECK(pdf.starts_with("%PDF-"));
  REQUIRE(runs.report(runs.motion + " " + runs.statics + " --out " + two).code == 0);
  CHECK(html == read(fs::path(two) / "report.html"));
  CHECK(pdf == read(fs::path(two) / "report.pdf"));
}

TEST_CASE("report: a template selects parts; unknown parts and foreign files are rejected",
          "[cli]") {
  const Runs runs;
  const std::string out = (runs.folder / "out").string(),
                    mine = (runs.folder / "mine.html").string();
  write(mine, "<meta name=\"generator\" content=\"Adore\">{{#runs}}[{{run}}]{{/runs}}");
  REQUIRE(runs.report(runs.statics + " --template " + mine + " --out " + out).code == 0);
  CHECK(contains(read(fs::path(out) / "report.html"), "[6205 deep groove]"));

  write(mine, "{{#runs}}{{nothing}}{{/runs}}");
  const Result unknown = runs.report(runs.statics + " --template " + mine + " --out " + out);
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.out, "{{nothing}}"));
  CHECK(contains(unknown.out, "findings"));
  write(mine, "{{#runs}}{{run}}");
  CHECK(runs.report(runs.statics + " --template " + mine + " --out " + out).code == 2);

  const Result missing = runs.report((runs.folder / "nowhere").string() + " --out " + out);
  CHECK(missing.code == 2);
  CHECK(contains(missing.out, "has no RUN.json"));
  CHECK(runs.report("--out " + out).code == 2);

  write(fs::path(out) / "report.html", "somebody else's page");
  const Result foreign = runs.report(runs.statics + " --out " + out);
  CHECK(foreign.code == 2);
  CHECK(read(fs::path(out) / "report.html") == "somebody else's page");

  write(fs::path(runs.statics) / "RUN.json", R"({"program": "Adore 9", "summary": 3})");
  const Result damaged = runs.report(runs.statics + " --out " + (runs.folder / "new").string());
  CHECK(damaged.code == 2);
  CHECK(contains(damaged.out, "damaged"));
}

TEST_CASE("report: a deck changed after the run is not described", "[cli]") {
  const Runs runs;
  const std::string out = (runs.folder / "out").string();
  REQUIRE(runs.report(runs.statics + " --out " + out).code == 0);
  CHECK(contains(read(fs::path(out) / "report.html"), "quasi-static solution only"));
  const fs::path deck = fs::path(runs.statics) / "DATA.txt";
  fs::last_write_time(deck, fs::last_write_time(deck) + std::chrono::hours(1));
  REQUIRE(runs.report(runs.statics + " --out " + out).code == 0);
  const std::string html = read(fs::path(out) / "report.html");
  CHECK_FALSE(contains(html, "quasi-static solution only"));
  CHECK(contains(html, "changed after the run"));
}

TEST_CASE("animate: --colour is the old name of --color", "[cli]") {
  const Runs runs;
  std::string pictures[2];
  for (const int i : {0, 1}) {
    const fs::path out = runs.folder / std::to_string(i);
    REQUIRE(run_adore("animate " + runs.motion + " --frame 2 --out " + out.string() +
                      (i == 0 ? " --color load" : " --colour load"))
                .code == 0);
    for (const auto& file : fs::directory_iterator(out)) pictures[i] += read(file.path());
  }
  CHECK(pictures[0].size() > 10'000);
  CHECK(pictures[0] == pictures[1]);
}
