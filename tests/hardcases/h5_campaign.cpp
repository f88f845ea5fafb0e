#include "base/errors.hpp"
#include "fuzz/h5_mutator.hpp"
#include "results/h5_process.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

/// h5_campaign COUNT [FIRST_SEED]: reads that many damaged RESULTS.h5, many in one process, where
/// tests/fuzz/fuzz_h5 starts a process for each. A worker has the limits of h5_process.hpp; if it
/// dies, runs out of memory or of time, the reader of users opens the same file and must return a
/// message. Prints the results by kind, as often as `kReport` states and at the end. Exit code 1 if
/// one file has no message.
using namespace adore;
using namespace adore::testing;

/// The library waits between two readings of a block with a wrong checksum, for a writer to finish
/// it. These files have no writer.
extern "C" int nanosleep(const struct timespec*, struct timespec*) { return 0; }

extern "C" void __gcov_dump() __attribute__((weak));

namespace {

std::atomic<bool> stop{false};
/// Progress of the reading.
extern "C" void on_interrupt(int) { stop = true; }

constexpr unsigned kBatch = 1000;    ///< files of one worker
constexpr unsigned kReport = 50000;  ///< files between two reports

const std::array<const char*, 13> kKinds{"read to the last value",
                                         "the HDF5 library failed to read the file",
                                         "did not end within",
                                         "more memory",
                                         "cannot be opened",
                                         "cannot be read",
                                         "too short",
                                         "contains no bearing results",
                                         "not an HDF5 file",
                                         "not stored in the format",
                                         "damaged",
                                         "step number",
                                         "another sentence"};

/// Between worker and parent.
struct Shared {
  std::atomic<unsigned> next{0};      ///< seed of the file being read
  std::atomic<bool> doubtful{false};  ///< it ended without memory: earlier files may have leaked
  std::atomic<long> sums_right{0};
  std::array<std::atomic<long>, kKinds.size()> count{};
  std::array<std::atomic<long>, 16> of_kind{};  ///< of pristine()

  void add(const Mutant& mutant, std::size_t ended) {
    ++count[ended];
    ++of_kind[mutant.kind];
    if (mutant.sums_right) ++sums_right;
    ++next;
  }
};

std::size_t index_of(const std::string& kind) {
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    if (kind == kKinds[k]) return k;
  return kKinds.size() - 1;
}

std::filesystem::path scratch(const char* name) {
  return std::filesystem::path("/dev/shm") /
         (std::string("adore-") + name + "-" + std::to_string(::getpid()));
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void limit() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most =
      pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + (std::uint64_t{256} << 20);
  const struct rlimit space { most, most }, none{0, 0};
  ::setrlimit(RLIMIT_AS, &space);
  ::setrlimit(RLIMIT_CORE, &none);
}

/// From now on so much processor time for one file, a hundred times what the slowest sound one
/// takes; the timer ends the process.
void start_clock() {
  const struct itimerval busy {
    {0, 0}, { 0, 250'000 }
  }, waiting{{0, 0}, {300, 0}};
  ::setitimer(ITIMER_PROF, &busy, nullptr);
  ::setitimer(ITIMER_REAL, &waiting, nullptr);
}

void read_directly(const std::filesystem::path& path) {
  const results::h5::Hdf5Lock quiet;
  results::h5::File file(path);
  const results::h5::Content& content = file.content();
  for (const auto& info : content.channels)
    demand(file.read(info.id, 0, content.steps, 1).size() == content.steps * info.size(),
           "a channel has the announced size");
}

/// Reads files until `last`; whoever dies leaves the seed in `shared`.
[[noreturn]] void work(Shared& shared, unsigned last, const std::filesystem::path& path) {
  limit();
  while (shared.next < last) {
    const Mutant mutant = Mutator(shared.next).file();
    write_file(path, mutant.bytes);
    start_clock();
    std::size_t kind = 0;
    try {
      read_directly(path);
    } catch (const InputError& error) {
      kind = index_of(kind_of(error.what()));
    } catch (const std::bad_alloc&) {
      shared.doubtful = true;
      break;
    } catch (const std::exception&) {
      kind = index_of("damaged");
    }
    shared.add(mutant, kind);
  }
  if (__gcov_dump != nullptr) __gcov_dump();
  ::_exit(0);
}

/// Message of the users' reader. @return false for an invalid message
bool answered(const std::filesystem::path& path, std::string& kind) {
  kind = kKinds[0];
  try {
    results::h5::ReaderLimits limits;
    limits.cpu = std::chrono::seconds(1);  // users wait 20 s for the same sentence
    results::h5::ReaderProcess reader(path, limits);
    for (const auto& info : reader.content().channels)
      (void)reader.read(info.id, info.size(), 0, reader.content().steps, 1);
  } catch (const InputError& error) {
    kind = kind_of(error.what());
  } catch (...) {
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s COUNT [FIRST_SEED]\n", argv[0]);
    return 2;
  }
  const unsigned count = static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10));
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1;
  (void)pristine();
  void* memory =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 2;
  Shared& shared = *new (memory) Shared;
  shared.next = first;
  const auto path = scratch("h5"), again = scratch("h5-again");
  const auto begin = std::chrono::steady_clock::now();
  long deaths = 0, unanswered = 0;
  std::map<int, long> signals;
  const auto report = [&] {
    struct rusage children {
    }, own{};
    ::getrusage(RUSAGE_CHILDREN, &children);
    ::getrusage(RUSAGE_SELF, &own);
    std::printf(
        "%u files from seed %u on, of %ld the checksums were put right; %.0f s; largest reader "
        "%ld MiB, largest caller %ld MiB\n",
        shared.next.load() - first, first, shared.sums_right.load(),
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
        children.ru_maxrss / 1024, own.ru_maxrss / 1024);
    for (std::size_t k = 0; k < kKinds.size(); ++k)
      if (shared.count[k] > 0) std::printf("%9ld  %s\n", shared.count[k].load(), kKinds[k]);
    for (std::size_t k = 0; k < pristine().size(); ++k)
      std::printf("%9ld  damaged ones of: %.*s (%zu bytes, %zu blocks)\n", shared.of_kind[k].load(),
                  static_cast<int>(pristine()[k].name.size()), pristine()[k].name.data(),
                  pristine()[k].bytes.size(), pristine()[k].blocks.size());
    std::printf("%ld went through the users' reader a second time:", deaths);
    for (const auto& [number, times] : signals) std::printf(" %ld %s;", times, ::strsignal(number));
    std::printf(" %ld without an answer\n", unanswered);
    std::fflush(stdout);
  };
  unsigned reported = first;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, on_interrupt);
  while (!stop && shared.next < first + count) {
    if (shared.next - reported >= kReport) {
      report();
      reported = shared.next;
    }
    const unsigned last = std::min(shared.next + kBatch, first + count);
    const pid_t child = ::fork();
    if (child == 0) {
      for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_IGN);
      work(shared, last, path);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (shared.next >= last) continue;
    ++deaths;
    if (WIFSIGNALED(status)) ++signals[WTERMSIG(status)];
    const Mutant mutant = Mutator(shared.next).file();
    write_file(again, mutant.bytes);
    std::string kind;
    if (!answered(again, kind)) {
      ++unanswered;
      std::printf("seed %u was not answered\n", shared.next.load());
    }
    shared.add(mutant, index_of(kind));
    shared.doubtful = false;
  }
  std::filesystem::remove(path);
  std::filesystem::remove(again);
  report();
  return unanswered > 0 ? 1 : 0;
}
