#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "h5_blocks.hpp"
#include "results/convert.hpp"
#include "results/results_h5.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <random>
#include <sstream>
#include <sys/resource.h>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;

/// RESULTS.h5: whatever the bytes, every reader gives values of the announced sizes or one
/// sentence, and what fails in the HDF5 library fails in the process that reads. The inputs are
/// files of our own writer with damaged bookkeeping; most get their checksums put right again.
namespace {

struct Pristine {
  std::string bytes;
  std::vector<H5Block> blocks;
};

const TemporaryFolder& folder() {
  static const TemporaryFolder kFolder;
  return kFolder;
}

/// Two files: with a cage and without, of few and of many steps.
const std::vector<Pristine>& pristine() {
  static const std::vector<Pristine> kAll = [] {
    std::vector<Pristine> out;
    for (const bool cage : {false, true}) {
      const bearing::Bearing bearing = make_bearing(2, cage);
      const auto path = folder() / "pristine.h5";
      {
        H5Writer writer = H5Writer::create(path, bearing, channel_table());
        ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
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

/// How the inputs ended, by the sentence without its numbers and names.
struct Outcomes {
  std::map<std::string, long> count;
  long inputs = 0, sums_right = 0;
  ~Outcomes() {
    if (inputs == 0) return;
    struct rusage used {};
    ::getrusage(RUSAGE_CHILDREN, &used);
    std::printf("%ld files, of %ld the checksums were put right; largest reader %ld MiB\n", inputs,
                sums_right, used.ru_maxrss / 1024);
    for (const auto& [what, times] : count) std::printf("%8ld  %s\n", times, what.c_str());
  }
};
Outcomes outcomes;

std::string kind_of(const std::string& sentence) {
  for (const char* kind :
       {"the HDF5 library failed on it", "came to no end", "more memory", "cannot be opened",
        "cannot be read", "too short", "holds no bearing results", "no HDF5 file",
        "another way than", "damaged", "step number"})
    if (sentence.find(kind) != std::string::npos) return kind;
  return sentence;
}

void read_everything(const std::filesystem::path& path) {
  const H5Reader reader(path);
  (void)reader.step_numbers();
  for (const auto& info : reader.channels())
    demand(reader.read(info.id).size() == reader.steps() * info.size(),
           "a channel has the announced size");
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string file() {
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
    if (mend) ++outcomes.sums_right;
    if (below(64) == 0) bytes.resize(below(bytes.size()));
    return bytes;
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto path = folder() / "RESULTS.h5";
  write_bytes(path, std::string_view(reinterpret_cast<const char*>(data), size));
  ++outcomes.inputs;
  std::string ended = "read to the last value";
  try {
    read_everything(path);
  } catch (const InputError& error) {
    ended = kind_of(error.what());
  }
  ++outcomes.count[ended];
  // What is built on the reader, now and then.
  if (outcomes.inputs % 16 != 0) return 0;
  try {
    std::ostringstream out;
    out << describe_file(path);
    convert_file(path, "csv", out);
  } catch (const InputError&) {
  }
  return 0;
}

/// Ignores what it is given: every input is a file of our own, damaged as the seed says.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t, std::size_t most,
                                               unsigned seed) {
  const std::string bytes = Mutator(seed).file();
  const std::size_t size = std::min(bytes.size(), most);
  std::copy_n(bytes.data(), size, reinterpret_cast<char*>(data));
  return size;
}
