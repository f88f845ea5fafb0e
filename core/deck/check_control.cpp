#include "base/counted.hpp"
#include "deck/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

/// Records 1 to 3: contradictory options.
namespace adore::deck {
namespace {

bool is_dynamic(const Checker& c) {
  const auto mode = c.integer("mode");
  return mode && *mode >= 0;
}

void check_run_mode(Checker& c) {
  const auto mode = c.integer("mode");
  if (mode && *mode < 0) {
    if (c.is("kDCR", 1))
      c.no_effect("kDCR", "has no effect: mode is negative, so that nothing moves",
                  "set kDCR to 0 and remove record 2.2");
    if (c.is("kFnOpt", 1))
      c.no_effect("kFnOpt", "has no effect: mode is negative, so that no data files are written",
                  "set kFnOpt to 0 and remove record 2.3");
    if (c.is("kIcOpt", 1) || c.is("kIcOpt", -1))
      c.no_effect("kIcOpt", "has no effect: mode is negative, so that there is no run to continue",
                  "set kIcOpt to 0");
  }
  if (c.is("kRaceFlex", 1))
    c.error("kRaceFlex", "a flexible outer race cannot be simulated", "set it to 0");
}

/// Elements are held up to qFac of the largest load: with 1 and more, all of them, always.
void check_light_loads(Checker& c) {
  const auto ratio = c.value_in_deck_units("qFac");
  if (c.is("mode", 0) && ratio && *ratio >= 1.0)
    c.warning("qFac",
              "a value of 1 or more keeps nearly all elements in force balance all the time, as "
              "with mode = 1",
              "enter a small fraction such as 0.01, or set mode to 1");
}

void check_steps(Checker& c) {
  const auto smallest = c.value_in_deck_units("stpMin");
  const auto largest = c.value_in_deck_units("stpMax");
  const auto first = c.value_in_deck_units("stpInit");
  if (smallest && largest && *smallest > *largest)
    c.error("stpMin",
            fmt::format("the smallest step is larger than the largest step, stpMax = {:.10g}",
                        *largest),
            "enter a value of at most stpMax");
  if (!first) return;
  if (*first == 0.0 && c.integer("kIcOpt") && !c.is("kIcOpt", 1))
    c.error("stpInit",
            "0 reuses the last step size of a stopped run, but kIcOpt does not continue a run",
            "enter a first step size, for instance 0.05");
  else if (*first != 0.0 && largest && *first > *largest)
    c.warning("stpInit",
              fmt::format("is above stpMax = {:.10g} and will be lowered to it", *largest),
              "enter a smaller first step");
  else if (*first != 0.0 && smallest && largest && *smallest <= *largest && *first < *smallest)
    c.warning("stpInit",
              fmt::format("is below stpMin = {:.10g} and will be raised to it", *smallest),
              "enter a larger first step");
}

void check_race_constraints(Checker& c) {
  for (const int race : {1, 2}) {
    const std::string second = fmt::format("kMD2{}", race);
    const std::string third = fmt::format("kMD3{}", race);
    const auto about_y = c.integer(second);
    const auto about_z = c.integer(third);
    if (about_y && about_z && *about_y != *about_z)
      c.error(third,
              fmt::format(
                  "must equal {} = {}: the rotations about y and z must have the same constraint",
                  second, *about_y),
              fmt::format("set both to {}", *about_y));
    const auto mode = c.integer("mode");
    if (!mode || (*mode != 1 && *mode != 2)) continue;
    for (const int axis : {1, 2, 3}) {
      const std::string name = fmt::format("kFD{}{}", axis, race);
      if (c.is(name, 0))
        c.error(name, fmt::format("in mode {}, a race cannot accelerate under forces", *mode),
                "set this variable to 1, or set mode to 0");
    }
  }
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char ch) { return static_cast<char>(std::toupper(ch)); });
  return text;
}

std::string without_blanks_behind(std::string text) {
  text.erase(std::find_if(text.rbegin(), text.rend(), [](char ch) { return ch != ' '; }).base(),
             text.end());
  return text;
}

/// Reason why a results file may not have this name; empty if it may. Names that a shell or another
/// program would interpret are rejected: the first line of a results file contains text of the
/// deck.
std::string_view name_trouble(const std::string& file) {
  if (file.empty() || file.find_first_of("/\\") != std::string::npos || file == "." || file == "..")
    return "is not a valid file name in the output folder";
  const auto plain = [](unsigned char ch) {
    return std::isalnum(ch) != 0 || ch == '.' || ch == '_' || ch == '-' || ch == '+';
  };
  if (!std::all_of(file.begin(), file.end(), plain))
    return "has characters that are not allowed in names of results files";
  if (std::isalnum(static_cast<unsigned char>(file.front())) == 0)
    return "begins with a character that hides the file or looks like an option of a command";
  constexpr std::string_view kPrograms[] = {
      "SH",  "BASH", "CSH",     "KSH",   "ZSH", "FISH", "BAT",  "CMD",  "COM", "EXE", "PS1",
      "PY",  "PL",   "RB",      "JS",    "VBS", "WSF",  "LUA",  "TCL",  "AWK", "SED", "PHP",
      "R",   "JAR",  "MK",      "CMAKE", "SO",  "DLL",  "APP",  "LNK",  "PIF", "SCR", "REG",
      "HTM", "HTML", "DESKTOP", "C",     "CC",  "CPP",  "H",    "HPP",  "F",   "FOR", "F90",
      "INI", "CFG",  "CONF",    "RC",    "YML", "YAML", "TOML", "JSON", "H5",  "CSV"};
  const std::string name = upper(file);
  const std::size_t dot = name.rfind('.');
  if (dot != std::string::npos && std::find(std::begin(kPrograms), std::end(kPrograms),
                                            name.substr(dot + 1)) != std::end(kPrograms))
    return "has the name or extension of a program, script, settings file or other data";
  if (name == "MAKEFILE" || name == "GNUMAKEFILE" || name == "DOCKERFILE")
    return "has the name or extension of a program, script, settings file or other data";
  return {};
}

void check_file_names(Checker& c) {
  if (!c.deck().has_record("2.3")) return;
  constexpr std::array<std::string_view, 10> kNames = {
      "masName",   "finName",   "pltNames1", "pltNames2", "pltNames3",
      "pltNames4", "pltNames5", "pltNames6", "pltNames7", "pltNames8"};
  std::map<std::string, std::string> seen = {
      {"DATA.TXT", "the deck"},         {"PRINT.TXT", "the listing"},
      {"SOL9", "user routine ADRX9"},   {"RUN.JSON", "the run report"},
      {"RESULTS.H5", "the results"},    {"ADORE.JSON", "the run options"},
      {"SWEEP.CSV", "a sweep's table"}, {"SWEEP.JSON", "the state of a sweep"}};
  const std::string& path = c.deck().file;
  if (!path.empty())
    seen.emplace(upper(path.substr(path.find_last_of('/') + 1)), "the deck itself");
  for (const std::string_view name : kNames) {
    if (!c.deck().has(name)) continue;
    const std::string file = without_blanks_behind(c.deck().text(name));
    if (const std::string_view trouble = name_trouble(file); !trouble.empty()) {
      c.error(name, std::string(trouble),
              "enter a name of 1 to 10 letters and digits, for instance SOL1");
      continue;
    }
    const auto [earlier, fresh] = seen.emplace(upper(file), std::string(name));
    if (!fresh)
      c.error(name, fmt::format("this file name is already used by {}", earlier->second),
              "give each file a different name");
  }
}

void check_monitored_bodies(Checker& c) {
  if (!is_dynamic(c)) return;
  const auto count = c.integer("kNumPltElem");
  const auto elements = c.integer("nRe");
  const auto segments = c.integer("nCseg");
  if (!count) return;
  if (*count > 6)
    c.warning("kNumPltElem",
              "the classic plot files SOL1 to SOL6 contain only the first six bodies",
              "monitor at most six bodies");
  const long long bodies = elements && segments ? *elements + *segments + 2 : 0;
  long long last = 0;
  for (int i = 1; i <= *count; ++i) {
    const auto body = c.integer("kPltElemInd", i);
    if (!body) continue;
    if (*body <= last) {
      c.error("kPltElemInd",
              fmt::format("the body numbers must be in increasing order, but {} follows {}", *body,
                          last),
              "sort the numbers and remove duplicates");
      return;
    }
    last = *body;
  }
  if (bodies > 0 && last > bodies)
    c.error("kPltElemInd",
            fmt::format("there is no body {}: the highest body number is {} (the inner race, which "
                        "follows {}, {} and the outer race)",
                        last, bodies, counted(*elements, "element"),
                        counted(*segments, "cage segment")),
            fmt::format("enter numbers from 1 to {}", bodies));
}

/// The spin of balls is a choice; what rollers spin about is their own axis.
void check_spin_rule(Checker& c) {
  const auto rule = c.integer("kAngVel");
  const auto angle = c.value_in_deck_units("angVelOrient");
  const auto type = c.integer("kBrg");
  if (!rule || !type) return;
  if (*type != 1 && *rule == 2)
    c.no_effect("kAngVel", "has no effect on rollers, which spin about their own axis",
                "set it to 0 or 1");
  if (angle && *angle != 0.0 && (*type != 1 || *rule != 2))
    c.no_effect(
        "angVelOrient",
        *type == 1
            ? fmt::format("is not used, because kAngVel = {}; only kAngVel = 2 prescribes the "
                          "spin axis",
                          *rule)
            : "has no effect on rollers, which spin about their own axis",
        *type == 1 ? "set angVelOrient to 0, or set kAngVel to 2" : "set it to 0");
}

void check_types(Checker& c) {
  const auto type = c.integer("kBrg");
  for (const std::string_view flange : {"kFlngInd11", "kFlngInd21", "kFlngInd12", "kFlngInd22"}) {
    if (!c.is(flange, 1) || !type) continue;
    if (*type == 3)
      c.error(flange, "a spherical roller bearing (kBrg 3) has no flanges", "set it to 0");
    if (*type == 1)
      c.no_effect(flange, "a ball bearing (kBrg 1) has no flanges; the flag has no effect",
                  "set it to 0");
  }
  const auto elements = c.integer("nRe");
  if (c.is("kReGeoImp", 2) && elements && *elements > 40)
    c.error("kReGeoImp",
            fmt::format("the list of diameters has 40 values, but the bearing has {} elements",
                        *elements),
            "use code 3 (user routine ADRX8) or code 1 (random errors)");
  if (c.is("kReGeoImp", 2) && elements)
    for (long long i = *elements + 1; i <= 40; ++i) {
      const std::string name = fmt::format("reDiaVar{}", i);
      const auto deviation = c.value_in_deck_units(name);
      if (deviation && *deviation != 0.0)
        c.no_effect(name, "the bearing does not have this element; the value has no effect",
                    "set it to 0");
    }
  const auto lubricant = c.integer("kTrac");
  if (lubricant && *lubricant <= 0) {
    constexpr std::string_view kMessage =
        "code 1 selects the lubricant of kTrac, but kTrac = {} has no lubricant";
    constexpr std::string_view kRemedy =
        "choose a lubricant with kTrac, or choose another medium with this variable";
    if (c.is("kChrn", 1)) c.error("kChrn", fmt::format(kMessage, *lubricant), std::string(kRemedy));
    if (c.is("kCoolant", 1))
      c.error("kCoolant", fmt::format(kMessage, *lubricant), std::string(kRemedy));
  }
  if (c.is("iTherm", 1) && lubricant && *lubricant != 12)
    c.no_effect("iTherm",
                fmt::format("has an effect only with kTrac = 12, but kTrac is {}", *lubricant),
                "set it to 0");
  if (c.is("kCoolant", 0) && (c.is("kBaseTemp", 2) || c.is("kBaseTemp", 3)))
    c.error("kBaseTemp",
            "the reference temperature is that of the coolant, but kCoolant is 0 (no coolant)",
            "choose another reference temperature with kBaseTemp, or a coolant with kCoolant");
}

}  // namespace

void check_control(Checker& checker) {
  check_run_mode(checker);
  check_steps(checker);
  check_light_loads(checker);
  check_race_constraints(checker);
  check_file_names(checker);
  check_monitored_bodies(checker);
  check_types(checker);
  check_spin_rule(checker);
}

}  // namespace adore::deck
