#include "base/errors.hpp"
#include "base/resources.hpp"
#include "base/write_folder.hpp"
#include "cli/commands.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// adore user: examples of user routines.
namespace adore::cli {
namespace {

namespace fs = std::filesystem;

struct UserOptions {
  std::string hook, lang = "c", out = ".";
};

int hook_number(const std::string& text) {
  if (text.size() == 5 && (text.starts_with("adrx") || text.starts_with("ADRX")) &&
      text[4] >= '0' && text[4] <= '9')
    return text[4] - '0';
  throw InputError(fmt::format(
      "{}: there is no such user routine; give one of adrx0 to adrx9, e.g. adrx7", text));
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// The example of a routine. @param ending of its language
std::string example_of(int hook, const std::string& ending) {
  if (hook >= 2 && hook <= 4) {
    constexpr std::string_view kBodies[] = {"roller ends and flanges", "elements and cage pockets",
                                            "guide lands and races"};
    const std::string text(resources::get("user/force" + ending));
    constexpr std::string_view kNames[] = {"flange", "pocket", "land"};
    const auto k = static_cast<std::size_t>(hook - 2);
    const std::string number = fmt::format("{}", hook);
    return replaced(
        replaced(replaced(replaced(text, "adrxN", "adrx" + number), "ADRXN", "ADRX" + number),
                 "THE_BODIES", kBodies[k]),
        "the_kind", kNames[k]);
  }
  return std::string(resources::get(fmt::format("user/adrx{}{}", hook, ending)));
}

std::string makefile(const std::string& name, const std::string& lang) {
  // Fast arithmetic is for the compiler alone: a library linked with it changes the arithmetic of
  // the program that loads it.
  constexpr const char* kFlags = "-O3 -march=native -ffast-math -fPIC";
  if (lang == "fortran")
    return fmt::format(
        "# make; then: adore run DATA.txt --user ./lib{0}.so\nFC = gfortran\nFFLAGS = {1}\n\n"
        "lib{0}.so: adore_user.o {0}.o\n\t$(FC) -shared -o $@ $^\n"
        "{0}.o: {0}.f90 adore_user.o\n\t$(FC) $(FFLAGS) -c $<\n"
        "adore_user.o: adore_user.f90\n\t$(FC) $(FFLAGS) -c $<\n",
        name, kFlags);
  const bool cpp = lang == "cpp";
  return fmt::format(
      "# make; then: adore run DATA.txt --user ./lib{0}.so\n{1}\n{2} = {3}\n\n"
      "lib{0}.so: {0}.o\n\t{4} -shared -o $@ $^ -lm\n"
      "{0}.o: {0}.{5} adore_user.h\n\t{4} $({2}) -c $<\n",
      name, cpp ? "CXX = g++" : "CC = gcc", cpp ? "CXXFLAGS" : "CFLAGS",
      cpp ? std::string(kFlags) + " -std=c++17 -Drestrict=__restrict" : std::string(kFlags),
      cpp ? "$(CXX)" : "$(CC)", cpp ? "cpp" : "c");
}

/// Requirements of an example in addition to the routine: options, and lines that it reads.
struct NeededByDeck {
  std::string_view options, lines;
};
NeededByDeck needed_by(int hook) {
  constexpr std::array<NeededByDeck, 10> kNeeded{
      {{"--set kReMat=2, or with code 2 for the material of another part", ""},
       {"", "0.0, 1.0e-3, 10000.0, 12000.0\n1.0e-6, 500.0"},
       {"", "1.0e-6"},
       {"", "1.0e-6"},
       {"", "1.0e-6"},
       {"", "2.0e-3, 0.5"},
       {"--set kRaceGeoImp2=3", "1.0e-6, 7.0, 0.0"},
       {"--set kTrac=-1", "0.0, 0.05, 3.0, 0.0"},
       {"--set kReGeoImp=3", "1.0e-6"},
       {"", ""}}};
  return kNeeded[static_cast<std::size_t>(hook)];
}

void print_deck_requirements(int hook, bool python) {
  const NeededByDeck needed = needed_by(hook);
  if (!needed.options.empty())
    tell(fmt::format("enable the routine in the deck, e.g. with {}\n", needed.options));
  if (!needed.lines.empty() && !python)
    tell(
        fmt::format("the routine reads values from the end of DATA.txt (record 12); the first "
                    "lines of the routine explain them. Example:\n{}\n",
                    needed.lines));
}

void new_routine(const UserOptions& options) {
  const int hook = hook_number(options.hook);
  const std::string name = fmt::format("adrx{}", hook);
  std::vector<std::pair<std::string, std::string>> files;
  if (options.lang == "c" || options.lang == "cpp") {
    std::string text = example_of(hook, ".c");
    if (options.lang == "cpp")
      text = replaced(text, "#include \"adore_user.h\"\n",
                      "#include \"adore_user.h\"\n\nextern \"C\" int32_t adore_user_abi(void);\n"
                      "extern \"C\" const char* adore_user_version(void);\n" +
                          fmt::format("extern \"C\" int32_t {}(adore_{}* a);\n", name,
                                      hook >= 2 && hook <= 4   ? "force"
                                      : hook == 5 || hook == 6 ? "surface"
                                                               : name));
    files = {{name + "." + options.lang, text},
             {"adore_user.h", std::string(resources::get("user/adore_user.h"))}};
  } else if (options.lang == "fortran") {
    files = {{name + ".f90", example_of(hook, ".f90")},
             {"adore_user.f90", std::string(resources::get("user/adore_user.f90"))}};
  } else if (options.lang == "python") {
    files = {{name + ".py", example_of(hook, ".py")}};
  } else {
    throw InputError(fmt::format("--lang {}: give c, cpp, fortran or python", options.lang));
  }
  const bool python = options.lang == "python";
  if (!python) files.emplace_back("Makefile", makefile(name, options.lang));
  const fs::path folder(options.out);
  for (const auto& [file, text] : files)
    if (std::error_code error; fs::exists(fs::symlink_status(folder / file, error)))
      throw InputError(fmt::format(
          "{} exists already; give another folder with --out, or remove this file first",
          (folder / file).string()));
  (void)make_folders(folder);
  for (const auto& [file, text] : files) {
    const std::string path = (folder / file).string();
    (void)write_text(path, path, text);
    tell(fmt::format("wrote {}\n", path));
  }
  if (python)
    tell(fmt::format("run the example with\n  python3 {} DATA.txt OUT\n",
                     (folder / (name + ".py")).string()));
  else
    tell(fmt::format(
        "build the routine with make, then start a run with\n  adore run DATA.txt --user {}\n",
        (folder / fmt::format("lib{}.so", name)).string()));
  print_deck_requirements(hook, python);
}

}  // namespace

void add_user_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "user", "write an example of a user routine (ADRX0 to ADRX9) for `adore run --user`");
  command->require_subcommand(1);
  CLI::App* make = command->add_subcommand("new", "write a complete example with its makefile");
  auto options = std::make_shared<UserOptions>();
  make->add_option("hook", options->hook, "user routine: adrx0 to adrx9")
      ->required()
      ->type_name("HOOK");
  command_line::one_of(make->add_option("--lang", options->lang, "language of the example")
                           ->capture_default_str()
                           ->type_name("LANG"),
                       {"c", "cpp", "fortran", "python"});
  make->add_option("--out", options->out, "output folder (default: current folder)")
      ->type_name("DIR");
  make->callback([=, &exit_code] {
    new_routine(*options);
    exit_code = 0;
  });
}

}  // namespace adore::cli
