#include "base/errors.hpp"
#include "results/h5_layout.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <csignal>
#include <cstdint>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
using Catch::Matchers::Contains;

namespace {

void write_steps(H5Writer writer, const bearing::Bearing& bearing, long from, long to) {
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  for (long step = from; step <= to; ++step)
    writer.write(recorder.record(make_snapshot(bearing, step)));
  writer.flush();
}

/// Runs `work` in a child process and returns how it ended. The child leaves without running any
/// clean-up.
template <class Work>
int in_child(Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 99;
    try {
      code = work();
    } catch (...) {
      code = 98;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// The first block of the file says what other programs want to read there: nobody has it open, and
/// its length is right.
void check_closed(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path);
  REQUIRE(bytes.size() > 48);
  CHECK(bytes[11] == 0);
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < 8; ++i)
    end |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[28 + i])) << (8 * i);
  CHECK(end == bytes.size());
}

}  // namespace

TEST_CASE("RESULTS.h5: every channel reads back to the last bit", "[unit][h5]") {
  for (const bool with_cage : {true, false}) {
    const bearing::Bearing bearing = make_bearing(5, with_cage);
    TemporaryFolder folder;
    write_steps(H5Writer::create(folder / "RESULTS.h5", bearing, channel_table()), bearing, 0, 149);
    const H5Reader reader(folder / "RESULTS.h5");
    CHECK(reader.run_id() == "synthetic run 7");
    CHECK(reader.version() == "Adore 0.9.0");
    REQUIRE(reader.steps() == 150);
    CHECK(reader.step_numbers()[149] == 149);
    CHECK(reader.geometry().at("cage_outer_radius") == (with_cage ? 0.037 : 0.0));
    CHECK(reader.geometry().at("element_radius") == 0.00635);

    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    const auto all = recorder.table().all();
    const auto place_of = [&](const std::string& id) {
      return static_cast<std::size_t>(
          std::find_if(all.begin(), all.end(), [&](const Channel& c) { return c.id == id; }) -
          all.begin());
    };
    std::size_t found = 0;
    for (long step : {0L, 70L, 149L}) {
      // The cage's branch does not change in 150 steps, so a fresh recorder gives the same angles.
      const StepRecord& record = recorder.record(make_snapshot(bearing, step));
      for (const H5Reader::ChannelInfo& info : reader.channels()) {
        CAPTURE(info.id, step);
        const auto values = reader.read(info.id, static_cast<std::size_t>(step), 1);
        CHECK(values == record.values.at(place_of(info.id)));
        CHECK(values.size() == info.size());
        CHECK_FALSE(info.unit.empty());
        CHECK_FALSE(info.label.empty());
        CHECK_FALSE(info.description.empty());
        ++found;
      }
      CHECK(reader.read("time", static_cast<std::size_t>(step), 1).at(0) == record.time);
    }
    std::size_t expected = 0;
    for (const Channel& channel : all)
      if (channel_size(channel, shape_of(bearing)) > 0) ++expected;
    CHECK(found == 3 * expected);
    CHECK(reader.find("contact.load")->dimensions == std::vector<std::size_t>{5, 2});
    CHECK(reader.find("contact.angle")->unit == "rad");
    CHECK(reader.find("element.orientation")->dimensions == std::vector<std::size_t>{5, 4});
    CHECK((reader.find("cage.position") != nullptr) == with_cage);
    // Steps 10, 13, 16.
    const auto strided = reader.read("contact.load", 10, 3, 3);
    CHECK(strided.size() == 30);
    CHECK_THAT(message_of([&] { (void)reader.read("contact.load", 140, 4, 4); }), Contains("150"));
    CHECK_THAT(message_of([&] { (void)reader.read("nothing", 0, 1); }),
               Contains("no channel 'nothing'"));
  }
}

TEST_CASE("RESULTS.h5: killed writer → readable, and can be continued", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(5);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  const int status = in_child([&]() -> int {
    H5Writer writer = H5Writer::create(path, bearing, channel_table(), 8);
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    for (long step = 0; step < 83; ++step)
      writer.write(recorder.record(make_snapshot(bearing, step)));
    ::kill(::getpid(), SIGKILL);
    return 0;
  });
  REQUIRE(WIFSIGNALED(status));
  REQUIRE(WTERMSIG(status) == SIGKILL);
  check_closed(path);
  {
    const H5Reader reader(path);
    CHECK(reader.steps() == 80);  // ten blocks of eight; three steps had not gone out
    CHECK(reader.read("time")[79] == 79e-5);
    CHECK(reader.read("contact.load", 79, 1)[0] == 100.0);
  }
  // MASTER stood at step 60.
  write_steps(H5Writer::continue_after(path, bearing, channel_table(), 60), bearing, 61, 99);
  const H5Reader reader(path);
  REQUIRE(reader.steps() == 100);
  for (long step = 0; step < 100; ++step)
    CHECK(reader.step_numbers()[static_cast<std::size_t>(step)] == step);
  write_steps(H5Writer::create(folder / "whole.h5", bearing, channel_table()), bearing, 0, 99);
  CHECK(read_bytes(folder / "whole.h5") == read_bytes(path));
  check_closed(path);
}

TEST_CASE("RESULTS.h5: file left open by an older version → read and continued", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(5);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  write_steps(H5Writer::create(path, bearing, channel_table()), bearing, 0, 99);
  const std::string whole = read_bytes(path);
  // The library's own driver leaves its mark.
  const int status = in_child([&]() -> int {
    const h5::Handle access = h5::file_access_properties();
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
    if (file < 0 || H5Fstart_swmr_write(file) < 0) return 1;
    ::kill(::getpid(), SIGKILL);
    return 0;
  });
  REQUIRE(WIFSIGNALED(status));
  REQUIRE(read_bytes(path)[11] != 0);
  CHECK(H5Reader(path).steps() == 100);
  write_steps(H5Writer::continue_after(path, bearing, channel_table(), 49), bearing, 50, 99);
  CHECK(read_bytes(path) == whole);
}

TEST_CASE("RESULTS.h5: any flipped bit → continuation rejected, or no harm", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  write_steps(H5Writer::create(path, bearing, channel_table()), bearing, 0, 70);
  const std::string whole = read_bytes(path);
  int refused = 0;
  for (std::size_t k = 0; k < 60; ++k) {
    std::string damaged = whole;
    const std::size_t at = (k * 7919 * 131) % damaged.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (k % 8)));
    write_bytes(path, damaged);
    CAPTURE(at);
    try {
      (void)H5Writer::continue_after(path, bearing, channel_table(), 65);
      CHECK(H5Reader(path).steps() == 66);
    } catch (const InputError& error) {
      ++refused;
      CHECK_THAT(error.what(), Contains("RESULTS.h5"));
      CHECK(read_bytes(path) == damaged);
    }
    CHECK_FALSE(std::filesystem::exists(H5Writer::unfinished_path(path)));
  }
  CHECK(refused > 0);
}

TEST_CASE("RESULTS.h5: readable while it grows", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  int to_child[2], to_parent[2];
  REQUIRE(::pipe(to_child) == 0);
  REQUIRE(::pipe(to_parent) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    char byte = 0;
    try {
      H5Writer writer = H5Writer::create(folder / "RESULTS.h5", bearing, channel_table(), 1);
      ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
      for (long step = 0; step < 10; ++step) {
        writer.write(recorder.record(make_snapshot(bearing, step)));
        if (::write(to_parent[1], &byte, 1) != 1 || ::read(to_child[0], &byte, 1) != 1) break;
      }
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  for (std::size_t step = 0; step < 10; ++step) {
    char byte = 0;
    REQUIRE(::read(to_parent[0], &byte, 1) == 1);
    CHECK(H5Reader(folder / "RESULTS.h5").steps() == step + 1);
    REQUIRE(::write(to_child[1], &byte, 1) == 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  for (int fd : {to_child[0], to_child[1], to_parent[0], to_parent[1]}) ::close(fd);
}

TEST_CASE("RESULTS.h5: same run → same bytes, for any flush times", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(5);
  TemporaryFolder folder;
  write_steps(H5Writer::create(folder / "a.h5", bearing, channel_table()), bearing, 0, 199);
  ::sleep(1);  // a time stamp would differ
  {
    H5Writer writer = H5Writer::create(folder / "b.h5", bearing, channel_table());
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    for (long step = 0; step <= 199; ++step) {
      writer.write(recorder.record(make_snapshot(bearing, step)));
      if (step % 37 == 5) writer.flush();
    }
  }
  CHECK(read_bytes(folder / "a.h5") == read_bytes(folder / "b.h5"));
}

TEST_CASE("RESULTS.h5: many blocks → same bytes for any order of rows, and when continued",
          "[unit][h5][slow]") {
  const bearing::Bearing bearing = make_bearing(3);
  constexpr long kSteps = 6'000;  // so many blocks that their index grows
  TemporaryFolder folder;
  const auto write = [&](H5Writer writer, long from, long to, long every) {
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    for (long step = 0; step < to; ++step) {
      const auto& record = recorder.record(make_snapshot(bearing, step));  // knows the last ones
      if (step < from) continue;
      writer.write(record);
      if (every > 0 && step % every == 5) writer.flush();
    }
    writer.close();
  };
  write(H5Writer::create(folder / "whole.h5", bearing, channel_table()), 0, kSteps, 0);
  const std::string whole = read_bytes(folder / "whole.h5");
  for (const long every : {37L, 300L}) {  // as the clock asks for it in a slow run
    CAPTURE(every);
    write(H5Writer::create(folder / "slow.h5", bearing, channel_table()), 0, kSteps, every);
    CHECK((read_bytes(folder / "slow.h5") == whole));
  }
  for (const long end : {100L, 1'400L, 4'096L})
    for (const long every : {0L, 37L}) {
      CAPTURE(end, every);
      const auto path = folder / "joined.h5";
      write(H5Writer::create(path, bearing, channel_table()), 0, end, every);
      write(H5Writer::continue_after(path, bearing, channel_table(), end - 10), end - 9, kSteps,
            every);
      CHECK((read_bytes(path) == whole));
    }
}

TEST_CASE("RESULTS.h5: foreign, damaged or unsuitable file → message", "[unit][h5]") {
  const bearing::Bearing bearing = make_bearing(3);
  TemporaryFolder folder;
  const auto path = folder / "RESULTS.h5";
  write_steps(H5Writer::create(path, bearing, channel_table()), bearing, 0, 3);
  bearing::Bearing other = bearing;
  other.run_id = "another run";
  CHECK_THAT(message_of([&] { H5Writer::continue_after(path, other, channel_table(), 2); }),
             Contains("another run") && Contains("synthetic run 7"));
  CHECK_THAT(
      message_of([&] { H5Writer::continue_after(path, make_bearing(4), channel_table(), 2); }),
      Contains("does not match this bearing"));
  CHECK_THAT(message_of([&] { H5Writer::check(path, make_bearing(4), channel_table()); }),
             Contains("does not match this bearing"));
  CHECK(message_of([&] { H5Writer::check(path, bearing, channel_table()); }) == "no error");
  CHECK_THAT(message_of([&] { H5Reader reader(folder / "missing.h5"); }), Contains("no such file"));
  CHECK_THAT(message_of([&] {
               H5Writer::create(folder / "no/such/RESULTS.h5", bearing, channel_table());
             }),
             Contains("cannot be written") && Contains("create the folder"));
  write_bytes(folder / "text", "not HDF5");
  CHECK_THAT(message_of([&] { H5Reader reader(folder / "text"); }), Contains("not an HDF5 file"));
  const std::string bytes = read_bytes(path);
  for (const std::size_t size : {std::size_t{100}, bytes.size() / 2, bytes.size() - 100}) {
    write_bytes(folder / "cut", std::string_view(bytes).substr(0, size));
    CAPTURE(size);
    CHECK_THAT(message_of([&] {
                 const H5Reader reader(folder / "cut");
                 for (const auto& info : reader.channels()) (void)reader.read(info.id);
               }),
               Contains("damaged") || Contains("cannot be") || Contains("contains no"));
  }
  CHECK(H5Reader(path).steps() == 4);
}

TEST_CASE("writers: full disk → message, and stored steps are kept", "[unit][h5][sol]") {
  const bearing::Bearing bearing = make_bearing(5);
  TemporaryFolder folder;
  // A limit on the size of files stands for the full disk.
  const int status = in_child([&]() -> int {
    std::signal(SIGXFSZ, SIG_IGN);
    H5Writer h5 = H5Writer::create(folder / "RESULTS.h5", bearing, channel_table(), 1);
    SolWriter sol = SolWriter::create(folder / "SOL1", make_sol_header(bearing, 1, UnitSystem::SI),
                                      UnitSystem::SI);
    const rlim_t limit = 2'000'000;  // room for one chunk of 256 steps
    const struct rlimit most { limit, limit };
    if (::setrlimit(RLIMIT_FSIZE, &most) != 0) return 1;
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    int failures = 0;
    bool h5_open = true, sol_open = true;
    for (long step = 0; step < 5000 && failures < 2; ++step) {
      const StepRecord& record = recorder.record(make_snapshot(bearing, step));
      if (sol_open) {
        try {
          sol.write(record);
        } catch (const InputError& error) {
          sol_open = false;
          if (std::string(error.what()).find("SOL1: writing to the file failed") !=
              std::string::npos)
            ++failures;
        }
      }
      if (h5_open) {
        try {
          h5.write(record);
        } catch (const InputError& error) {
          h5_open = false;
          if (std::string(error.what()).find("RESULTS.h5") != std::string::npos) ++failures;
        }
      }
    }
    return failures == 2 ? 0 : 2;
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  const SolFile sol = read_sol(folder / "SOL1");
  CHECK(sol.note.empty());
  CHECK(sol.steps.size() > 1000);
  check_closed(folder / "RESULTS.h5");
  const H5Reader h5(folder / "RESULTS.h5");
  CHECK(h5.steps() >= 1);
  CHECK(h5.read("contact.load", h5.steps() - 1, 1)[0] == 100.0);
}

TEST_CASE("RESULTS.h5: several runs at the same time → made, written, read and continued",
          "[unit]") {
  const TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing(3, true);
  write_steps(H5Writer::create(folder / "one", bearing, channel_table()), bearing, 0, 70);
  const std::string wanted = read_bytes(folder / "one");
  // A file is read by a child process. GCC 12's address sanitizer does not keep its allocator
  // usable in the child of a program with several threads, as the C library does.
#ifdef __SANITIZE_ADDRESS__
  constexpr int kThreads = 1;
#else
  constexpr int kThreads = 4;
#endif
  constexpr int kRounds = 8;
  std::array<std::string, kThreads> wrong;
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < kThreads; ++k)
      threads.emplace_back([&, k] {
        const auto path = folder / ("run-" + std::to_string(k));
        try {
          for (int round = 0; round < kRounds; ++round) {
            write_steps(H5Writer::create(path, bearing, channel_table()), bearing, 0, 40);
            write_steps(H5Writer::continue_after(path, bearing, channel_table(), 20), bearing, 21,
                        70);
            if (H5Reader(path).step_numbers().size() != 71 || read_bytes(path) != wanted)
              wrong[static_cast<std::size_t>(k)] = "other bytes";
          }
        } catch (const std::exception& error) {
          wrong[static_cast<std::size_t>(k)] = error.what();
        }
      });
  }
  for (const std::string& what : wrong) CHECK(what == "");
}
