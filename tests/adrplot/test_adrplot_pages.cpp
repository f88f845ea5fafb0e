#include <catch2/catch.hpp>
#include <filesystem>

#include "adrplot/render.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

using namespace adore;
TEST_CASE("look", "[gui]") {
  test::use_qt();
  adrplot::RenderOptions o;
  o.folder = "/tmp/apps-look";
  std::filesystem::create_directories(o.folder);
  for (auto k : {results::SolKind::Element, results::SolKind::Cage, results::SolKind::Race, results::SolKind::Power}) {
    auto f = test::synthetic_sol(k);
    adrplot::render_file(f, f.path.string(), o);
  }
  o.dark = true;
  auto f = test::synthetic_sol(results::SolKind::Element);
  o.page = 6;
  adrplot::render_file(f, "dark", o);
}
