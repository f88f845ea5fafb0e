#include "cli/picture_commands.hpp"

#include "base/errors.hpp"
#include "cli/option_ranges.hpp"
#include "command_line/tree.hpp"

#include <memory>

namespace adore::cli {
namespace {

std::vector<std::string> view_names() {
  return {"bearing", "cage", "pocket", "element", "race", "flange", "section", "3d", "raceways"};
}

void add_progress(CLI::App& command, std::string& style) {
  command_line::one_of(command.add_option("--progress", style, "progress display on stderr")
                           ->capture_default_str()
                           ->type_name("STYLE"),
                       {"auto", "plain", "json", "none"});
}

void add_plot(CLI::App& app, const std::function<void(const PlotRequest&)>& draw) {
  CLI::App* command =
      app.add_subcommand("plot",
                         "draw the charts of SOL1-SOL7, SWEEP.csv, ACCURACY.json "
                         "or the RUN.json of a quasi-static run as PNG, SVG or PDF files");
  auto request = std::make_shared<PlotRequest>();
  auto time = std::make_shared<bool>(false);
  command
      ->add_option("files", request->files,
                   "SOL1-SOL7, RUN.json, SWEEP.csv, ACCURACY.json, or folders of runs")
      ->type_name("PATH");
  CLI::Option* lubricant =
      command
          ->add_option("--lubricant", request->lubricant,
                       "draw charts of a lubricant (traction, viscosity, film, lambda) instead of "
                       "charts of result files; CODE is its kTrac")
          ->type_name("CODE");
  CLI::Option* temperature =
      command
          ->add_option("--temperature", request->temperature,
                       "temperature of lubricant and surfaces [K] (default: 350)")
          ->type_name("K")
          ->needs(lubricant);
  command_line::one_of(command->add_option("--format", request->format, "file format")
                           ->capture_default_str()
                           ->type_name("FORM"),
                       {"png", "svg", "pdf"});
  command->add_option("--out", request->out, "output folder")
      ->type_name("DIR")
      ->default_str("current folder");
  CLI::Option* page =
      command->add_option("--page", request->page, "page number (default: all pages)");
  command->add_option("--from", request->range.from, "first stored step, counted from 1")
      ->capture_default_str();
  CLI::Option* to =
      command->add_option("--to", request->range.to, "last stored step")->default_str("last step");
  command->add_option("--every", request->range.every, "every n-th stored step")
      ->capture_default_str();
  command_line::one_of(command->add_option("--abscissa", request->abscissa, "horizontal axis")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"rev", "time"});
  command_line::one_of(command->add_option("--domain", request->domain, "chart type")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"history", "spectrum", "spectrogram", "envelope", "orders"});
  command
      ->add_option(
          "--curve", request->curve,
          "curve of the spectrogram: its name, part of its name, or its number on the page")
      ->type_name("CURVE")
      ->default_str("first curve");
  command_line::one_of(
      command
          ->add_option(
              "--scale", request->scale,
              "amplitudes of spectra in units of the curve (units), in dB relative to 1 unit (db), "
              "or relative to the maximum (relative); default: units, but db for spectrograms")
          ->type_name("SCALE"),
      {"units", "db", "relative"});
  command_line::one_of(
      command
          ->add_option("--rows", request->rows,
                       "vertical axis of spectrograms: time or shaft speed (default: time)")
          ->type_name("WHAT"),
      {"time", "speed"});
  command
      ->add_option("--band", request->band,
                   "frequency band of an envelope in Hz, LOW:HIGH (default: the band with the most "
                   "impulsive vibration, or else the band with the strongest modulation)")
      ->type_name("BAND");
  command_line::one_of(
      command
          ->add_option("--orders-of", request->orders_of,
                       "part whose rotation is order 1 (default: shaft; without this option, the "
                       "horizontal axis of envelopes is a frequency in Hz)")
          ->type_name("PART"),
      {"shaft", "cage", "element"});
  command->add_flag("--time", *time, "the same as --abscissa time")->group("");
  CLI::Option* dark = command->add_flag("--dark", request->dark, "dark theme");
  CLI::Option* width =
      command
          ->add_option(
              "--width", request->width,
              "draw figures for print with this width [mm], such as 85 (one column) or 170")
          ->type_name("MM")
          ->excludes(dark);
  CLI::Option* height = command
                            ->add_option("--height", request->height,
                                         "height of figures [mm] (default: 0.75 times the width, "
                                         "plus 0.2 times the width for each additional panel)")
                            ->type_name("MM")
                            ->needs(width);
  CLI::Option* letters =
      command->add_option("--letters", request->letters, "font size of figures [pt]")
          ->type_name("PT")
          ->capture_default_str()
          ->needs(width);
  command->add_option("--font", request->font, "font family of figures (default: DejaVu Sans)")
      ->type_name("NAME")
      ->needs(width);
  command
      ->add_flag("--gray", request->gray, "draw figures with gray lines in different dash patterns")
      ->needs(width);
  add_progress(*command, request->progress);
  command->footer(
      "Examples\n"
      "  adore plot SOL1 SOL7 --page 1 --out pictures\n"
      "  adore plot SOL2 --page 1 --width 85 --format pdf\n"
      "  adore plot --lubricant 4 --temperature 394 --out pictures");
  command->callback([=] {
    if ((lubricant->count() > 0) != request->files.empty())
      throw InputError("give either result files or --lubricant with a kTrac code");
    if (lubricant->count() > 0) check_range("--lubricant", request->lubricant);
    if (temperature->count() > 0) check_range("--temperature", request->temperature);
    if (page->count() > 0) check_range("--page", request->page);
    check_range("--from", static_cast<double>(request->range.from));
    if (to->count() > 0) check_range("--to", static_cast<double>(request->range.to));
    check_range("--every", static_cast<double>(request->range.every));
    if (width->count() > 0) check_range("--width", request->width);
    if (height->count() > 0) check_range("--height", request->height);
    if (letters->count() > 0) check_range("--letters", request->letters);
    if (*time) request->abscissa = "time";
    draw(*request);
  });
}

void add_animate(CLI::App& app, const std::function<void(const AnimateRequest&)>& draw) {
  CLI::App* command =
      app.add_subcommand("animate", "draw frames or a movie from SOL8 or RESULTS.h5");
  auto request = std::make_shared<AnimateRequest>();
  command->add_option("file", request->file, "SOL8, RESULTS.h5, or the folder of a run")
      ->required()
      ->type_name("PATH");
  command_line::one_of(command->add_option("--view", request->view, "view to draw")
                           ->capture_default_str()
                           ->type_name("VIEW"),
                       view_names());
  command
      ->add_option("--beside", request->beside,
                   "additional views of the same frame, separated by commas")
      ->type_name("LIST");
  command
      ->add_option("--yaw", request->yaw, "viewing direction of the 3d view: angle from +X [deg]")
      ->capture_default_str()
      ->type_name("NUMBER");
  command
      ->add_option("--elevation", request->elevation,
                   "viewing direction of the 3d view: angle above the horizontal plane [deg]")
      ->capture_default_str()
      ->type_name("NUMBER");
  command_line::one_of(command
                           ->add_option("--race", request->race,
                                        "race of the race view (default: inner) or of the flange "
                                        "view (default: a race that has a flange)")
                           ->type_name("RACE"),
                       {"outer", "inner"});
  command
      ->add_option("--element", request->element,
                   "number of the element or pocket, for views that show only one of them")
      ->capture_default_str();
  CLI::Option* frame = command->add_option("--frame", request->frame,
                                           "frame number, counted from 1 (default: all frames)");
  CLI::Option* every =
      command->add_option("--every", request->every, "every n-th frame")->capture_default_str();
  CLI::Option* movie = command
                           ->add_option("--movie", request->movie,
                                        "movie to write: NAME.avi, NAME.gif, NAME.mp4 (needs "
                                        "ffmpeg), or a folder of numbered pictures")
                           ->type_name("FILE");
  CLI::Option* html =
      command
          ->add_option("--html", request->html,
                       "HTML file to write, with the animated 3D scene for a web browser: "
                       "NAME.html (needs libjs-three)")
          ->type_name("FILE")
          ->excludes(movie);
  command->add_option("--fps", request->frames_per_second, "movie frames per second")
      ->capture_default_str();
  CLI::Option* slow = command
                          ->add_option("--slow", request->slow,
                                       "slow motion: simulated seconds per second of the movie, "
                                       "e.g. 0.001 (default: one picture for each stored frame)")
                          ->type_name("NUMBER")
                          ->needs(movie)
                          ->excludes(every);
  frame->excludes(every)->excludes(movie)->excludes(html);
  CLI::Option* first = command->add_option("--from", request->first, "first frame, counted from 1")
                           ->capture_default_str()
                           ->excludes(frame);
  CLI::Option* last =
      command->add_option("--to", request->last, "last frame (default: last frame of the file)")
          ->excludes(frame);
  command->add_option("--out", request->out, "output folder")
      ->type_name("DIR")
      ->default_str("current folder");
  command_line::one_of(command->add_option("--color,--colour", request->colour, "color elements by")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"none", "load", "slip", "heat", "temperature", "pressure"});
  command
      ->add_option("--scale", request->scale,
                   "color scale: usual (covers 95 % of the values of the run), run (up to the "
                   "largest value of the run), moment (range of this frame), or limits such as "
                   "0:0.02 in the unit of the file")
      ->capture_default_str()
      ->type_name("SCALE");
  command->add_flag("--contacts", request->contacts,
                    "draw the race loads as arrows on all elements");
  command->add_flag("--trails", request->trails,
                    "draw the recent path of each element (length: 0.8 of the element spacing)");
  command->add_flag("--dark", request->dark, "dark theme");
  add_progress(*command, request->progress);
  command->footer(
      "Examples\n"
      "  adore animate SOL8 --frame 1 --out pictures\n"
      "  adore animate SOL8 --view cage --every 5 --movie cage.avi\n"
      "  adore animate SOL8 --from 100 --to 300 --slow 0.001 --movie start.mp4\n"
      "  adore animate out --html scene.html\n"
      "  adore animate SOL8 --view 3d --beside bearing,section --contacts --frame 1");
  command->callback([=] {
    if (frame->count() > 0) check_range("--frame", request->frame);
    if (first->count() > 0) check_range("--from", request->first);
    if (last->count() > 0) check_range("--to", request->last);
    check_range("--every", request->every);
    if (html->count() > 0 && every->count() == 0) request->every = 0;  // chosen from the size
    check_range("--fps", request->frames_per_second);
    if (slow->count() > 0) check_range("--slow", request->slow);
    check_range("--element", request->element);
    draw(*request);
  });
}

void add_gallery(CLI::App& app, const std::function<void(const GalleryRequest&)>& draw) {
  CLI::App* command =
      app.add_subcommand("gallery", "draw all pages and views of runs as PNG files, with an index");
  auto request = std::make_shared<GalleryRequest>();
  command
      ->add_option("runs", request->runs,
                   "folders of runs (default: run the example decks of all bearing types)")
      ->type_name("FOLDER");
  command->add_option("--out", request->out, "output folder")
      ->capture_default_str()
      ->type_name("DIR");
  command->add_option("--size", request->size, "picture size in pixels, WIDTHxHEIGHT")
      ->capture_default_str()
      ->type_name("SIZE");
  command->add_flag("--dark", request->dark, "dark theme");
  add_progress(*command, request->progress);
  command->footer("Example\n  adore gallery --out gallery");
  command->callback([=] { draw(*request); });
}

void add_report(CLI::App& app, const std::function<void(const ReportRequest&)>& draw) {
  CLI::App* command = app.add_subcommand(
      "report", "write report.html and report.pdf of runs: deck, results, findings, charts");
  auto request = std::make_shared<ReportRequest>();
  command
      ->add_option("runs", request->runs,
                   "folders of runs; a table compares the results of several runs")
      ->type_name("FOLDER");
  command->add_option("--out", request->out, "output folder")
      ->capture_default_str()
      ->type_name("DIR");
  command_line::one_of(
      command
          ->add_option("--charts", request->charts,
                       "charts in the report: main (loads, slip, orbit of the cage, power, life, "
                       "and pages with warnings) or all (all pages of all files)")
          ->capture_default_str()
          ->type_name("WHICH"),
      {"main", "all"});
  command
      ->add_option("--template", request->file,
                   "HTML template with {{name}} in place of each part of the report (default: "
                   "built-in template)")
      ->type_name("FILE");
  command->add_flag("--print-template", request->print_template,
                    "print the built-in template, so that you can edit it");
  add_progress(*command, request->progress);
  command->footer(
      "Examples\n"
      "  adore report out --out report\n"
      "  adore report --print-template > mine.html\n"
      "  adore report run-1 run-2 --template mine.html --out report");
  command->callback([=] {
    if (request->runs.empty() != request->print_template)
      throw InputError("give folders of runs, or --print-template alone");
    draw(*request);
  });
}

}  // namespace

void add_picture_commands(CLI::App& app, const PictureActions& actions) {
  add_plot(app, actions.plot);
  add_animate(app, actions.animate);
  add_gallery(app, actions.gallery);
  add_report(app, actions.report);
}

}  // namespace adore::cli
