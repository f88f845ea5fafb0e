#include "adrinput/deck_window.hpp"
#include "adrinput/render.hpp"
#include "adrinput/session.hpp"
#include "adrinput/study_menu.hpp"
#include "adrinput/study_window.hpp"
#include "base/ending.hpp"
#include "base/errors.hpp"
#include "base/terminal_text.hpp"
#include "command_line/program.hpp"
#include "command_line/tree.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/command_line.hpp"
#include "desktop/disclaimer.hpp"

#include <fmt/core.h>

using namespace adore;

namespace {

int render(int& argc, char** argv, const std::filesystem::path& deck,
           const adrinput::RenderOptions& options) {
  if (deck.empty()) throw InputError("--render needs a deck");
  exit_on_interrupt();
  const auto app = desktop::make_application(argc, argv, "adrinput", desktop::Display::Headless);
  const auto pages = adrinput::has_study_file_name(deck) ? adrinput::render_study(deck, options)
                                                         : adrinput::render_pages(deck, options);
  for (const auto& path : pages) print("{}\n", path.string());
  return 0;
}

int show(int& argc, char** argv, const std::filesystem::path& deck) {
  const auto app = desktop::make_application(argc, argv, "adrinput", desktop::Display::Window);
  if (!desktop::ask_for_disclaimer("AdrInput")) return 0;
  if (adrinput::has_study_file_name(deck)) {
    adrinput::StudyWindow window;
    window.show();
    window.openFile(deck);
    return QApplication::exec();
  }
  adrinput::DeckWindow window;
  adrinput::Session session(window);
  window.show();
  if (!deck.empty()) window.openFile(deck);
  session.begin(!deck.empty());
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  const auto program = command_line::make_program(
      "AdrInput: editor for decks that checks values as you type. Without DECK, the example of a "
      "ball bearing opens.",
      "adrinput");
  CLI::App& cli = *program;
  std::filesystem::path deck;
  adrinput::RenderOptions options;
  std::string size = "1280x800";
  cli.add_option("DECK", deck, "deck file, folder with DATA.txt, or study file (.json, .toml)")
      ->type_name("DECK");
  auto* folder = cli.add_option("--render", options.folder,
                                "write all pages as PNG to this folder instead of opening a window")
                     ->type_name("DIR");
  cli.add_option("--size", size, "picture size in pixels, WIDTHxHEIGHT")
      ->capture_default_str()
      ->type_name("SIZE")
      ->needs(folder);
  cli.add_flag("--dark", options.dark, "dark theme")->needs(folder);
  if (const auto over = command_line::parse(cli, argc, argv)) return *over;
  return desktop::run_guarded("adrinput", [&] {
    const auto pixels = desktop::parse_size(size);
    options.width = pixels.width;
    options.height = pixels.height;
    return options.folder.empty() ? show(argc, argv, deck) : render(argc, argv, deck, options);
  });
}
