// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Properties.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QTextEdit>
#include <QVBoxLayout>

namespace viewer
{
//------------------------------------------------------------------------------
void ShowProperties(QWidget* parent, const QString& html)
{
  auto* dialog = parent->findChild<QDialog*>("propertiesDialog");
  if (!dialog)
  {
    dialog = new QDialog(parent);
    dialog->setObjectName("propertiesDialog");
    dialog->setWindowTitle("Properties");
    auto* words = new QTextEdit(dialog);
    words->setObjectName("propertiesText");
    words->setReadOnly(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    auto* copy = buttons->addButton("&Copy all", QDialogButtonBox::ActionRole);
    auto* column = new QVBoxLayout(dialog);
    column->addWidget(words);
    column->addWidget(buttons);
    dialog->resize(520, 480);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::hide);
    QObject::connect(copy, &QPushButton::clicked, words,
      [words] { QApplication::clipboard()->setText(words->toPlainText()); });
  }
  dialog->findChild<QTextEdit*>("propertiesText")->setHtml(html);
  if (!dialog->isVisible())
  {
    dialog->show();
    dialog->raise();
  }
}

//------------------------------------------------------------------------------
bool AreShown(QWidget* parent)
{
  auto* dialog = parent->findChild<QDialog*>("propertiesDialog");
  return dialog && dialog->isVisible();
}
}
