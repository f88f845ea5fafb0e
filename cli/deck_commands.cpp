#include "base/counted.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "cli/assembly.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/option_ranges.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "deck/catalogue.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/number.hpp"
#include "deck/quantity.hpp"
#include "deck/rated_bearings.hpp"
#include "deck/templates.hpp"
#include "deck/units.hpp"
#include "design/bearing_candidates.hpp"
#include "design/catalogue_ratings.hpp"
#include "runs/check.hpp"
#include "runs/deck_story.hpp"
#include "runs/operating_point.hpp"
#include "runs/plan.hpp"
#include "studies/what_if.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace adore::cli {
namespace {

/// All errors and warnings of a deck; missing features are a note here and an error of `run`.
int check(const DeckOptions& options, bool json) {
  if (is_assembly_deck(options)) return check_assembly(options, json);
  runs::DeckRequest request;
  options.fill(request);
  const runs::CheckReport report = runs::check(request);
  const std::vector<Finding>& issues = report.issues;
  const bool ok = report.ok();
  if (json) {
    nlohmann::ordered_json out;
    out["file"] = report.file;
    out["ok"] = ok;
    out["issues"] = nlohmann::ordered_json::array();
    std::vector<Finding> listed = shown_findings(issues);
    std::copy_if(issues.begin(), issues.end(), std::inserter(listed, listed.begin()),
                 [](const Finding& one) { return one.severity == Severity::Error; });
    for (const Issue& issue : listed)
      out["issues"].push_back({{"severity", severity_word(issue.severity)},
                               {"line", issue.line},
                               {"record", issue.record},
                               {"variable", issue.variable},
                               {"value", issue.value},
                               {"message", issue.message},
                               {"remedy", issue.remedy}});
    out["findings"] = findings_json(issues);
    print("{}\n", dump_json(out, 2));
  } else {
    std::size_t errors = 0;
    for (const Finding& issue : issues)
      if (issue.severity == Severity::Error) {
        print("{}\n", issue.text());
        ++errors;
      }
    const std::vector<Finding> others = shown_findings(issues);
    for (const Finding& one : others) print("{}\n", one.text());
    print("{}: {} records, {}, {}\n", report.file, report.records, counted(errors, "error"),
          counted(others.size(), "warning or note", "warnings or notes"));
  }
  return ok ? 0 : 2;
}

struct PlanOptions : DeckOptions {
  bool json = false, what_if = false;
  double turns = 2.0, pilot = runs::kPlanPilot;
  std::string until;
};

std::string what_if_of(const PlanOptions& options, const runs::DeckRequest& request,
                       nlohmann::ordered_json& json) {
  studies::WhatIfRequest study;
  static_cast<runs::DeckRequest&>(study) = request;
  study.turns = options.turns;
  const InterruptWatch watch;
  const studies::WhatIf result = studies::what_if(study, {}, watch.token());
  json["what_if"] = studies::what_if_json(result);
  return studies::what_if_text(result);
}

void plan(const PlanOptions& options) {
  check_range("--turns", options.turns);
  check_range("--pilot", options.pilot);
  // Loading and start of the program, which a run has, too.
  const double start = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  runs::RunRequest request;
  options.fill(request);
  request.until = options.until;
  const InterruptWatch watch;
  runs::PlanReport report = runs::plan_of_run(request, options.pilot, start, watch.token());
  print_warnings(report.remarks);
  if (!options.json) print("{}", report.text);
  std::fflush(stdout);
  const std::string differences = options.what_if ? what_if_of(options, request, report.json) : "";
  print("{}{}", options.json ? dump_json(report.json, 2) : differences, options.json ? "\n" : "");
}

std::string text_of(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

/// Writes a new deck if the file does not exist; returns its path, or none for standard output.
std::string write_new(const std::string& out, std::string_view text) {
  std::filesystem::path path(out);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) path /= "DATA.txt";
  if (!out.empty() && out != kStream && std::filesystem::exists(path))
    throw InputError(fmt::format("{} exists already; give another file, or remove this file first",
                                 path.string()));
  return write_text(out, "DATA.txt", text);
}

/// A deck with the values of --set. @throws InputError with every error of the changed deck
runs::LoadedDeck changed(std::string_view text, const std::vector<std::string>& sets) {
  DeckOptions options;
  options.sets = sets;
  runs::DeckRequest request;
  for (auto& set : options.parse_set_options()) request.sets.push_back(std::move(set));
  request.text = std::string(text);
  request.deck = "new deck";
  request.in_memory = true;
  return runs::load_deck(request);
}

/// The text of the changed deck, with the remarks of the template.
std::string with_sets(std::string_view text, const std::vector<std::string>& sets) {
  if (sets.empty()) return std::string(text);
  const runs::LoadedDeck loaded = changed(text, sets);
  print_warnings(loaded.warnings);
  return deck::with_deck(text, loaded.deck).text;
}

void new_deck(const std::string& type, const std::string& out,
              const std::vector<std::string>& sets) {
  const std::string text = with_sets(deck::template_text(type), sets);
  const std::string written = write_new(out, text);
  if (written.empty()) return;
  tell(fmt::format("wrote {}\n{}", written, text_of(runs::deck_story(changed(text, {}).deck))));
}

struct NewOptions {
  std::string type, out, designation, from, bearing_type;
  std::string arrangement;         ///< --assembly
  std::vector<std::string> decks;  ///< --deck, of its rows
  std::optional<double> preload, offset;
  double bore = 0.0;
  int choose = 0;
  bool list = false, json = false, ratings = false;
  std::vector<std::string> sets;
  std::string radial, axial, speed, temperature, oil;  ///< as written, with or without unit
};

/// A number in `unit`, or with a unit of the same dimension: "4kN". Empty text: not given.
std::optional<double> quantity(const char* option, const std::string& text,
                               const deck::UnitPair& unit, const char* example) {
  if (text.empty()) return std::nullopt;
  double value = 0.0;
  if (const deck::NumberProblem problem =
          deck::parse_quantity(text, unit, deck::UnitSystem::SI, value))
    throw InputError(
        fmt::format("{} \"{:.60}\" {}. Enter a number in {} or with a unit, such as {}.", option,
                    text, problem.message, unit.si, example));
  return value;
}

/// Degrees Celsius of a plain number, else of a temperature with unit.
std::optional<double> celsius(const std::string& text) {
  constexpr double kZeroCelsius = 273.15;
  double value = 0.0;
  if (!text.empty() && !deck::parse_real(text, value)) return value;
  std::optional<double> kelvin =
      quantity("--temperature", text, deck::unit::kTemperature, "70degC");
  if (kelvin) *kelvin -= kZeroCelsius;
  return kelvin;
}

runs::OperatingPoint operating_point(const NewOptions& o) {
  runs::OperatingPoint out;
  out.radial = quantity("--radial", o.radial, deck::unit::kForce, "4kN");
  out.axial = quantity("--axial", o.axial, deck::unit::kForce, "500N");
  out.speed = quantity("--speed", o.speed, deck::unit::kRotation, "314rad/s");
  out.temperature = celsius(o.temperature);
  out.oil = o.oil;
  return out;
}

/// --set entries of the operating point; later ones win.
std::vector<std::string> operating_sets(const NewOptions& o) {
  std::vector<std::string> out;
  for (const auto& [name, value] : runs::deck_assignments(operating_point(o)))
    out.push_back(name + "=" + value);
  out.insert(out.end(), o.sets.begin(), o.sets.end());
  return out;
}

void write_bearing(const deck::CatalogueBearing& bearing, const NewOptions& o) {
  const std::string written =
      write_new(o.out, with_sets(deck::catalogue_deck(bearing), operating_sets(o)));
  const std::string story = text_of(deck::describe_catalogue_bearing(bearing));
  tell(written.empty() ? story : fmt::format("wrote {}\n{}", written, story));
}

std::vector<assembly::RowDeckText> rows_of(const NewOptions& o) {
  NewOptions row = o;  // the load is that of the set
  row.radial.clear();
  row.axial.clear();
  DeckOptions options;
  options.sets = operating_sets(row);
  const auto sets = options.parse_set_options();
  const auto as_row = [&](const std::string& text) {
    return assembly::RowDeckText{assembly::make_row_deck(text, sets), {}};
  };
  if (!o.designation.empty())
    return {as_row(deck::catalogue_deck(deck::find_bearing(o.designation)))};
  if (!o.type.empty()) return {as_row(std::string(deck::template_text(o.type)))};
  std::vector<assembly::RowDeckText> out;
  for (const std::string& name : o.decks) {
    const std::filesystem::path deck = runs::deck_path(name);
    out.push_back(as_row(read_text_file(deck)));
    const std::filesystem::path extension = deck.parent_path() / "ADORE.json";
    std::error_code error;
    if (std::filesystem::exists(extension, error)) out.back().extension = read_text_file(extension);
  }
  return out;
}

void new_set(const NewOptions& o) {
  const std::vector<assembly::RowDeckText> rows = rows_of(o);
  if (rows.empty())
    throw InputError(
        "--assembly: the bearing rows are missing; give the name of an example, --catalogue "
        "BEARING, or --deck FILE (once, or once for each row)");
  const runs::OperatingPoint point = operating_point(o);
  write_assembly({o.arrangement, o.out, o.preload, o.offset, point.axial, point.radial}, rows);
}

/// Without --choose: the table of candidates only.
int new_from_facts(const NewOptions& o) {
  constexpr std::size_t kLargestFacts = 1 << 20;
  const std::string text = o.from == kStream ? read_standard_input(kLargestFacts)
                                             : read_text_file(o.from, kLargestFacts);
  const design::CandidateReport report = design::find_candidates(design::read_facts(text, o.from));
  if (o.choose != 0) {
    write_bearing(design::candidate_bearing(report, o.choose), o);
    return 0;
  }
  if (o.json)
    print("{}\n", dump_json(design::candidates_json(report), 2));
  else
    print("{}{}", design::candidates_text(report),
          report.candidates.empty()
              ? ""
              : "To write the deck of candidate N, add --choose N --out DATA.txt.\n");
  return report.candidates.empty() ? 2 : 0;
}

/// Ratings of a bearing that no deck describes.
void print_ratings(const deck::RatedBearing& bearing, const NewOptions& o) {
  if (!o.ratings)
    throw InputError(
        fmt::format("{}: decks cannot describe a {} yet. Give --ratings for its dimensions and "
                    "estimated ratings.",
                    bearing.designation, deck::rated_bearing_type_name(bearing.type)));
  if (!o.json) return print("{}", text_of(design::describe_ratings(bearing)));
  const design::CatalogueRatings r = design::catalogue_ratings(bearing);
  const nlohmann::ordered_json out{{"name", bearing.designation},
                                   {"type", deck::rated_bearing_type_name(bearing.type)},
                                   {"bore [m]", bearing.envelope.bore},
                                   {"outside [m]", bearing.envelope.outside},
                                   {"width [m]", bearing.envelope.width},
                                   {"contact_angle [deg]", bearing.angle},
                                   {"C [N]", r.C},
                                   {"C0 [N]", r.C0},
                                   {"axial", r.axial},
                                   {"estimate", true},
                                   {"source", bearing.source}};
  print("{}\n", dump_json(out, 2));
}

/// Bearings of --bore that no deck describes; none with --type.
std::vector<deck::RatedBearing> listed_rated(const NewOptions& o) {
  if (!o.bearing_type.empty()) return {};
  std::vector<deck::RatedBearing> all = deck::rated_bearings();
  constexpr double kSame = 0.5e-3;
  if (o.bore > 0.0)
    std::erase_if(all, [&](const deck::RatedBearing& one) {
      return std::abs(one.envelope.bore - 1e-3 * o.bore) > kSame;
    });
  return all;
}

void list_catalogue(const NewOptions& o) {
  const std::vector<deck::CatalogueBearing> all = deck::catalogue_list(o.bore, o.bearing_type);
  if (o.json) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const deck::CatalogueBearing& one : all)
      out.push_back({{"name", one.designation},
                     {"type", deck::bearing_type_keyword(one.type)},
                     {"bore [m]", one.envelope.bore},
                     {"outside [m]", one.envelope.outside},
                     {"width [m]", one.envelope.width},
                     {"contact_angle [deg]", one.angle},
                     {"test_rig", one.rig}});
    for (const deck::RatedBearing& one : listed_rated(o))
      out.push_back({{"name", one.designation},
                     {"type", deck::rated_bearing_type_name(one.type)},
                     {"bore [m]", one.envelope.bore},
                     {"outside [m]", one.envelope.outside},
                     {"width [m]", one.envelope.width},
                     {"contact_angle [deg]", one.angle},
                     {"ratings_only", true}});
    print("{}\n", dump_json(out, 2));
    return;
  }
  for (const deck::CatalogueBearing& one : all)
    print("{:<20} {:<16} {:>8g} x {:g} x {:g} mm{}\n", one.designation,
          deck::bearing_type_keyword(one.type), one.envelope.bore * 1e3, one.envelope.outside * 1e3,
          one.envelope.width * 1e3, one.rig ? "  public test rig" : "");
  const std::vector<deck::RatedBearing> rated = listed_rated(o);
  for (const deck::RatedBearing& one : rated)
    print("{:<20} {:<16} {:>8g} x {:g} x {:g} mm  ratings only\n", one.designation,
          deck::rated_bearing_type_name(one.type), one.envelope.bore * 1e3,
          one.envelope.outside * 1e3, one.envelope.width * 1e3);
  print("{} bearings. `adore new --catalogue NAME` writes a deck", all.size());
  if (!rated.empty()) print(". {} only with --ratings", counted(rated.size(), "bearing"));
  print("\n");
}

const deck::TemplateInfo& example(const std::string& name) {
  (void)deck::template_text(name);  // refuses an unknown one
  return *std::find_if(deck::templates().begin(), deck::templates().end(),
                       [&](const deck::TemplateInfo& info) { return info.name == name; });
}

nlohmann::ordered_json example_json(const deck::TemplateInfo& info) {
  return {{"name", info.name},
          {"description", info.description},
          {"does", runs::deck_story(deck::new_deck(info.name))}};
}

void examples(const std::string& name, bool json) {
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const deck::TemplateInfo& info : deck::templates())
      if (name.empty() || info.name == name) list.push_back(example_json(info));
    if (!name.empty()) (void)example(name);
    print("{}\n", dump_json(list, 2));
  } else if (!name.empty()) {
    print("{}: {}\n{}", name, example(name).description,
          text_of(runs::deck_story(deck::new_deck(name))));
  } else {
    for (const deck::TemplateInfo& info : deck::templates())
      print("{:<20} {}\n", info.name, info.description);
    print("\n`adore examples NAME` describes a deck; `adore new NAME --out FILE` writes it\n");
  }
}

std::vector<std::string> template_names() {
  std::vector<std::string> out;
  for (const deck::TemplateInfo& info : deck::templates()) out.emplace_back(info.name);
  return out;
}

}  // namespace

void add_deck_commands(CLI::App& app, int& exit_code) {
  {
    CLI::App* command = app.add_subcommand("check", "list all errors and warnings of a deck");
    auto options = std::make_shared<DeckOptions>();
    auto json = std::make_shared<bool>(false);
    options->add_to(*command);
    auto codes = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "print as JSON");
    command->add_flag("--codes", *codes,
                      "print a reference page (Markdown) of the codes of all errors and warnings; "
                      "no deck is read");
    command->footer(
        "Examples\n"
        "  adore check DATA.txt\n"
        "  adore check DATA.txt --set rpm2=20000\n"
        "  adore new ball | adore check -");
    command->callback([=, &exit_code] {
      if (*codes)
        print("{}", finding_codes_page());
      else
        exit_code = check(*options, *json);
    });
  }
  {
    CLI::App* command = app.add_subcommand("plan",
                                           "show the effects that a deck simulates, with reasons, "
                                           "and the computing time and disk space of a run");
    auto options = std::make_shared<PlanOptions>();
    options->add_to(*command);
    command->add_flag("--json", options->json, "print as JSON");
    command
        ->add_option("--until", options->until,
                     "simulated length: revolutions (5rev), time (0.02s) or dimensionless time "
                     "(1000); replaces fTime and maxStps")
        ->type_name("END");
    command
        ->add_option("--pilot", options->pilot,
                     "processor time of the trial run that measures the computing speed [s]; 0: no "
                     "trial run")
        ->capture_default_str();
    CLI::Option* what_if =
        command->add_flag("--what-if", options->what_if,
                          "repeat a short run with each effect switched off in turn; show how the "
                          "results and the computing time change");
    command->add_option("--turns", options->turns, "shaft revolutions of each run of --what-if")
        ->needs(what_if)
        ->capture_default_str();
    command->footer(
        "Examples\n"
        "  adore plan DATA.txt\n"
        "  adore plan DATA.txt --what-if --turns 5\n"
        "  adore plan DATA.txt --until 20rev\n"
        "  adore plan DATA.txt --set kTrac=0 --json");
    command->callback([=] { plan(*options); });
  }
  {
    CLI::App* command = app.add_subcommand(
        "schema", "print the deck format: all records and variables with units and ranges");
    auto format = std::make_shared<std::string>("tsv");
    auto json = std::make_shared<bool>(false);
    command_line::one_of(command->add_option("--format", *format, "table format")
                             ->capture_default_str()
                             ->type_name("FORM"),
                         {"tsv", "json", "md"});
    command->add_flag("--json", *json, "print as JSON; the same as --format json");
    command->footer("Example\n  adore schema --format md > records.md");
    command->callback([=] {
      const std::string form = *json ? "json" : *format;
      write_text("", "",
                 form == "tsv"    ? deck::schema_tsv()
                 : form == "json" ? deck::schema_json()
                                  : deck::schema_markdown());
    });
  }
  {
    CLI::App* command = app.add_subcommand("new", "write and describe a complete, runnable deck");
    auto o = std::make_shared<NewOptions>();
    CLI::Option* name =
        command->add_option("type", o->type,
                            "example deck: ball, cylindrical, spherical, tapered, "
                            "spherical-tapered or another name listed by `adore examples`");
    command_line::suggest_values(name->type_name("NAME"), template_names());
    CLI::Option* catalogue =
        command
            ->add_option("--catalogue", o->designation,
                         "bearing designation (6205, 7208 B, NU209, 30208, 22210), type and size "
                         "('deep-groove 25x52x15' in mm) or public test rig (CWRU-6205-DE). The "
                         "boundary dimensions are standard values. The internal geometry is "
                         "estimated, except for test rigs")
            ->type_name("BEARING")
            ->excludes(name);
    command
        ->add_flag(
            "--ratings", o->ratings,
            "with --catalogue: print dimensions and estimated ratings of a bearing type that decks "
            "cannot describe (QJ2, QJ3, 32, 33, 12, 13, 22, 23, NA49, 511, 512, 811, 812)")
        ->needs(catalogue);
    CLI::Option* from =
        command
            ->add_option("--from", o->from,
                         "JSON file of published facts about a bearing (designation, bore, C, C0, "
                         "BPFO, ...), or - for standard input; lists all internal geometries that "
                         "agree with these facts")
            ->type_name("FACTS")
            ->excludes(name)
            ->excludes(catalogue);
    command
        ->add_option(
            "--choose", o->choose,
            "number of a candidate in the list of --from; the deck of this candidate is written")
        ->type_name("N")
        ->needs(from);
    CLI::Option* list = command->add_flag("--list", o->list, "list the bearings of the catalog")
                            ->excludes(name)
                            ->excludes(catalogue)
                            ->excludes(from);
    command->add_option("--bore", o->bore, "with --list: bore of the listed bearings [mm]")
        ->type_name("MM")
        ->needs(list);
    command_line::one_of(
        command->add_option("--type", o->bearing_type, "with --list: type of the listed bearings")
            ->type_name("TYPE")
            ->needs(list),
        deck::bearing_type_keywords());
    command->add_flag("--json", o->json,
                      "print the list of --list or the candidates of --from as JSON");
    command
        ->add_option("--radial", o->radial,
                     "radial load (appLoadZ) [N], or a value with its unit, such as 4kN")
        ->type_name("LOAD");
    command
        ->add_option("--axial", o->axial,
                     "axial load (appLoadX) [N], or a value with its unit, such as 500N")
        ->type_name("LOAD");
    command
        ->add_option(
            "--speed", o->speed,
            "speed of the inner race (rpm2) [rpm], or a value with its unit, such as 314rad/s")
        ->type_name("SPEED");
    command
        ->add_option("--temperature", o->temperature,
                     "temperature of housing, shaft, races and elements [degrees Celsius], or a "
                     "value with its unit, such as 343K")
        ->type_name("TEMPERATURE");
    command
        ->add_option("--oil", o->oil,
                     "oil: its number (kTrac), or the first letters of its name in the oil table "
                     "of the manual, such as FVA-3")
        ->type_name("OIL");
    CLI::Option* assembly =
        command
            ->add_option(
                "--assembly", o->arrangement,
                "write a set of bearing rows on one shaft: a folder with ASSEMBLY.json and a deck "
                "for each row (DB back to back, DF face to face, DT tandem, TBT, TFT, TT, "
                "QBC, QFC, QBT, QFT, QT)")
            ->type_name("ARRANGEMENT")
            ->excludes(list)
            ->excludes(from);
    command
        ->add_option(
            "--deck", o->decks,
            "with --assembly: deck of a row; give --deck once for all rows, or once for each row")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->needs(assembly)
        ->excludes(name)
        ->excludes(catalogue);
    command
        ->add_option("--preload", o->preload,
                     "with --assembly: preload of the bearing set before mounting [N]")
        ->type_name("N")
        ->needs(assembly);
    command
        ->add_option("--offset", o->offset,
                     "with --assembly: axial gap of the bearing set that clamping closes [um]")
        ->type_name("UM")
        ->needs(assembly);
    command->add_option("--out", o->out, "file or folder to write (default: standard output)")
        ->type_name("FILE");
    command->footer(
        "Examples\n"
        "  adore new ball --out DATA.txt\n"
        "  adore new --list --bore 25 --type deep-groove\n"
        "  adore new --catalogue 6205 --radial 1.5kN --speed 3000 --temperature 70 --out DATA.txt\n"
        "  adore new --from FACTS.json\n"
        "  adore new --from FACTS.json --choose 1 --out DATA.txt\n"
        "  adore new --assembly DB --catalogue 7012C --preload 211 --speed 10000 --out SET");
    add_sets(*command, o->sets);
    command->callback([=, &exit_code] {
      if (o->list) return list_catalogue(*o);
      if (!o->arrangement.empty()) return new_set(*o);
      if (!o->from.empty()) {
        exit_code = new_from_facts(*o);
        return;
      }
      if (!o->designation.empty()) {
        if (const auto rated = deck::find_rated_bearing(o->designation))
          return print_ratings(*rated, *o);
        if (o->ratings)
          throw InputError(
              "--ratings is only for bearing types that decks cannot describe (`adore new "
              "--list`). Run the deck of this bearing; its results contain the ratings.");
        return write_bearing(deck::find_bearing(o->designation), *o);
      }
      if (o->type.empty())
        throw InputError(
            "give the name of an example (`adore examples` lists them), a bearing with --catalogue "
            "(--list lists them), or published facts with --from");
      new_deck(o->type, o->out, operating_sets(*o));
    });
  }
  {
    CLI::App* command = app.add_subcommand("examples", "list the example decks, or describe one");
    auto name = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command_line::suggest_values(
        command->add_option("name", *name, "example to describe")->type_name("NAME"),
        template_names());
    command->add_flag("--json", *json, "print as JSON");
    command->footer("Example\n  adore examples deep-groove-6205");
    command->callback([=] { examples(*name, *json); });
  }
}

}  // namespace adore::cli
