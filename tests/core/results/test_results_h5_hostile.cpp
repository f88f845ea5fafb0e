#include "base/errors.hpp"
#include "fuzz/h5_blocks.hpp"
#include "results/convert.hpp"
#include "results/full_precision.hpp"
#include "results/h5_process.hpp"
#include "results/reader_killed.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <sys/resource.h>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
using Catch::Matchers::Contains;

namespace {

std::string file_of_steps(const bearing::Bearing& bearing, const std::filesystem::path& path,
                          long steps) {
  H5Writer writer = H5Writer::create(path, bearing, channel_table());
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  for (long step = 0; step < steps; ++step)
    writer.write(recorder.record(make_snapshot(bearing, step)));
  writer.flush();
  return read_bytes(path);
}

/// Everything that a reader can ask for.
void read_everything(const std::filesystem::path& path) {
  const H5Reader reader(path);
  (void)reader.step_numbers();
  for (const auto& info : reader.channels())
    if (reader.read(info.id).size() != reader.steps() * info.size())
      throw InternalError("a channel of another size than announced");
}

/// One byte of the first block of a kind, with the checksum made right again.
std::string with_byte(std::string file, const std::vector<H5Block>& blocks, std::string_view kind,
                      std::size_t offset, int value) {
  for (const H5Block& block : blocks) {
    if (block.kind != kind || offset + 4 >= block.size) continue;
    file[block.at + offset] = static_cast<char>(value);
    set_checksum(file, block);
  }
  return file;
}

}  // namespace

TEST_CASE("RESULTS.h5: forged bookkeeping with right checksums → message", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  const std::string good = file_of_steps(bearing, path, 5);
  const std::vector<H5Block> blocks = h5_blocks(good);
  std::map<std::string, int> kinds;
  for (const H5Block& block : blocks) ++kinds[block.kind];
  CAPTURE(blocks.size());
  REQUIRE(kinds["superblock"] == 1);
  REQUIRE(kinds["OHDR"] > 50);
  REQUIRE(kinds["EAHD"] > 50);
  REQUIRE(kinds["FRHP"] > 0);
  // Each of these broke HDF5 1.10.8: a division by a record size of zero, a node size of 2 GiB, an
  // element size that is none, a heap whose tables have no rows, a header size beyond the file.
  const auto [kind, offset, value] = GENERATE(table<std::string, std::size_t, int>({
      {"BTHD", 10, 0},          {"BTHD", 9, 0x80},        {"BTHD", 13, 0x80},  {"BTHD", 14, 0x7f},
      {"EAHD", 6, 0},           {"EAHD", 7, 0xff},        {"EAHD", 8, 0xff},   {"EAHD", 53, 0x4a},
      {"FRHP", 24, 0},          {"FRHP", 110, 0},         {"FRHP", 118, 0xff}, {"OCHK", 12, 0xff},
      {"OHDR", 6, 0xff},        {"OHDR", 5, 0xff},        {"OCHK", 6, 0xff},   {"superblock", 9, 0},
      {"superblock", 12, 0xff}, {"superblock", 36, 0xff}, {"BTLF", 6, 0xff},   {"EAIB", 14, 0x41},
  }));
  CAPTURE(kind, offset, value);
  const std::string forged = with_byte(good, blocks, kind, offset, value);
  REQUIRE((forged != good));
  write_bytes(path, forged);
  const std::string said = message_of([&] { read_everything(path); });
  if (said != "no error") {
    CHECK_THAT(said, Contains("RESULTS.h5: "));
    CHECK_THAT(said, Contains("damaged") || Contains("cannot be") || Contains("contains no"));
  }
}

TEST_CASE("RESULTS.h5: 300 random damages, half of them with right checksums → values or a message",
          "[unit][h5][slow]") {
  const bearing::Bearing bearing = make_bearing(2, false);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  const std::string good = file_of_steps(bearing, path, 3);
  const std::vector<H5Block> blocks = h5_blocks(good);
  std::mt19937 random(7);
  int refused = 0, read = 0;
  for (int k = 0; k < 300; ++k) {
    std::string bad = good;
    const H5Block& block = blocks[random() % blocks.size()];
    const std::size_t at = block.at + 4 + random() % (block.size - 4);
    bad[at] = static_cast<char>(random());
    if (k % 2 == 0) set_checksum(bad, block);
    write_bytes(path, bad);
    CAPTURE(k, block.kind, at - block.at);
    const std::string said = message_of([&] { read_everything(path); });
    ++(said == "no error" ? read : refused);
  }
  CAPTURE(refused, read);
  CHECK(refused > 150);
  CHECK(read > 3);
  struct rusage used {};
  ::getrusage(RUSAGE_CHILDREN, &used);
#ifndef __SANITIZE_ADDRESS__
  CHECK(used.ru_maxrss < 500'000);  // [KiB], the largest of the children
#endif
}

TEST_CASE("RESULTS.h5: damaged → SOL1 keeps its digits, with the reason", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  const std::string good = file_of_steps(bearing, path, 4);
  {
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    SolWriter sol = SolWriter::create(folder / "SOL1", make_sol_header(bearing, 1, UnitSystem::SI),
                                      UnitSystem::SI);
    for (long step = 0; step < 4; ++step) sol.write(recorder.record(make_snapshot(bearing, step)));
  }
  SolFile exact = read_sol(folder / "SOL1");
  CHECK(use_full_precision(exact).why_not.empty());
  const std::vector<H5Block> blocks = h5_blocks(good);
  write_bytes(path, with_byte(good, blocks, "BTHD", 10, 0));
  SolFile file = read_sol(folder / "SOL1");
  CHECK_THAT(use_full_precision(file).why_not, Contains("RESULTS.h5: ") && Contains("damaged"));
  CHECK(file.steps.size() == 4);
}

TEST_CASE("RESULTS.h5: reader process does not respond → message", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  (void)file_of_steps(bearing, path, 4);
  h5::ReaderLimits limits;
  limits.silence = std::chrono::seconds(0);
  CHECK_THAT(message_of([&] { h5::ReaderProcess process(path, limits); }),
             Contains("did not end within 0 s"));
  CHECK(h5::ReaderProcess(path).content().steps == 4);
}

TEST_CASE("RESULTS.h5: reader process killed → message that does not blame the file",
          "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  (void)file_of_steps(bearing, path, 4);
  const auto last_child = [] {
    std::ifstream children("/proc/thread-self/children");
    pid_t child = 0, last = 0;
    while (children >> child) last = child;
    return last;
  };
  for (const int signal : {SIGKILL, SIGSEGV}) {
    h5::ReaderProcess process(path);
    const pid_t child = last_child();
    REQUIRE(child > 0);
    REQUIRE(kill(child, signal) == 0);
    const auto read = [&] { (void)process.read("time", 1, 0, 4, 1); };
    if (signal == SIGKILL) {
      CHECK_THROWS_AS(read(), ReaderKilled);
    } else {
      CHECK_THAT(message_of(read), Contains("the file is damaged"));
    }
  }
}

TEST_CASE("RESULTS.h5: impossible number of steps or step numbers → message", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  const std::string good = file_of_steps(bearing, path, 4);
  // The number of steps, 4 of 64 bits, is the first dimension of every dataset: behind the version
  // 2, the rank, and the flags of a simple dataspace with largest dimensions.
  const std::vector<H5Block> blocks = h5_blocks(good);
  std::string longer = good;
  for (const H5Block& block : blocks) {
    if (block.kind != "OHDR" && block.kind != "OCHK") continue;
    for (char rank = 1; rank <= 4; ++rank) {
      const std::string space{2, rank, 1, 1, 4, 0, 0, 0, 0, 0, 0, 0};
      const std::size_t at = good.find(space, block.at);
      if (at == std::string::npos || at + space.size() > block.at + block.size) continue;
      longer[at + 8] = 1;  // 2^32 + 4
      set_checksum(longer, block);
    }
  }
  write_bytes(path, longer);
  CHECK_THAT(message_of([&] { read_everything(path); }), Contains("too short"));

  std::string strange = good;
  const double none = 1e300;
  // Steps 0 1 2 3 follow each other only in /step.
  double steps[] = {0.0, 1.0, 2.0, 3.0};
  const std::string wanted(reinterpret_cast<const char*>(steps), sizeof steps);
  for (std::size_t at = good.find(wanted); at != std::string::npos; at = good.find(wanted, at + 1))
    std::memcpy(strange.data() + at + 16, &none, 8);
  write_bytes(path, strange);
  CHECK_THAT(message_of([&] { read_everything(path); }), Contains("step number 1e+300 in row 3"));
}
