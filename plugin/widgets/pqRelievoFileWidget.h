// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoFileWidget
 * @brief A field for a file's name, for properties that are read at once (panel_widget
 * "relievo_file").
 *
 * ParaView's own field sets the property at every typed letter. This one sets it when the name is
 * complete: with Enter, when the field loses focus, or after choosing a file in the dialog.
 */
#ifndef pqRelievoFileWidget_h
#define pqRelievoFileWidget_h

#include "pqPropertyWidget.h"

class pqFileChooserWidget;

class pqRelievoFileWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QString file READ GetFile WRITE SetFile NOTIFY fileChanged)
  typedef pqPropertyWidget Superclass;

public:
  pqRelievoFileWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqRelievoFileWidget() override;

  /** Filters of dialogs, from a property's hints: "Images (*.png *.jpg)"; "": everything. */
  static QString GetFilter(vtkSMProperty* property);

  ///@{
  /** The last completed file name. */
  QString GetFile() const { return this->File; }
  void SetFile(const QString& file);
  ///@}

Q_SIGNALS:
  void fileChanged();

private:
  Q_DISABLE_COPY(pqRelievoFileWidget)

  void Finish();

  pqFileChooserWidget* Chooser;
  QString File;
  bool Typing = false;
};

#endif
