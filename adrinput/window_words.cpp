#include "adrinput/window_words.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace adore::adrinput {
namespace {

/// Longer ones first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kWords{{
    {"choose another folder with --out", "run it into a new folder (Shift+F7)"},
    {"name another one with --out", "run it into a new folder (Shift+F7)"},
    {"another folder with --out", "run it into a new folder (Shift+F7)"},
    {"go on with that run with --continue, replace its results with --overwrite",
     "go on with that run (Continue), replace its results"},
    {"go on with --continue", "go on with that run (Continue)"},
    {"without --continue, with --overwrite if files are left", "anew, and replace what is left"},
    {", with --overwrite", ", and replace what is left"},
    {" with --overwrite", " and replace what is left"},
    {"--until, ", ""},
}};

}  // namespace

std::string in_window_words(std::string sentence) {
  for (const auto& [options, window] : kWords)
    for (std::size_t at = sentence.find(options); at != std::string::npos;
         at = sentence.find(options, at + window.size()))
      sentence.replace(at, options.size(), window);
  return sentence;
}

}  // namespace adore::adrinput
