#pragma once

#include "adrinput/deck_window.hpp"
#include "adrinput/record_page.hpp"
#include "support/bytes.hpp"
#include "support/message.hpp"

#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// Actions of AdrInput tests on its window.
namespace adore::adrinput {

using test::take_message;

inline Cell cell(const std::string& name, int instance = 1, std::size_t element = 0) {
  const auto refs = deck::find_variable(name);
  REQUIRE_FALSE(refs.empty());
  return {std::string(refs[0].record->id), instance, refs[0].position, element};
}

inline void press(DeckWindow& window, const QString& button) {
  auto* push = window.findChild<QPushButton*>(button);
  REQUIRE(push != nullptr);
  QTest::mouseClick(push, Qt::LeftButton);
}

inline void replace_text(QLineEdit* line, const QString& text) {
  line->setFocus();
  line->selectAll();
  QTest::keyClick(line, Qt::Key_Backspace);
  QTest::keyClicks(line, text);
  QTest::keyClick(line, Qt::Key_Return);
}

/// The field of a variable, on its page.
inline QLineEdit* line_of(DeckWindow& window, const char* name) {
  window.showRecord(cell(name).record);
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell(name).variable));
  REQUIRE(line != nullptr);
  return line;
}

/// Note next to the field: the value in other units and its meaning.
inline QString beside(DeckWindow& window, const char* name) {
  auto* label = window.page()->findChild<QLabel*>(QString("other-") + name);
  REQUIRE(label != nullptr);
  return label->text();
}

using test::bytes_of;

}  // namespace adore::adrinput
