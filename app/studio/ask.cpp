#include "ask.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace toolpace::studio {
namespace {

QPushButton* add_button(QMessageBox& box, const char* name, const QString& text, QMessageBox::ButtonRole role) {
  auto* button = box.addButton(text, role);
  button->setObjectName(name);
  return button;
}

}  // namespace

Answer ask_about_changes(QWidget* parent, const QString& what) {
  QMessageBox box(QMessageBox::NoIcon, QString(), what, QMessageBox::NoButton, parent);
  box.setObjectName("changesBox");
  box.setInformativeText(QCoreApplication::translate("toolpace::studio::Ask", "They are lost unless you save them."));
  auto* save = add_button(box, "saveChangesButton", QCoreApplication::translate("toolpace::studio::Ask", "Save"),
                          QMessageBox::AcceptRole);
  auto* discard =
      add_button(box, "discardChangesButton", QCoreApplication::translate("toolpace::studio::Ask", "Don't save"),
                 QMessageBox::DestructiveRole);
  auto* stay = add_button(box, "cancelButton", QCoreApplication::translate("toolpace::studio::Ask", "Cancel"),
                          QMessageBox::RejectRole);
  box.setDefaultButton(save);
  box.setEscapeButton(stay);
  box.exec();
  if (box.clickedButton() == save) return Answer::save;
  return box.clickedButton() == discard ? Answer::discard : Answer::cancel;
}

bool ask_to_replace(QWidget* parent, const QString& name) {
  QMessageBox box(QMessageBox::NoIcon, QString(),
                  QCoreApplication::translate("toolpace::studio::Ask", "%1 was changed by another program.").arg(name),
                  QMessageBox::NoButton, parent);
  box.setObjectName("replaceBox");
  box.setInformativeText(
      QCoreApplication::translate("toolpace::studio::Ask", "Saving replaces what that program wrote."));
  auto* replace = add_button(box, "replaceButton", QCoreApplication::translate("toolpace::studio::Ask", "Replace"),
                             QMessageBox::DestructiveRole);
  auto* stay = add_button(box, "cancelButton", QCoreApplication::translate("toolpace::studio::Ask", "Cancel"),
                          QMessageBox::RejectRole);
  box.setDefaultButton(stay);
  box.setEscapeButton(stay);
  box.exec();
  return box.clickedButton() == replace;
}

}  // namespace toolpace::studio
