// Adore as a library: how the stiffness of a bearing changes with its speed, and a short run at the
// last of them.
//
//   cmake --install build/release --prefix ~/adore --component library
//   cmake -S resources/examples/cpp-library -B out/example -DCMAKE_PREFIX_PATH=~/adore
//   cmake --build out/example && out/example/bearing_speeds out/run
#include <adore/base/errors.hpp>
#include <adore/deck/templates.hpp>
#include <adore/results/h5_reader.hpp>
#include <adore/runs/equilibrium.hpp>
#include <adore/runs/run.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

// A deck that this program holds; adore::runs::DeckRequest also takes the path of a file.
adore::runs::DeckRequest example(const std::string& rpm) {
  adore::runs::DeckRequest request;
  request.deck = "ball";  // what messages call it
  request.text = std::string(adore::deck::template_text("ball"));
  request.in_memory = true;
  request.sets = {{"rpm2", rpm}};  // in the deck's units, as `adore run --set`
  return request;
}

int study(const std::string& folder) {
  for (const char* rpm : {"1000", "10000", "20000"}) {
    const adore::runs::Equilibrium solution = adore::runs::solve_equilibrium(example(rpm));
    std::printf("%5s rpm: axial stiffness %.4g N/m, displacement %.4g m\n", rpm,
                solution.stiffness[0][0], solution.displacement[0]);
  }

  adore::runs::RunRequest run;
  static_cast<adore::runs::DeckRequest&>(run) = example("20000");
  run.out = folder;
  run.until = "0.1rev";
  run.overwrite = true;
  const adore::runs::RunOutcome outcome =
      adore::runs::run(run, [](const adore::runs::Progress& at) {
        std::fprintf(stderr, "%3.0f %%\n", 100.0 * at.fraction);
      });
  if (outcome.status != adore::runs::RunStatus::Done) {
    std::fprintf(stderr, "%s\n", outcome.message.c_str());
    return 3;
  }

  const adore::results::H5Reader results(outcome.folder / "RESULTS.h5");
  const std::vector<double> loads = results.read("contact.load");
  std::printf("%ld steps; largest contact load %.6g N\n", outcome.steps,
              *std::max_element(loads.begin(), loads.end()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return study(argc > 1 ? argv[1] : "out");
  } catch (
      const adore::InputError& error) {  // every problem of deck, file or argument, a line each
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const adore::SolverError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
