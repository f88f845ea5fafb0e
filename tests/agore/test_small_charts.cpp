#include "agore/motion_picture.hpp"
#include "agore/short_run.hpp"
#include "agore/views.hpp"
#include "support/chart_texts.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsSimpleTextItem>
#include <catch2/catch.hpp>

/// The chart next to AGORE's pictures, in the smallest windows.
using namespace adore;
using namespace adore::agore;

TEST_CASE("agore: numbers of the small chart → readable with one to four views", "[gui]") {
  test::use_qt();
  const Animation animation = prepare(test::synthetic_sol8(test::short_run(61)));
  // The pictures of windows of 640x480, 700x450 and 800x600, and saved ones.
  for (const QSizeF size :
       {QSizeF(484, 360), QSizeF(548, 390), QSizeF(660, 530), QSizeF(700, 450), QSizeF(1280, 800)})
    for (const std::size_t views : {1U, 2U, 4U})
      for (const View view : {View::Bearing, View::Cage, View::Pocket, View::Element}) {
        INFO(size.width() << " x " << size.height() << ", " << views << " views, view "
                          << static_cast<int>(view));
        ViewOptions options;
        options.view = view;
        desktop::ChartScene scene(desktop::ChartStyle::Compact);
        scene.setPageSize(MotionPicture::dataArea({QPointF(0, 0), size}, views).size());
        scene.setPage(data_page(animation, options));
        // One panel has room for three numbers, each of two for one or two.
        const qreal least = scene.page().panels.size() == 1 ? 36.0 : 15.0;
        CHECK(test::unreadable(scene, least).join("; ").toStdString() == "");
      }
}

TEST_CASE("agore: shortened titles keep their distinguishing part", "[gui]") {
  test::use_qt();
  for (const qreal width : {200.0, 230.0, 300.0}) {
    desktop::ChartScene scene(desktop::ChartStyle::Compact);
    scene.setPageSize({width, 200.0});
    desktop::ChartPage page;
    page.title = "Cage speed / inner race, 10000 rpm, segment 5 of 12";
    page.x = {0.0, 1.0};
    page.panels = {{"Whirl", "", {{"", {0.0, 1.0}, {}}}}};
    scene.setPage(page);
    int titles = 0;
    for (const QGraphicsItem* item : scene.items())
      if (const auto* text = dynamic_cast<const QGraphicsSimpleTextItem*>(item))
        if (text->text().startsWith("Cage")) {
          ++titles;
          CHECK(text->text().endsWith(", segment 5 of 12"));
          CHECK(text->sceneBoundingRect().right() <= width);
        }
    CHECK(titles == 1);
  }
}
