#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "cli/pictures/drawing.hpp"
#include "cli/pictures/study_charts.hpp"
#include "cli/streams.hpp"
#include "cli/whole_program.hpp"
#include "command_line/program.hpp"

#include <memory>
#include <string>

int main(int argc, char** argv) {
  return adore::cli::whole_program([&] {
    const auto app = adore::command_line::make_program(
        "Drawing program of Adore, started by `adore plot`, `adore animate`, `adore gallery` and "
        "`adore report`.",
        "adore-pictures");
    app->require_subcommand(1);
    adore::cli::add_picture_commands(*app, adore::cli::drawing_actions());
    CLI::App* chart = app->add_subcommand("accuracy-chart", "error against computing time");
    auto table = std::make_shared<std::string>(), picture = std::make_shared<std::string>();
    chart->add_option("table", *table, "ACCURACY.json")->required();
    chart->add_option("picture", *picture, "PNG file to write")->required();
    chart->callback([=] { adore::cli::draw_accuracy_chart(*table, *picture); });
    CLI::App* study =
        app->add_subcommand("study-charts", "draw curves, maps and bar charts of a study");
    study->add_option("charts", *table, "CHARTS.json")->required();
    study->add_option("folder", *picture, "folder of the PNG files")->required();
    auto quiet = std::make_shared<bool>(false);
    study->add_flag("--quiet", *quiet, "do not print file names");
    study->callback([=] { adore::cli::draw_study_charts(*table, *picture, *quiet); });
    return adore::command_line::parse(*app, argc, argv).value_or(0);
  });
}
