#include "adrinput/help_text.hpp"

#include "adrinput/options_page.hpp"
#include "adrinput/qt_text.hpp"
#include "adrinput/typed.hpp"
#include "deck/condition.hpp"
#include "deck/lookup.hpp"

#include <QStringList>

namespace adore::adrinput {
namespace {

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
  facts << (variable.type == deck::VarType::Integer ? "integer"
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
      "<h2>Run options</h2><p>Settings that are not part of the deck. Values other than the "
      "defaults are saved with the deck in the file ADORE.json of the same folder. Every run of a "
      "deck in that folder reads this file. An empty field means the default.</p>";
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

QString condition_values_text(const deck::Deck& deck, std::string_view condition) {
  QStringList parts;
  for (const std::string_view name : deck::variable_names_in(condition)) {
    const std::span<const deck::VariableRef> refs = deck::find_variable(name);
    if (refs.empty()) continue;
    const deck::VariableRef here = deck::find_present_variable(deck, name);
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
        "<p>Lines after the last record are input of user routines. They are saved unchanged.</p>";
    return out;
  }
  if (record.condition == "true") {
    out += "<p>Required in every deck.</p>";
  } else {
    out += QString("<p>Required when <code>%1</code>.</p>").arg(escaped(record.condition));
  }
  if (!record.repeat.empty())
    out += QString("<p>Number of these records: <b>%1</b>.</p>").arg(escaped(record.repeat));
  for (const deck::VariableSpec& variable : record.variables) out += variable_help(deck, variable);
  return out;
}

QString format_help() {
  return "<h2>Deck format</h2><p>A deck is a plain text file, usually DATA.txt, that consists of "
         "records. Each record starts with its label in single quotes, followed by its values, "
         "separated by commas. Variables with names from i to n are integers; all others are real "
         "numbers with a decimal point. The help of each record shows the few "
         "exceptions.</p><p>The options of a deck determine which records it needs. AdrInput shows "
         "only these records. It keeps the values of hidden records until you need them "
         "again.</p><p>All values are in SI units or all in English units (kUnit in record 3.2). "
         "When you change kUnit, AdrInput offers to convert the values.</p><p>Only a deck without "
         "errors can be saved. Saved numbers always have a decimal point. You may type a decimal "
         "comma, but 10,000 is rejected because it is ambiguous. A deck with errors can be saved "
         "as a draft (File > Save as draft). A draft cannot be run.</p><p>You may type units and "
         "arithmetic: 12.7 mm, 1/2 in, 80 °C, 206 GPa, 3*0.005, 1 in + 2 mm. (In a field of an "
         "array, 3*0.005 is rejected because it means three values in a deck.) Times and steps of "
         "a run may be in seconds or revolutions: 0.01 s, 3 rev. The value is converted to the "
         "unit of the deck when you leave the field. The button after a field selects the unit for "
         "all values of the same kind. Numbers without a unit are in that unit.</p><p>Comments "
         "after the values are kept when the deck is saved. If that is not possible, or if the "
         "file had errors, the old file is kept with the suffix .bak (or .bak2).</p>";
}

QString keyboard_help() {
  const std::pair<const char*, const char*> keys[] = {
      {"Tab, Shift+Tab", "next field, previous field"},
      {"Alt+Down", "open the choices or units of a field"},
      {"Page Down or Alt+Right", "Next Rec"},
      {"Page Up or Alt+Left", "Go Back"},
      {"Ctrl+F", "find a variable (Down and Enter to select, Esc to cancel)"},
      {"F8, Shift+F8", "next problem, previous problem"},
      {"Ctrl+Z, Ctrl+Shift+Z or Ctrl+Y", "undo, redo"},
      {"Ctrl+O, Ctrl+S, Ctrl+Shift+S", "open, save, save under another name"},
      {"F1", "help on this record"},
      {"F5", "plan of this deck"},
      {"F6", "quasi-static solution of this deck"},
      {"F7, Shift+F7", "save and run this deck; with Shift: in a new folder"},
      {"F9", "accuracy study of this deck"},
      {"Ctrl+B", "design page: inputs and results of the bearing"},
      {"Ctrl+N", "new deck from the bearing catalog"},
      {"Ctrl+U", "show both unit systems"},
      {"Ctrl+K", "compare with another deck"},
      {"Ctrl+G, Ctrl+T", "show or hide the drawing (G) or the charts of the solution (T)"},
      {"Ctrl+D", "dark or light theme"},
      {"Ctrl+Q", "quit"},
      {"wheel over the form", "scroll the form (values do not change)"},
      {"wheel over the drawing", "zoom at the pointer"},
      {"drag in the drawing", "move the drawing; double click: show all"},
      {"click a dimension", "go to its field"},
      {"wheel over a chart", "zoom the horizontal axis; with Ctrl: the vertical axis of a panel"},
      {"drag in a chart", "move the curves; with Shift: zoom to a box; double click: show all"},
      {"drop a file", "open the deck"}};
  QString out = "<h2>Keys and mouse</h2><table cellpadding='3'>";
  for (const auto& [key, what] : keys)
    out += QString("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>").arg(key, what);
  return out + "</table>";
}

}  // namespace adore::adrinput
