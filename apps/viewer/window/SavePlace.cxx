// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SavePlace.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace viewer
{
//------------------------------------------------------------------------------
QString AskPlace(QWidget* parent, const QString& title, const QString& suffix)
{
  QFileDialog dialog(parent, title, QString(), "*" + suffix);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix.mid(1));
  while (dialog.exec() == QDialog::Accepted)
  {
    QString path = dialog.selectedFiles().value(0);
    if (path.endsWith(suffix, Qt::CaseInsensitive))
    {
      return path; // which the dialog has asked about
    }
    path += suffix; // the dialog takes what is behind any other dot for one
    if (!QFileInfo::exists(path) ||
      QMessageBox::question(parent, title,
        QFileInfo(path).fileName() + " exists already. Do you want to replace it?",
        QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes)
    {
      return path;
    }
  }
  return QString();
}
}
