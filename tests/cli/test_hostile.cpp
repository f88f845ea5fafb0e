#include "driver.hpp"
#include "support/paths.hpp"

#include <sys/resource.h>

using namespace adore::test;

namespace {

/// Exit code 2 and a message that contains `part` and does not mention a bug.
void refused(const Result& result, const std::string& part) {
  CAPTURE(result.out);
  CHECK(result.code == 2);
  CHECK(contains(result.out, part));
  CHECK_FALSE(contains(result.out, "bug"));
}

}  // namespace

TEST_CASE("options: numbers out of range → rejected with their range", "[cli]") {
  Folder folder;
  new_ball_deck(folder);
  const std::string deck = " " + folder.path().string() + " ";
  refused(run_adore("run" + deck + "--threads -3"),
          "--threads is -3; give a number from 0 to 1024");
  refused(run_adore("run" + deck + "--threads 1000000"), "--threads");
  refused(run_adore("accuracy" + deck + "--tols 1"),
          "--tols is 1; give a number from 1e-14 to 0.01");
  refused(run_adore("accuracy" + deck + "--tols 1e-4,1e-30"), "--tols is 1e-30");
  refused(run_adore("accuracy" + deck + "--turns 1e300"), "--turns");
  for (const char* turns : {"0", "-1", "nan", "1e300"})
    refused(run_adore("plan" + deck + "--what-if --turns " + turns),
            std::string("--turns is ") + (turns == std::string("1e300") ? "1e+300" : turns) +
                "; give a number from 0.01 to 1000000");
  if (contains(run_adore("plot none --out none").out, "ADORE_WITH_QT")) return;  // no pictures
  const std::string to = " --out " + (folder / "p").string();
  refused(run_adore("plot none" + to + " --page 0"), "--page is 0; give a number from 1");
  refused(run_adore("plot none" + to + " --from 0"), "--from is 0");
  refused(run_adore("plot none" + to + " --every -1"), "--every is -1");
  refused(run_adore("animate none --frame 0"), "--frame is 0");
  refused(run_adore("animate none --fps 0"), "--fps is 0");
  refused(run_adore("animate none --movie film.gif --slow 0"), "--slow is 0");
}

TEST_CASE("calculators: inputs out of range → rejected, no access outside", "[cli]") {
  const std::string corpus = adore::test::source_dir().string() + "/tests/fuzz/corpus/calc/";
  Folder folder;
  // Each file of the corpus is a line with the calculator, then its inputs.
  for (const char* name : {"flange_end", "corner_end", "laminae", "negative_life", "slices"}) {
    const std::string text = read(corpus + name);
    const std::size_t end = text.find('\n');
    write(folder / "IN.json", text.substr(end));
    refused(run_adore("calc " + text.substr(0, end) + " --json " + (folder / "IN.json").string()),
            "");
  }
}

TEST_CASE("deeply nested JSON → rejected by all readers", "[cli]") {
  Folder folder;
  new_ball_deck(folder);
  const std::string deep(50000, '[');
  write(folder / "deep.json", "{\"a\": " + deep);
  const std::string file = " " + (folder / "deep.json").string();
  refused(run_adore("convert" + file + " --to csv"), "64 levels");
  refused(run_adore("show" + file), "64 levels");
  refused(run_adore("validate" + file), "64 levels");
  refused(run_adore("calc hertz --json" + file), "64 levels");
  write(folder / "ADORE.json", deep);
  refused(run_adore("plan " + folder.path().string()), "64 levels");
}

TEST_CASE("ADORE.json: unreadable → rejected, not skipped", "[cli]") {
  Folder folder;
  new_ball_deck(folder);
  std::filesystem::create_directory(folder / "ADORE.json");
  refused(run_adore("plan " + folder.path().string()), "ADORE.json");
  CHECK(run_adore("check " + folder.path().string()).code == 2);
  std::filesystem::remove(folder / "ADORE.json");
  std::filesystem::create_symlink("nowhere", folder / "ADORE.json");
  refused(run_adore("plan " + folder.path().string()), "ADORE.json");
  std::filesystem::remove(folder / "ADORE.json");
  CHECK(run_adore("plan " + folder.path().string()).code == 0);
}

TEST_CASE("residual stress without a material → rejected", "[cli]") {
  Folder folder;
  new_ball_deck(folder);
  for (const char* value : {"1e100", "-1e100", "1e308"})
    refused(run_adore("plan " + folder.path().string() + " --set res2=" + value), "res2");
  CHECK(run_adore("plan " + folder.path().string() + " --set res2=-2e8").code == 0);
  CHECK(run_adore("plan " + folder.path().string() + " --set res2=1e10").code != 1);
}

TEST_CASE("fifteen megabytes of blank lines → rejected with little memory", "[cli]") {
  Folder folder;
  write(folder / "DATA.txt", std::string(15'000'000, '\n') + "'Rec 1', 0");
  refused(run_adore("check " + (folder / "DATA.txt").string()), "15000000 lines");
  struct rusage used {};
  ::getrusage(RUSAGE_CHILDREN, &used);
#ifndef __SANITIZE_ADDRESS__
  CHECK(used.ru_maxrss < 150'000);  // [KiB]
#endif
}
