#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "studies/model_errors.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <set>

using namespace adore;
using namespace adore::runs;
using namespace adore::studies;

namespace {

DeckRequest example(const char* name) {
  DeckRequest request;
  request.text = std::string(deck::template_text(name));
  return request;
}

std::set<std::string> groups(const DeckRequest& request) {
  std::set<std::string> out;
  for (const ModelVariant& one : model_variants(prepare(request))) out.insert(one.group);
  return out;
}

}  // namespace

TEST_CASE("model variants: only what the deck uses", "[unit][accuracy]") {
  const DeckRequest ball = example("ball");
  const auto dry = groups(ball);
  CHECK(dry.contains("damping"));
  CHECK(dry.contains("traction law"));
  CHECK(dry.contains("cage friction"));
  CHECK(dry.contains("ellipse nodes"));
  CHECK(dry.contains("mode"));
  CHECK_FALSE(dry.contains("thermal model"));
  CHECK_FALSE(dry.contains("roller slices"));
  DeckRequest elastic = ball;
  elastic.options = {{"contactDamping", "0"}};
  CHECK_FALSE(groups(elastic).contains("damping"));
  CHECK(groups(example("cylindrical")).contains("roller slices"));
}

TEST_CASE("model errors: a factor on the damping, a stamp that a changed deck breaks",
          "[accuracy]") {
  const DeckRequest request = example("ball");
  const ModelStudy study = run_model_study(request, 0.05, 60.0);
  REQUIRE(study.complete);
  CHECK(study.turns == Approx(0.05));
  double scatter = -1.0, friction = 0.0;
  for (const ModelRow& row : study.rows) {
    CAPTURE(row.variant.name, row.failure);
    CHECK(row.failure.empty());
    if (row.variant.group == "scatter") scatter = row.change.heat;
    if (row.variant.group == "traction law") friction = std::max(friction, row.change.heat);
    if (row.variant.group == "damping") CHECK(row.change.largest() > 0.0);
  }
  CHECK(scatter >= 0.0);
  CHECK(friction > scatter);
  const ModelStudy read = read_model_study(model_json(study), "MODELS.json");
  CHECK(model_json(read) == model_json(study));
  CHECK(model_table(read) == model_table(study));
  CHECK_THROWS_AS(read_model_study("{}", "MODELS.json"), InputError);

  const testing::TemporaryFolder folder;
  const auto file = folder / "DATA.txt";
  std::ofstream(file) << *request.text;
  std::ofstream(folder / kModelFile) << model_json(study);
  DeckRequest beside;
  beside.deck = file;
  CHECK(find_model_study(load_deck(beside)).has_value());
  // Numerical settings and output are no part of the model, loads and options are.
  beside.sets = {{"tol", "1e-7"}, {"kPltFreq", "10"}};
  CHECK(find_model_study(load_deck(beside)).has_value());
  beside.sets = {{"appLoadX", "777"}};
  CHECK_FALSE(find_model_study(load_deck(beside)).has_value());
  beside.sets.clear();
  beside.options = {{"contactDamping", "2x"}};
  CHECK_FALSE(find_model_study(load_deck(beside)).has_value());
  beside.options.clear();
  RunRequest run;
  static_cast<DeckRequest&>(run) = beside;
  run.until = "0.01rev";
  run.out = folder / "out";
  REQUIRE(runs::run(run).status == RunStatus::Done);
  const std::string print = testing::read_bytes(folder / "out/PRINT.txt");
  CHECK(print.find("MODEL ERRORS") != std::string::npos);
  CHECK(print.find("contactDamping = 2x") != std::string::npos);
  std::ofstream(folder / kModelFile) << "not a study";
  CHECK_FALSE(find_model_study(load_deck(beside)).has_value());
}
