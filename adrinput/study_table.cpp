#include "adrinput/study_table.hpp"

#include "adrinput/qt_text.hpp"
#include "deck/schema.hpp"
#include "desktop/spoken_name.hpp"
#include "desktop/theme.hpp"
#include "results/channels.hpp"
#include "results/key_results.hpp"
#include "studies/cage_whirl.hpp"

#include <QComboBox>
#include <QCompleter>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyledItemDelegate>

#include <algorithm>

namespace adore::adrinput {
namespace {

constexpr int kMostRows = 8;  // shown at once

QStringList proposals(Proposals which) {
  QStringList out;
  if (which == Proposals::Variables)
    for (const deck::RecordSpec& record : deck::schema())
      for (const deck::VariableSpec& variable : record.variables) out << text_of(variable.name);
  if (which == Proposals::Results) {
    for (const results::KeyResultSpec& spec : results::key_result_specs()) out << text_of(spec.id);
    for (const results::Channel& channel : results::channels()) out << text_of(channel.id);
    for (const std::string_view figure : studies::kWhirlFigures) out << text_of(figure);
  }
  out.removeDuplicates();
  return out;
}

/// Fields that propose names, lists of choices; the document hears every key.
class StudyCellEditor : public QStyledItemDelegate {
 public:
  StudyCellEditor(const StudyTableSpec& spec, QObject* parent)
      : QStyledItemDelegate(parent), spec_(spec) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                        const QModelIndex& index) const override {
    const StudyColumn& column = spec_.columns.at(static_cast<std::size_t>(index.column()));
    auto* self = const_cast<StudyCellEditor*>(this);
    if (!column.choices.empty()) {
      auto* box = new QComboBox(parent);
      desktop::set_accessible_name(*box, text_of(column.label));
      for (const std::string_view choice : column.choices) box->addItem(text_of(choice));
      connect(box, &QComboBox::activated, self, [self, box] {
        emit self->commitData(box);
        emit self->closeEditor(box);
      });
      return box;
    }
    auto* line = new QLineEdit(parent);
    line->setFrame(false);
    if (column.proposals != Proposals::None) {
      auto* completer = new QCompleter(proposals(column.proposals), line);
      completer->setCaseSensitivity(Qt::CaseInsensitive);
      completer->setFilterMode(Qt::MatchContains);
      line->setCompleter(completer);
    }
    connect(line, &QLineEdit::textChanged, self, [self, line] {
      if (line->isModified()) emit self->commitData(line);
    });
    return line;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    const QString text = index.data(Qt::EditRole).toString();
    if (auto* box = qobject_cast<QComboBox*>(editor)) {
      box->setCurrentIndex(std::max(0, box->findText(text)));
    } else if (auto* line = qobject_cast<QLineEdit*>(editor); line->text() != text) {
      // The text being typed is not overwritten by its own update; undo is not such an update.
      if (!committing_) line->setText(text);
    }
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override {
    committing_ = true;
    if (const auto* box = qobject_cast<QComboBox*>(editor))
      model->setData(index, box->currentText());
    else
      model->setData(index, qobject_cast<QLineEdit*>(editor)->text());
    committing_ = false;
  }

 private:
  mutable bool committing_ = false;
  const StudyTableSpec& spec_;
};

}  // namespace

StudyTable::StudyTable(StudyDocument& document, const StudyTableSpec& spec, QWidget* parent)
    : QTableWidget(parent), document_(document), spec_(spec) {
  setObjectName("table-" + text_of(spec.key));
  setAccessibleName(text_of(spec.title));
  setItemDelegate(new StudyCellEditor(spec_, this));
  setColumnCount(static_cast<int>(spec.columns.size()));
  for (int column = 0; column < columnCount(); ++column) {
    const StudyColumn& of = spec.columns[static_cast<std::size_t>(column)];
    auto* heading = new QTableWidgetItem(text_of(of.label));
    heading->setToolTip(text_of(of.help));
    setHorizontalHeaderItem(column, heading);
  }
  // Names are whole in a narrow window too: then the table scrolls.
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setStretchLastSection(true);
  horizontalHeader()->setMinimumSectionSize(70);
  verticalHeader()->setDefaultSectionSize(28);
  setTabKeyNavigation(false);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::AllEditTriggers);
  setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (!syncing_)
      document_.set_cell(spec_.key, static_cast<std::size_t>(item->row()),
                         static_cast<std::size_t>(item->column()), item->text().toStdString());
  });
  sync();
}

void StudyTable::sync() {
  syncing_ = true;
  const std::size_t rows = document_.rows(spec_.key);
  setRowCount(static_cast<int>(rows) + 1);
  const auto kind = document_.kind();
  std::vector<bool> used(spec_.columns.size(), false);
  for (std::size_t row = 0; row <= rows; ++row) {
    const std::vector<std::string> cells = row < rows
                                               ? document_.cells(spec_.key, row)
                                               : std::vector<std::string>(spec_.columns.size());
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const bool choice = !spec_.columns[column].choices.empty();
      if (!cells[column].empty() && !choice) used[column] = true;
      if (choice && spec_.columns[column].label == "Law" && !cells[column].empty())
        used[column] = true;
      QTableWidgetItem* old = item(static_cast<int>(row), static_cast<int>(column));
      if (old == nullptr) {
        old = new QTableWidgetItem;
        setItem(static_cast<int>(row), static_cast<int>(column), old);
      }
      if (const QString text = text_of(cells[column]); old->text() != text) old->setText(text);
      old->setToolTip(text_of(spec_.columns[column].help));
    }
    setVerticalHeaderItem(static_cast<int>(row),
                          new QTableWidgetItem(row < rows ? QString::number(row + 1) : "+"));
  }
  for (std::size_t column = 0; column < used.size(); ++column)
    setColumnHidden(static_cast<int>(column),
                    kind && (spec_.columns[column].kinds & only(*kind)) == 0 && !used[column]);
  fitHeight();
  syncing_ = false;
}

void StudyTable::fitHeight() {
  const int shown = std::min(rowCount(), kMostRows);
  const int height = horizontalHeader()->sizeHint().height() +
                     shown * verticalHeader()->defaultSectionSize() + 2 * frameWidth() +
                     horizontalScrollBar()->sizeHint().height();
  setFixedHeight(height);
}

void StudyTable::markRow(int row, const QString& why) {
  syncing_ = true;
  for (int k = 0; k < rowCount(); ++k)
    if (QTableWidgetItem* header = verticalHeaderItem(k)) {
      header->setForeground(k == row ? desktop::current_theme().red
                                     : desktop::current_theme().text);
      header->setToolTip(k == row ? why : QString());
      QFont font = header->font();
      font.setBold(k == row);
      header->setFont(font);
    }
  syncing_ = false;
}

void StudyTable::removeCurrentRow() {
  if (currentRow() >= 0) document_.remove_row(spec_.key, static_cast<std::size_t>(currentRow()));
}

void StudyTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete && event->modifiers() == Qt::ControlModifier)
    return removeCurrentRow();
  QTableWidget::keyPressEvent(event);
}

}  // namespace adore::adrinput
