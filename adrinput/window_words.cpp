#include "adrinput/window_words.hpp"

#include <string_view>
#include <utility>

namespace adore::adrinput {
namespace {

/// Complete sentences first, general option names last. Buttons and menus by their names; commands
/// without equivalent in the window stay in backquotes.
constexpr std::pair<std::string_view, std::string_view> kWords[]{
    {"choose another folder with --out", "run it in a new folder (Shift+F7)"},
    {"another folder with --out", "run it in a new folder (Shift+F7)"},
    {"continue that run with --continue, replace its results with --overwrite",
     "continue that run (Run > Continue the run), or replace its results"},
    {"--continue: the deck ", "Continue the run: the deck "},
    {"there is nothing to continue; remove --continue",
     "there is nothing to continue; run it (F7)"},
    {"continue the run with --continue", "continue the run (Run > Continue the run)"},
    {"Start the run without --continue. Add --overwrite if the folder still contains files of the "
     "earlier run",
     "Run the deck (F7) and replace the earlier results"},
    {"; add --overwrite if the folder still contains files of the earlier run",
     " and replace the earlier results"},
    {" with --overwrite", " and replace the earlier results"},
    {"--until, ", ""},
    {", or give the end of the run with --until", ""},
    {", or --tol)", ")"},
    {" --reproducible gives", " `adore run --reproducible` gives"},
    {"`adore run --verify` estimates", "Accuracy (F9) estimates"},
    {"give only one --set with a range", "enter only one range"},
    {"; to compute only the quasi-static solution, use --set mode=-1",
     "; to compute only the quasi-static solution, press \"Run quasi-static now\" (F6), or enter "
     "mode = -1"},
    {" with --user PLUG-IN", " on the command line with `adore run --user PLUG-IN`"},
    {" of --user ", " of `adore run --user` "},
    {"give --over-budget", "press \"Run anyway\""},
    {"Repeat the run with --retry-failed", "Press \"Retry failed\" to repeat the run"},
    {"then repeat it with --retry-failed", "then press \"Retry failed\""},
    {"give a smaller number with --workers", "use fewer parallel runs"},
    {"add --workers 1", "set max. runs to 1 first"},
    {"Continue with `adore study resume --engine slurm`", "Press \"Resume\""},
    {"Continue with `adore study resume`", "Press \"Resume\""},
    {"`adore study resume`", "Resume"},
    {"use --engine local", "select the engine \"local\""},
    {"--engine ", "engine "},
    {" with --opt ", " with the run option "},
    {"--set ", ""},
};

}  // namespace

std::string replace_cli_terms(std::string sentence) {
  for (const auto& [options, window] : kWords)
    for (std::size_t at = sentence.find(options); at != std::string::npos;
         at = sentence.find(options, at + window.size()))
      sentence.replace(at, options.size(), window);
  return sentence;
}

}  // namespace adore::adrinput
