#pragma once

#include "core/results/synthetic.hpp"
#include "h5_blocks.hpp"
#include "results/results_h5.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Files of our own writer with damaged bookkeeping; most get their checksums put right again.
namespace adore::testing {

struct Pristine {
  std::string bytes;
  std::vector<H5Block> blocks;
};

inline const TemporaryFolder& folder() {
  static const TemporaryFolder kFolder;
  return kFolder;
}

/// Two files: with a cage and without, of few and of many steps.
inline const std::vector<Pristine>& pristine() {
  static const std::vector<Pristine> kAll = [] {
    std::vector<Pristine> out;
    for (const bool cage : {false, true}) {
      const bearing::Bearing bearing = make_bearing(2, cage);
      const auto path = folder() / "pristine.h5";
      {
        results::H5Writer writer = results::H5Writer::create(path, bearing, channel_table());
        results::ChannelRecorder recorder(bearing, results::UnitSystem::SI, channel_table());
        for (long step = 0; step < (cage ? 70 : 2); ++step)
          writer.write(recorder.record(make_snapshot(bearing, step)));
        writer.flush();
      }
      out.push_back({read_bytes(path), {}});
      out.back().blocks = h5_blocks(out.back().bytes);
    }
    return out;
  }();
  return kAll;
}

/// What a refusal says, without its numbers and names; the sentence itself when it is another one.
inline std::string kind_of(const std::string& sentence) {
  for (const char* kind :
       {"the HDF5 library failed on it", "came to no end", "more memory", "cannot be opened",
        "cannot be read", "too short", "holds no bearing results", "no HDF5 file",
        "another way than", "damaged", "step number"})
    if (sentence.find(kind) != std::string::npos) return kind;
  return sentence;
}

struct Mutant {
  std::string bytes;
  bool sums_right = false;  ///< the checksums of the damaged blocks were put right
};

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  Mutant file() {
    const Pristine& base = pristine()[below(pristine().size())];
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
    return {std::move(bytes), mend};
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

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
