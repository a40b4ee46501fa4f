// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileEdit.h"

#include "vtkRelievoImageFile.h"

#include "RecentFiles.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace viewer
{
//------------------------------------------------------------------------------
FileEdit::FileEdit(const QString& title, QWidget* parent)
  : QWidget(parent)
  , Title(title)
  , Line(new QLineEdit(this))
{
  auto* browse = new QPushButton("...", this);
  browse->setObjectName("browse");
  browse->setToolTip("Choose a file");
  browse->setMaximumWidth(40);
  this->Line->setObjectName("path");
  this->Line->setPlaceholderText("None");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Line, 1);
  layout->addWidget(browse);
  this->setFocusProxy(this->Line);
  QObject::connect(this->Line, &QLineEdit::editingFinished, this, [this] {
    const QString typed = this->Line->text();
    if (typed != this->Shown) // skips unchanged text
    {
      this->SetPath(typed.isEmpty() ? typed : QFileInfo(typed).absoluteFilePath());
      Q_EMIT this->edited(this->Shown);
    }
  });
  QObject::connect(browse, &QPushButton::clicked, this, [this] { this->Ask(); });
}

//------------------------------------------------------------------------------
void FileEdit::SetPath(const QString& path)
{
  this->Shown = path;
  if (this->Line->text() != path)
  {
    this->Line->setText(path);
  }
  this->Line->setToolTip(path);
}

//------------------------------------------------------------------------------
void FileEdit::Ask()
{
  const QString folder =
    this->Shown.isEmpty() ? GetLastFolder() : QFileInfo(this->Shown).absolutePath();
  const QString path = QFileDialog::getOpenFileName(this, this->Title, folder,
    QString::fromStdString("Images (" + vtkRelievoImageFile::ListExtensions("*.") + ")"));
  if (!path.isEmpty())
  {
    this->SetPath(path);
    Q_EMIT this->edited(path);
  }
}
}
