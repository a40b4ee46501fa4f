// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Relievo's settings of a view of ParaView's window, read and changed as its Properties panel does:
// each change is one step of undo and one line of a Python trace.
#ifndef pqRelievoViewSettings_h
#define pqRelievoViewSettings_h

#include <QString>
#include <QVariant>
#include <QVector>

#include <utility>

class pqView;
class vtkPVRelievoView;
class vtkSMProxy;

namespace pqRelievoViewSettings
{
/** The sub-proxy that holds them; nullptr for no view and for views without Relievo. */
vtkSMProxy* Find(pqView* view);

/** Its object on this process, or nullptr. */
vtkPVRelievoView* FindHere(pqView* view);

/** Whether the view's pictures are drawn by this process, not by a server. */
bool IsDrawnHere(pqView* view);

/** A property of the view ("RelievoSun") and its value: a number, a text, or a list of numbers. */
using Change = std::pair<const char*, QVariant>;

/** The value of one of the view's properties; invalid if it has none. */
QVariant Get(pqView* view, const char* name);

/** Changes the view and renders it; the label is that of the step of undo. */
void Apply(pqView* view, const QString& label, const QVector<Change>& changes);

/**
 * Changes the view and renders it while a slider is dragged: without a step of undo or a line of a
 * trace. When it is let go, the first values come back with Try(), and Apply() makes one step of
 * all.
 */
void Try(pqView* view, const QVector<Change>& changes);

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
