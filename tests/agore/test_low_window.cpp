#include "agore/agore_window.hpp"
#include "agore/motion_picture.hpp"
#include "agore/picture_words.hpp"
#include "agore/short_run.hpp"
#include "support/low_window.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QStatusBar>
#include <QTest>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::agore;

TEST_CASE("agore_window: views, marks and messages do not enlarge a low window", "[gui]") {
  test::use_qt();
  for (const QSize size : test::kLowWindows) {
    AgoreWindow window;
    window.resize(size);
    window.show();
    CHECK(test::grown(window, size).toStdString() == "");
    window.setAnimation(prepare(test::synthetic_sol8(test::short_run(61))));
    for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_5, Qt::Key_6, Qt::Key_C, Qt::Key_L,
                              Qt::Key_T, Qt::Key_V, Qt::Key_Right}) {
      QTest::keyClick(&window, key);
      window.statusBar()->showMessage("Saved as a picture of a long name. ");
      INFO("key " << key);
      CHECK(test::grown(window, size).toStdString() == "");
      window.statusBar()->clearMessage();
    }
  }
}

TEST_CASE("agore: small picture → reason for missing element colors is shown", "[gui][keys]") {
  test::use_qt();
  MotionPicture picture(prepare(test::synthetic_sol8(test::short_run(61))));
  ViewOptions options;
  options.colour = ColourBy::Load;
  for (const std::size_t beside : {0U, 1U, 2U, 3U}) {
    options.beside.assign(beside, {View::Element});
    for (const QSize size : {QSize(700, 450), QSize(1100, 700), QSize(1280, 800)}) {
      const QString words = test::all_words(picture.svg(size, 3, options));
      INFO(beside << " beside, " << size.width() << ": " << words.toStdString());
      CHECK(words.count("no colors:") == 1);
    }
  }
}
