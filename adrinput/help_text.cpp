#include "adrinput/help_text.hpp"

#include "adrinput/options_page.hpp"
#include "adrinput/typed.hpp"
#include "deck/condition.hpp"
#include "deck/lookup.hpp"

#include <QStringList>

namespace adore::adrinput {
namespace {

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}
QString escaped(std::string_view text) { return text_of(text).toHtmlEscaped(); }

QString option_rows(std::span<const deck::OptionSpec> options) {
  QString rows;
  for (const deck::OptionSpec& option : options)
    rows += QString("<tr><td align='right'><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(escaped(option.code), escaped(option.meaning));
  return rows;
}

QString variable_help(const deck::Deck& deck, const deck::VariableSpec& variable) {
  QStringList facts;
  facts << (variable.type == deck::VarType::Integer ? "whole number"
            : variable.type == deck::VarType::Real  ? "number"
                                                    : "text");
  if (variable.length != "1") facts << QString("array of length %1").arg(escaped(variable.length));
  const std::string unit = unit_of(deck, variable), limits = limits_of(deck, variable);
  if (!unit.empty()) facts << escaped(unit);
  if (!limits.empty()) facts << escaped(limits);
  QString out = QString("<p><b>%1</b> &nbsp;<i>%2</i><br>%3</p>")
                    .arg(escaped(variable.name), facts.join(", "), escaped(variable.help));
  QString rows = option_rows(variable.options);
  if (!variable.option_table.empty())
    rows += option_rows(deck::option_table(variable.option_table));
  if (!rows.isEmpty()) out += "<table cellpadding='1'>" + rows + "</table>";
  return out;
}

QString options_help(const deck::Deck& deck, const deck::RecordSpec& record) {
  QString out =
      "<h2>Run options</h2><p>What no record of the deck can say. Options that differ from their "
      "default are kept in the file ADORE.json beside the deck, which every run of a deck in that "
      "folder reads; it is written when the deck is saved. An empty field means the "
      "default.</p>";
  for (const deck::VariableSpec& variable : record.variables) out += variable_help(deck, variable);
  return out;
}

}  // namespace

QString page_heading(const deck::RecordSpec& record) {
  return record.id == kOptionsPage
             ? QString("ADORE.json — %1").arg(text_of(record.title))
             : QString("Record %1 — %2").arg(record_number(record), text_of(record.title));
}

QString record_number(const deck::RecordSpec& record) {
  const QString id = text_of(record.id);
  return record.repeat.empty() || record.id == "12" ? id : id.section('.', 0, -2);
}

QString reason_for(const deck::Deck& deck, std::string_view condition) {
  QStringList parts;
  for (const std::string_view name : deck::names_in(condition)) {
    const std::span<const deck::VariableRef> refs = deck::find_variable(name);
    if (refs.empty()) continue;
    const deck::VariableRef here = deck::find_present(deck, name);
    const deck::VariableSpec& variable = here.record != nullptr ? here.spec() : refs[0].spec();
    if (variable.length != "1" || here.record == nullptr) continue;
    const QString code = QString::number(deck.integer(name));
    const QString meaning = text_of(meaning_of(variable, code.toStdString()));
    parts << QString("%1 = %2%3")
                 .arg(text_of(name), code, meaning.isEmpty() ? QString() : " (" + meaning + ")");
  }
  return parts.join(", ");
}

QString record_help(const deck::Deck& deck, const deck::RecordSpec& record) {
  if (record.id == kOptionsPage) return options_help(deck, record);
  QString out = QString("<h2>Record %1: %2</h2>").arg(record_number(record), escaped(record.title));
  if (record.id == "12") {
    out +=
        "<p>Lines after the last record belong to user routines, each of which reads its own. "
        "They are kept as they are, one line each, and written back unchanged.</p>";
    return out;
  }
  if (record.condition == "true") {
    out += "<p>Every deck has this record.</p>";
  } else {
    out += QString("<p>A deck has this record when <code>%1</code>.</p>")
               .arg(escaped(record.condition));
  }
  if (!record.repeat.empty())
    out += QString("<p>It occurs as often as <b>%1</b> says.</p>").arg(escaped(record.repeat));
  for (const deck::VariableSpec& variable : record.variables) out += variable_help(deck, variable);
  return out;
}

QString format_help() {
  return "<h2>How a deck is written</h2>"
         "<p>A deck is a plain text file, usually DATA.txt, with one record after the other. Each "
         "record starts with its label in single quotes, and its values follow with commas between "
         "them. Names that begin with i to n are whole numbers without a decimal point, with a few "
         "exceptions that the help names; all others are numbers with one.</p>"
         "<p>Which records a deck has depends on its options. AdrInput shows just those, in their "
         "order, and keeps what you typed on a page that goes away until it comes back.</p>"
         "<p>All values are in SI units or all in English units, as kUnit on record 3.2 says. "
         "Changing kUnit changes what the numbers mean; AdrInput then offers to convert them.</p>"
         "<p>A deck is written only when it has no error, with a decimal point whatever your "
         "language uses. You may type a decimal comma; 10,000 may be ten or ten thousand and is "
         "asked back. A deck with errors can be parked as a draft "
         "(File), which no run takes and which AdrInput opens again as it was.</p>"
         "<p>Numbers may be typed with a unit and with arithmetic: 12.7 mm, 1/2 in, 80 °C, 206 "
         "GPa, "
         "3*0.005 (in a vector, where a deck means three values by it, it is asked back), "
         "1 in + 2 mm. Times and steps of a run take seconds and turns: 0.01 s, 3 rev. "
         "The deck gets the number in its own unit when you leave the field. "
         "The button behind a field chooses the unit that values of its kind are shown in; a "
         "number "
         "without a unit is in that one.</p>"
         "<p>Remarks behind the values of a deck that you open stay in the deck that is saved. "
         "Where that is impossible, and when the file had errors, the old file stays beside it "
         "with .bak behind its name (.bak2 where there is one already).</p>";
}

QString keyboard_help() {
  const std::pair<const char*, const char*> keys[] = {
      {"Tab, Shift+Tab", "next and previous field"},
      {"Alt+Down", "list of the choices of a field, or of the units that it can be shown in"},
      {"Page Down or Alt+Right", "Next Rec"},
      {"Page Up or Alt+Left", "Go Back"},
      {"Ctrl+F", "find a variable; Down and Enter choose one, Esc returns to the records"},
      {"F8, Shift+F8", "next and previous problem"},
      {"Ctrl+Z, Ctrl+Shift+Z or Ctrl+Y", "undo, redo"},
      {"Ctrl+O, Ctrl+S, Ctrl+Shift+S", "open, save, save under another name"},
      {"F1", "help on this record"},
      {"F5", "plan of this deck"},
      {"F6", "quasi-static solution of this deck"},
      {"F7, Shift+F7", "save and run this deck; the same into a new folder"},
      {"F9", "what accuracy costs for this deck"},
      {"Ctrl+N", "a new deck from the catalogue of bearings"},
      {"Ctrl+U", "values also in the other system of units"},
      {"Ctrl+K", "compare with another deck"},
      {"Ctrl+G, Ctrl+T", "show or hide the drawing, the charts of the solution"},
      {"Ctrl+D", "dark or light"},
      {"Ctrl+Q", "quit"},
      {"wheel over the form", "scrolls; it changes no field"},
      {"wheel over the drawing", "zooms about the pointer"},
      {"drag in the drawing", "moves it; a double click shows all again"},
      {"click on a measure", "goes to its field"},
      {"wheel over a chart", "zooms along the abscissa; with Ctrl along a panel's own axis"},
      {"drag in a chart", "moves; with Shift zooms into a box; a double click shows everything"},
      {"dropping a file", "opens the deck"}};
  QString out = "<h2>Keys and mouse</h2><table cellpadding='3'>";
  for (const auto& [key, what] : keys)
    out += QString("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>").arg(key, what);
  return out + "</table>";
}

}  // namespace adore::adrinput
