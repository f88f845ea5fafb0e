#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

/// Feeds LLVMFuzzerTestOneInput without libFuzzer: replays a corpus, then changes its files at
/// random, or lets the fuzzer's own LLVMFuzzerCustomMutator do it. No coverage guides it, so a good
/// corpus matters; the same seed gives the same inputs. An input that crashes, throws, takes more
/// than a minute or makes the process larger than 500 MB is left in a file.
///
///   fuzz_deck [--iterations N] [--seconds S] [--seed K] [--crash-file FILE] FILE-or-FOLDER...
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed)
    __attribute__((weak));
extern "C" void __sanitizer_set_death_callback(void (*callback)()) __attribute__((weak));

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestInput = 64 * 1024, kLargestOwn = 4 * 1024 * 1024;
constexpr unsigned kLongest = 60;         // seconds for one input
constexpr long kMostMemory = 500 * 1000;  // KiB

struct Options {
  long long iterations = 0;
  double seconds = 0.0;
  unsigned seed = 1;
  std::string crash_file = "fuzz_crash";
  std::vector<fs::path> paths;
};

// Current input; global because the signal handlers read it.
const std::string* current_input = nullptr;
char crash_path[4096] = "";

/// Only async-signal-safe calls.
void save_current_input() {
  if (current_input == nullptr) return;
  const int file = ::open(crash_path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) return;
  std::size_t done = 0;
  while (done < current_input->size()) {
    const ssize_t count = ::write(file, current_input->data() + done, current_input->size() - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  ::close(file);
  const char note[] = "the input that failed is in the crash file\n";
  [[maybe_unused]] const ssize_t ignored = ::write(2, note, sizeof note - 1);
  current_input = nullptr;
}

void on_signal(int number) {
  save_current_input();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void refuse(const char* why) {
  std::fprintf(stderr, "%s\n", why);
  save_current_input();
  std::_Exit(1);
}

void run(const std::string& input) {
  current_input = &input;
  ::alarm(kLongest);
  try {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "uncaught exception: %s\n", error.what());
    refuse("an exception left the reader");
  }
  ::alarm(0);
  if (__sanitizer_set_death_callback == nullptr) {  // sanitizers need a multiple
    struct rusage used {};
    ::getrusage(RUSAGE_SELF, &used);
    if (used.ru_maxrss > kMostMemory) refuse("more than 500 MB of memory");
  }
  current_input = nullptr;
}

std::vector<std::string> load(const std::vector<fs::path>& paths) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    if (!in) {
      std::fprintf(stderr, "cannot read %s\n", file.c_str());
      std::exit(2);
    }
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return inputs;
}

/// Random changes that suit text files of numbers and quoted words.
class Mutator {
 public:
  Mutator(std::vector<std::string> corpus, unsigned seed)
      : corpus_(std::move(corpus)), random_(seed) {}

  std::string next() {
    std::string text = corpus_[below(corpus_.size())];
    if (LLVMFuzzerCustomMutator != nullptr && below(8) > 0) {
      const std::size_t size = text.size();
      text.resize(kLargestOwn);
      text.resize(LLVMFuzzerCustomMutator(reinterpret_cast<std::uint8_t*>(text.data()), size,
                                          kLargestOwn, static_cast<unsigned>(random_())));
      return text;
    }
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) change(text);
    if (text.size() > kLargestInput) text.resize(kLargestInput);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  void change(std::string& text) {
    static const std::vector<std::string_view> kPieces = {",",
                                                          "/",
                                                          "'",
                                                          "''",
                                                          "\"",
                                                          "\n",
                                                          "\r\n",
                                                          "\t",
                                                          "*",
                                                          "3*",
                                                          "0*",
                                                          "999999999*",
                                                          "12*0",
                                                          "1e999",
                                                          "-1e-999",
                                                          "NaN",
                                                          "Inf",
                                                          "1d5",
                                                          "1.5-3",
                                                          "0",
                                                          "-1",
                                                          "2",
                                                          "1.0",
                                                          "2147483648",
                                                          ".",
                                                          "+",
                                                          "'Rec 5A'",
                                                          "'Rec 7.2.2'",
                                                          "'Rec 9.6.3'",
                                                          "'Rec 12.1'",
                                                          "\xEF\xBB\xBF",
                                                          "\x1a",
                                                          "\xff",
                                                          "[",
                                                          "]",
                                                          "99999999999999999999",
                                                          "1.2345678-100",
                                                          "****",
                                                          "-0.0",
                                                          "e",
                                                          " ",
                                                          "{",
                                                          "}",
                                                          "[[[[[[[[",
                                                          "\"",
                                                          ":",
                                                          "null",
                                                          "true",
                                                          "1e308",
                                                          "-5",
                                                          "9e307"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, 1 + below(16));
    switch (below(9)) {
      case 0:  // flip a bit
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:  // double a stretch
        text.insert(at, text.substr(at, length));
        break;
      case 4:
        text.replace(at, length, kPieces[below(kPieces.size())]);
        break;
      case 5:  // cut
        text.resize(at);
        break;
      case 6: {  // put two files together
        const std::string& other = corpus_[below(corpus_.size())];
        text = text.substr(0, at) + other.substr(below(other.size() + 1));
        break;
      }
      case 7:
        change_line(text, at);
        break;
      default:  // change a digit
        if (const std::size_t digit = text.find_first_of("0123456789", at);
            digit != std::string::npos)
          text[digit] = static_cast<char>('0' + below(10));
        break;
    }
  }

  /// Drops, doubles or moves a whole line.
  void change_line(std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin) + "\n";
    const std::size_t kind = below(3);
    if (kind != 1) text.erase(begin, std::min(line.size(), text.size() - begin));
    if (kind == 0) return;
    const std::size_t where = text.find('\n', below(text.size() + 1));
    text.insert(where == std::string::npos ? text.size() : where + 1, line);
  }

  std::vector<std::string> corpus_;
  std::mt19937 random_;
};

template <class Number>
bool parse(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, number);
  return error == std::errc() && stop == end;
}

bool parse_options(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (!name.starts_with("--")) {
      options.paths.emplace_back(argv[i]);
      continue;
    }
    if (++i == argc) return false;
    if (name == "--crash-file")
      options.crash_file = argv[i];
    else if (!(name == "--iterations" && parse(argv[i], options.iterations)) &&
             !(name == "--seconds" && parse(argv[i], options.seconds)) &&
             !(name == "--seed" && parse(argv[i], options.seed)))
      return false;
  }
  return !options.paths.empty() && options.crash_file.size() < sizeof crash_path;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse_options(argc, argv, options)) {
    std::fprintf(stderr,
                 "usage: %s [--iterations N] [--seconds S] [--seed K] [--crash-file FILE] "
                 "FILE-or-FOLDER...\n",
                 argv[0]);
    return 2;
  }
  std::strcpy(crash_path, options.crash_file.c_str());
  for (const int number : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGALRM})
    std::signal(number, on_signal);
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(save_current_input);

  const std::vector<std::string> corpus = load(options.paths);
  if (corpus.empty()) {
    std::fprintf(stderr, "the corpus is empty\n");
    return 2;
  }
  for (const std::string& input : corpus) run(input);

  Mutator mutator(corpus, options.seed);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  long long done = 0;
  while (done < options.iterations || elapsed() < options.seconds) {
    run(mutator.next());
    ++done;
  }
  std::printf("%zu corpus files and %lld changed inputs in %.1f s, no failure\n", corpus.size(),
              done, elapsed());
  return 0;
}
