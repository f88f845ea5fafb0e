#pragma once

#include "core/results/synthetic.hpp"
#include "h5_blocks.hpp"
#include "results/results_h5.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

/// Files of our own writer with damaged bookkeeping; most get their checksums put right again.
namespace adore::testing {

struct Pristine {
  std::string_view name;
  unsigned share;  ///< of all damaged files
  std::string bytes;
  std::vector<H5Block> blocks;
};

inline const TemporaryFolder& folder() {
  static const TemporaryFolder kFolder;
  return kFolder;
}

/// Writes files of a run.
class Pen {
 public:
  /// @param few a channel of each number of dimensions instead of all, which cost ten times as much
  /// and teach nothing new about the library
  Pen(bool cage, bool few) : bearing_(make_bearing(2, cage)) {
    if (few) written_ = all_.only(kFew);
  }
  [[nodiscard]] const bearing::Bearing& bearing() const { return bearing_; }
  [[nodiscard]] const results::ChannelTable& table() const { return written_; }
  /// Steps first, first + 1 ... up to `last`.
  void write(results::H5Writer& writer, long first, long last) {
    for (long step = first; step <= last; ++step) {
      results::StepRecord record = recorder_.record(make_snapshot(bearing_, step));
      const std::vector<std::vector<double>> values = std::move(record.values);
      record.values.clear();
      for (std::size_t c = 0, next = 0; c < values.size() && next < written_.all().size(); ++c)
        if (all_.all()[c].id == written_.all()[next].id) {
          record.values.push_back(values[c]);
          ++next;
        }
      writer.write(record);
    }
  }

 private:
  static constexpr std::array<std::string_view, 7> kFew{
      "element.orientation", "contact.load", "pocket.force", "cage.position",
      "land.force",          "race.x",       "power.loss"};
  bearing::Bearing bearing_;
  results::ChannelTable all_ = channel_table(), written_ = all_;
  results::ChannelRecorder recorder_{bearing_, results::UnitSystem::SI, all_};
};

/// A run that the system kills in the middle of a block.
inline void write_killed(const std::filesystem::path& path) {
  constexpr rlim_t kRoom = 14000;
  const pid_t child = ::fork();
  if (child == 0) {
    const struct rlimit room { kRoom, kRoom }, none{0, 0};
    ::setrlimit(RLIMIT_FSIZE, &room);
    ::setrlimit(RLIMIT_CORE, &none);
    std::signal(SIGXFSZ, SIG_DFL);
    Pen pen(true, true);
    auto writer = results::H5Writer::create(path, pen.bearing(), pen.table(), 16);
    pen.write(writer, 0, 1000);
    ::_exit(0);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  demand(WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ, "a run is killed while it writes");
}

/// Files of the ways in which runs end and of the blocks that the library makes. The first is one
/// without a cage.
inline const std::vector<Pristine>& pristine() {
  static const std::vector<Pristine> kAll = [] {
    const auto path = folder() / "pristine.h5";
    std::vector<Pristine> out;
    const auto add = [&](std::string_view name, unsigned share) {
      out.push_back({name, share, read_bytes(path), {}});
      out.back().blocks = h5_blocks(out.back().bytes);
    };
    const auto write = [&](Pen pen, long last) {
      auto writer = results::H5Writer::create(path, pen.bearing(), pen.table());
      pen.write(writer, 0, last);
      writer.flush();
    };
    write({false, true}, 1);
    add("no cage, 2 steps", 240);
    write({true, true}, 69);
    add("70 steps", 240);
    {
      Pen pen(true, true);
      auto writer = results::H5Writer::continue_after(path, pen.bearing(), pen.table(), 40);
      pen.write(writer, 41, 299);
      writer.flush();
    }
    add("continued behind step 40, 300 steps", 240);
    write_killed(path);
    add("killed in the middle of a block", 240);
    write({true, false}, 69);
    add("all channels, 70 steps", 36);
    write({true, true}, 64 * 320);
    add("a long run", 4);
    return out;
  }();
  return kAll;
}

/// Text of a rejection, without its numbers and names; an unknown message unchanged.
inline std::string kind_of(const std::string& sentence) {
  for (const char* kind :
       {"the HDF5 library failed to read the file", "did not end within", "more memory",
        "cannot be opened", "cannot be read", "too short", "contains no bearing results",
        "not an HDF5 file", "not stored in the format", "damaged", "step number"})
    if (sentence.find(kind) != std::string::npos) return kind;
  return sentence;
}

struct Mutant {
  std::string bytes;
  std::size_t kind = 0;     ///< of pristine()
  bool sums_right = false;  ///< the checksums of the damaged blocks were put right
};

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  Mutant file() {
    const std::size_t kind = pick();
    const Pristine& base = pristine()[kind];
    std::string bytes = base.bytes;
    const bool mend = below(4) > 0;
    for (std::size_t left = 1 + below(3); left > 0; --left) {
      const H5Block& block = base.blocks[below(base.blocks.size())];
      if (below(16) == 0)
        bytes[below(bytes.size())] = static_cast<char>(random_());
      else
        damage(bytes, block, base);
      if (mend) set_checksum(bytes, block);
    }
    if (below(64) == 0) bytes.resize(below(bytes.size()));
    return {std::move(bytes), kind, mend};
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  /// By their shares.
  std::size_t pick() {
    std::size_t total = 0;
    for (const Pristine& one : pristine()) total += one.share;
    std::size_t at = below(total), kind = 0;
    while (at >= pristine()[kind].share) at -= pristine()[kind++].share;
    return kind;
  }

  void damage(std::string& bytes, const H5Block& block, const Pristine& base) {
    static constexpr std::array<std::uint64_t, 14> kNumbers{0,
                                                            1,
                                                            2,
                                                            0x7f,
                                                            0x80,
                                                            0xff,
                                                            0x7fff,
                                                            0xffff,
                                                            0x7fffffff,
                                                            0x80000000,
                                                            0xffffffff,
                                                            0x7fffffffffffffff,
                                                            0x8000000000000000,
                                                            0xffffffffffffffff};
    const std::size_t start = block.kind == "superblock" ? 8 : 4;
    const std::size_t room = block.size - 4 - start, at = block.at + start + below(room);
    const std::size_t end = block.at + block.size - 4;
    const auto put = [&](std::uint64_t number, std::size_t width) {
      for (std::size_t k = 0; k < width && at + k < end; ++k)
        bytes[at + k] = static_cast<char>(number >> (8 * k));
    };
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        put(random_(), 1);
        break;
      case 2:
        put(kNumbers[below(kNumbers.size())], std::size_t{1} << below(4));
        break;
      case 3:  // another block's address: loops and shared blocks
        put(base.blocks[below(base.blocks.size())].at, 8);
        break;
      case 4:
        put(base.bytes.size() - below(32), 8);
        break;
      default: {  // bytes of a block of the same kind
        const H5Block& other = base.blocks[below(base.blocks.size())];
        const std::size_t count = std::min({end - at, std::size_t{1} + below(16), other.size - 4});
        const std::size_t from = other.at + below(other.size - count);
        bytes.replace(at, count, base.bytes, from, count);
      }
    }
  }

  std::mt19937 random_;
};

}  // namespace adore::testing
