#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

#include <regex>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

namespace {

/// glibc then picks the variants of a processor without fused multiply-add.
constexpr const char* kOlderProcessor = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4";

bool built_with_portable_math() {
  const Folder folder;
  new_ball_deck(folder);
  const Result run =
      run_adore("run " + folder.path().string() + " --until 0.001rev --reproducible");
  if (run.code != 0) CHECK(contains(run.out, "musl-dev"));
  return run.code == 0;
}

/// Without the pages of measured times, which the last page of PRINT.txt ends with.
std::string without_times(const std::string& print) {
  return print.substr(0, print.find("Cost: computing time"));
}

}  // namespace

TEST_CASE("reproducible run → same bytes on all processors", "[cli]") {
  if (!built_with_portable_math()) return;
  const Folder folder;
  new_ball_deck(folder);
  const auto run_into = [&](const std::string& name, const std::string& environment) {
    const Result run =
        run_adore("run " + folder.path().string() +
                      " --reproducible --quiet --until 0.2rev --out " + (folder / name).string(),
                  environment);
    INFO(run.out);
    REQUIRE(run.code == 0);
  };
  run_into("here", "");
  run_into("older", kOlderProcessor);
  run_into("asked", "ADORE_ISA=avx2");  // the option has the last word
  for (const char* other : {"older", "asked"}) {
    for (const char* name :
         {"SOL1", "SOL2", "SOL3", "SOL4", "SOL7", "SOL8", "FINAL", "RESULTS.h5"}) {
      INFO(other << ' ' << name);
      CHECK(read(folder / "here" / name) == read(folder / other / name));
    }
    CHECK(without_times(read(folder / "here" / "PRINT.txt")) ==
          without_times(read(folder / other / "PRINT.txt")));
    json a = json::parse(read(folder / "here" / "RUN.json")),
         b = json::parse(read(folder / other / "RUN.json"));
    a.erase("measured");
    b.erase("measured");
    CHECK(a == b);
  }
  const json arithmetic = json::parse(read(folder / "here" / "RUN.json")).at("arithmetic");
  CHECK(arithmetic.at("instruction set of the contacts") == "baseline");
  CHECK(contains(arithmetic.at("math functions"), "identical on every processor"));
}

TEST_CASE("the equilibrium is the same to the last bit with and without FMA in glibc", "[cli]") {
  if (!built_with_portable_math()) return;
  const Folder folder;
  for (const std::string type : {"angular-218", "tapered-30208", "spherical-22210"}) {
    REQUIRE(run_adore("new " + type + " --out " + (folder / (type + ".txt")).string()).code == 0);
    json found[2];
    for (int k = 0; k < 2; ++k) {
      const std::string out = (folder / (type + std::to_string(k))).string();
      REQUIRE(run_adore("run " + (folder / (type + ".txt")).string() + " --quiet --out " + out,
                        k == 0 ? "" : kOlderProcessor)
                  .code == 0);
      found[k] = json::parse(read(fs::path(out) / "RUN.json"));
      found[k].erase("measured");
    }
    INFO(type);
    CHECK(found[0] == found[1]);
  }
}

TEST_CASE("PRINT and RUN.json → name of the arithmetic", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  REQUIRE(
      run_adore("run " + folder.path().string() + " --quiet --until 0.01rev", "ADORE_ISA=baseline")
          .code == 0);
  const std::string print = read(folder / "PRINT.txt");
  CHECK(contains(print, "Arithmetic settings (they affect the last digits of the results)"));
  CHECK(std::regex_search(print, std::regex("instruction set of the contacts[ .]*baseline")));
  CHECK(contains(print, "about 3e-6 of the loads after"));
  const json arithmetic = json::parse(read(folder / "RUN.json")).at("arithmetic");
  CHECK(arithmetic.at("instruction set of the contacts") == "baseline");
  CHECK(arithmetic.contains("note"));
}

TEST_CASE("no function that glibc has in variants is called from outside the program", "[cli]") {
  if (!built_with_portable_math()) return;
  FILE* pipe = popen(("nm -D --undefined-only " + program("adore").string()).c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string symbols;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
    symbols.append(buffer.data(), n);
  if (pclose(pipe) != 0) return;  // no binutils here
  REQUIRE(contains(symbols, " U "));
  // Of sysdeps/x86_64/fpu/multiarch, and what is computed from those.
  for (const char* name :
       {"asin",  "acos",  "atan",   "atan2",  "exp",     "exp2",  "log",  "log2",
        "pow",   "sin",   "cos",    "sincos", "tan",     "sinf",  "cosf", "sincosf",
        "expf",  "exp2f", "logf",   "log2f",  "powf",    "sinh",  "cosh", "tanh",
        "asinh", "acosh", "atanh",  "log10",  "log1p",   "expm1", "cbrt", "hypot",
        "erf",   "erfc",  "tgamma", "lgamma", "lgamma_r"}) {
    INFO(name);
    CHECK_FALSE(contains(symbols, std::string(" U ") + name + "@"));
  }
}
