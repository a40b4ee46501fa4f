// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Relievo's settings of a view of ParaView's window, read and changed as its Properties panel does:
// each change is one step of undo and one line of a Python trace.
#ifndef pqRelievoViewSettings_h
#define pqRelievoViewSettings_h

#include <QString>
#include <QVector>

class pqView;
class vtkSMProxy;

namespace pqRelievoViewSettings
{
/** The sub-proxy that holds them; nullptr for no view and for views without Relievo. */
vtkSMProxy* Find(pqView* view);

bool AreShadowsOn(pqView* view);
bool IsSunOn(pqView* view);

/** Name of the layer shown as the picture; empty for none. */
QString GetShownLayer(pqView* view);

/** Names that the view offers as layers to show, the word for none first. */
QVector<QString> GetLayerNames(pqView* view);

///@{
/**
 * Changes a view that has Relievo's settings, and renders it. The sun brings shadows with it, and
 * takes those away that it brought. An empty name shows no layer.
 */
void SetShadows(pqView* view, bool on);
void SetSun(pqView* view, bool on);
void SetShownLayer(pqView* view, const QString& name);
///@}
}

#endif
