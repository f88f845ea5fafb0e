#include "base/word_checksum.hpp"
#include "core/results/synthetic.hpp"
#include "results/file_sums.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <fstream>
#include <string>

/// Checksums of files, of this and of earlier versions.
using namespace adore;

TEST_CASE("word_checksum(): parts of whole words → sum of the whole", "[unit][results]") {
  const std::string text = "forty bytes of text, of which 3 are more";
  const std::uint64_t whole = word_checksum(text, checksum({}));
  for (const std::size_t cut : {0, 8, 24, 40})
    CHECK(word_checksum(text.substr(cut), word_checksum(text.substr(0, cut), checksum({}))) ==
          whole);
  CHECK(word_checksum(text.substr(0, 39), checksum({})) != whole);
}

TEST_CASE("word_checksum(): one or two changed bits → another sum", "[unit][results]") {
  for (const std::string& text : {std::string(24, '\0'), std::string("24 bytes, three words ..")}) {
    const std::uint64_t sum = word_checksum(text, checksum({}));
    const auto flip = [](std::string& in, std::size_t bit) {
      in[bit / 8] = static_cast<char>(in[bit / 8] ^ (1 << bit % 8));
    };
    int undetected = 0;
    for (std::size_t a = 0; a < 8 * text.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        std::string changed = text;
        flip(changed, a);
        if (b != a) flip(changed, b);
        undetected += word_checksum(changed, checksum({})) == sum;
      }
    CHECK(undetected == 0);
  }
}

TEST_CASE("verify_run(): checksum of words or, from earlier versions, of bytes → intact",
          "[unit][results]") {
  const testing::TemporaryFolder folder;
  const std::string text = "a file of a run";
  std::ofstream(folder / "PRINT.txt") << text;
  const auto state_with = [&](std::uint64_t sum) {
    std::ofstream(folder / "RUN.json") << fmt::format(
        R"({{"measured": {{"checksums": {{"PRINT.txt": {{"bytes": {}, "checksum": "{:016x}"}}}}}}}})",
        text.size(), sum);
    return results::verify_run(folder / "").back().state;
  };
  using State = results::FileCheck::State;
  CHECK(state_with(results::file_checksum(folder / "PRINT.txt").sum) == State::Intact);
  CHECK(state_with(checksum(text)) == State::Intact);
  CHECK(state_with(checksum(text) + 1) == State::Damaged);
}
