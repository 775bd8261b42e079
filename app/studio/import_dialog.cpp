#include "import_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "models/diagnostic_text.h"
#include "models/import_summary.h"
#include "models/remedy_text.h"

namespace toolpace::studio {
namespace {

constexpr QSize kDialogSize = {520, 560};

QTableWidget* table_of(const std::vector<ui::ImportRow>& rows, QWidget* parent) {
  auto* table = new QTableWidget(static_cast<int>(rows.size()), 2, parent);
  table->setObjectName("importTable");
  table->setHorizontalHeaderLabels({ImportDialog::tr("Setting"), ImportDialog::tr("Taken")});
  table->setAccessibleName(ImportDialog::tr("What is taken"));
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  for (int row = 0; row < table->rowCount(); ++row) {
    const ui::ImportRow& shown = rows[static_cast<std::size_t>(row)];
    table->setItem(row, 0, new QTableWidgetItem(shown.name));
    auto* value = new QTableWidgetItem(shown.value.isEmpty() ? ImportDialog::tr("not there: no limit") : shown.value);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (shown.value.isEmpty()) value->setForeground(parent->palette().color(QPalette::Disabled, QPalette::Text));
    table->setItem(row, 1, value);
  }
  return table;
}

}  // namespace

ImportDialog::ImportDialog(const QString& name, const Setup& setup, QWidget* parent) : QDialog(parent) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import machine"));
  auto* column = new QVBoxLayout(this);
  auto* head = new QLabel(tr("What Toolpace takes from %1:").arg(name), this);
  head->setWordWrap(true);
  column->addWidget(head);
  column->addWidget(table_of(ui::import_summary(setup), this), 1);
  QStringList open;
  for (const Diagnostic& warning : setup.warnings) {
    open << ui::message_text(warning.code, warning.message);
    if (!warning.remedy.empty()) open.last() += " – " + ui::remedy_text(warning.remedy);
  }
  auto* warnings = new QLabel(open.isEmpty() ? tr("Nothing in it was doubtful.") : open.join('\n'), this);
  warnings->setObjectName("importWarnings");
  warnings->setWordWrap(true);
  column->addWidget(warnings);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Use this machine"));
  buttons->button(QDialogButtonBox::Ok)->setObjectName("importUse");
  buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  buttons->button(QDialogButtonBox::Cancel)->setObjectName("importCancel");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  resize(kDialogSize);
}

}  // namespace toolpace::studio
