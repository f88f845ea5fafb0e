#include <catch2/catch.hpp>
#include <filesystem>
#include "agore/render.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"
using namespace adore;
TEST_CASE("look", "[gui]") {
  test::use_qt();
  agore::MotionPicture m(agore::prepare(test::synthetic_sol8()));
  std::filesystem::create_directories("/tmp/apps-look");
  for (auto v : {agore::View::Bearing, agore::View::Cage, agore::View::Pocket, agore::View::Element, agore::View::OuterRace, agore::View::InnerRace}) {
    agore::RenderOptions o; o.view.view = v; o.view.element = 3;
    agore::render_frame(m, 700, "/tmp/apps-look/agore-" + std::to_string(int(v)) + ".png", o);
    o.view.dark = true;
    agore::render_frame(m, 1200, "/tmp/apps-look/agore-dark-" + std::to_string(int(v)) + ".png", o);
  }
}
