#include "adrinput/cell_table.hpp"
#include "adrinput/page_parts.hpp"
#include "adrinput/record_page.hpp"
#include "desktop/theme.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

/// Pages that are one table, or lines of text.
namespace adore::adrinput {

void RecordPage::addInstances(QVBoxLayout* layout) {
  const desktop::Theme& theme = desktop::current_theme();
  auto* table = new CellTable(document_, record_, this);
  table->setObjectName("instances");
  table->setAccessibleName(text_of(spec_.title));
  table->installEventFilter(this);
  connect(table, &QTableWidget::currentCellChanged, this,
          [this, table] { announceFocusedCell(table); });
  layout->addWidget(table);
  auto* grid = make_grid();
  for (std::size_t v = 0; v < spec_.variables.size(); ++v) {
    const deck::VariableSpec& variable = spec_.variables[v];
    Row row;
    row.variable = v;
    row.table = table;
    row.name = new QLabel(text_of(variable.name), this);
    row.name->setFont(desktop::ui_font(13, true));
    row.unit = new QLabel(this);
    row.unit->setTextFormat(Qt::PlainText);
    row.unit->setWordWrap(true);
    row.problem = make_text_label({}, theme.red, this);
    row.problem->setObjectName("problem-" + text_of(variable.name));
    row.help = make_text_label(text_of(variable.help), theme.muted, this);
    row.grid = grid;
    row.at = grid->rowCount();
    place(row);
    rows_.push_back(row);
  }
  layout->addLayout(grid);
}

/// The four records of listed deviations as one table of 40 elements.
void RecordPage::addListedDiameters(QVBoxLayout* layout) {
  const desktop::Theme& theme = desktop::current_theme();
  auto* table = CellTable::createForListedDiameters(document_, this);
  table->setObjectName("deviations");
  table->setAccessibleName(tr("Diameter deviations of rolling elements 1 to 40"));
  table->installEventFilter(this);
  connect(table, &QTableWidget::currentCellChanged, this,
          [this, table] { announceFocusedCell(table); });
  layout->addWidget(make_text_label(
      tr("Diameter of each rolling element minus the nominal diameter (40 values in four "
         "records). Rows or columns pasted from a spreadsheet fill the table, starting "
         "at the current cell. Cells beyond the number of elements are gray."),
      theme.muted, this));
  auto* label = new QLabel(tr("Label of this record"), this);
  auto* line = makeLineEdit(cellOf(0));
  line->setObjectName("recID");
  line->setAccessibleName(tr("Label of this record"));
  label->setBuddy(line);
  layout->addWidget(label);
  layout->addWidget(line);
  layout->addWidget(table);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  for (std::size_t v = 0; v < spec_.variables.size(); ++v) {
    Row row;
    row.variable = v;
    if (v == 0)
      row.line = line;
    else
      row.table = table;
    row.unit = new QLabel(this);
    row.unit->setTextFormat(Qt::PlainText);
    row.problem = make_text_label({}, theme.red, this);
    row.problem->setObjectName("problem-" + text_of(spec_.variables[v].name));
    if (v == 1)
      grid->addWidget(row.unit, 0, 0);
    else
      row.unit->hide();
    grid->addWidget(row.problem, static_cast<int>(v) + 1, 0);
    rows_.push_back(row);
  }
  layout->addLayout(grid);
}

void RecordPage::addUserLines(QVBoxLayout* layout) {
  user_lines_edit_ = new QPlainTextEdit(this);
  user_lines_edit_->setObjectName("lines");
  user_lines_edit_->setAccessibleName("Lines of user routines");
  user_lines_edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
  user_lines_edit_->setTabChangesFocus(true);
  user_lines_edit_->setUndoRedoEnabled(false);
  user_lines_edit_->setMinimumHeight(240);
  connect(user_lines_edit_, &QPlainTextEdit::textChanged, this, [this] {
    std::vector<std::string> kept;
    for (const QString& line : user_lines_edit_->toPlainText().split('\n'))
      if (!line.trimmed().isEmpty()) kept.push_back(line.toStdString());
    document_.set_user_lines(std::move(kept));
  });
  finish(user_lines_edit_);
  layout->addWidget(make_text_label(
      "User routines read these lines, which are at the end of the deck. Blank lines are removed. "
      "Leave the field empty if the deck has no user routines.",
      desktop::current_theme().muted, this));
  layout->addWidget(user_lines_edit_);
}

}  // namespace adore::adrinput
