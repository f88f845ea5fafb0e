#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/pictures.hpp"

#include <memory>

namespace adore::cli {

void add_picture_commands(CLI::App& app, int&) {
  for (const char* name : {"plot", "animate"}) {
    CLI::App* command = app.add_subcommand(name, "pictures of result files (this build has no Qt)");
    command->footer("Without Qt\n  adore convert SOL1 --to csv --out sol1.csv");
    command->allow_extras();
    command->callback([name] {
      throw InputError(std::string("`adore ") + name +
                       "` draws with Qt, and this program was built without it; build with "
                       "ADORE_WITH_QT=ON (preset release), "
                       "or use `adore convert FILE --to csv` and a plotter of your own");
    });
  }
}

bool has_pictures() noexcept { return false; }

bool draw_accuracy_chart(const facade::AccuracyStudy&, const std::filesystem::path&) {
  return false;
}

}  // namespace adore::cli
