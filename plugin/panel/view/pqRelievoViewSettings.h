// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Relievo's settings of a view in ParaView's window, read and changed like in its Properties panel:
// each change is one undo step and one line of a Python trace.
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
/** The sub-proxy with the settings; nullptr without a view and for views without Relievo. */
vtkSMProxy* Find(pqView* view);

/** The sub-proxy's object on this process, or nullptr. */
vtkPVRelievoView* FindHere(pqView* view);

/** Whether this process draws the view's pictures, not a server. */
bool IsDrawnHere(pqView* view);

/** A property of the view ("RelievoSun") and its value: a number, a text, or a list of numbers. */
using Change = std::pair<const char*, QVariant>;

/** The value of a property; invalid if the view does not have it. */
QVariant Get(pqView* view, const char* name);

/** Changes the view and renders it; the label names the undo step. */
void Apply(pqView* view, const QString& label, const QVector<Change>& changes);

/**
 * Changes the view and renders it during a slider's drag, without an undo step or a line of a
 * trace. At the release, restore the first values with Try(), and call Apply() for a single step.
 */
void Try(pqView* view, const QVector<Change>& changes);

bool AreShadowsOn(pqView* view);
bool IsSunOn(pqView* view);

/** Name of the layer shown as the picture; empty for none. */
QString GetShownLayer(pqView* view);

/** Names of the layers that the view can show; the first one means none. */
QVector<QString> GetLayerNames(pqView* view);

///@{
/**
 * Changes a view that has Relievo's settings, and renders it. The sun switches shadows on, and off
 * again if it switched them on. An empty name shows no layer.
 */
void SetShadows(pqView* view, bool on);
void SetSun(pqView* view, bool on);
void SetShownLayer(pqView* view, const QString& name);
///@}
}

#endif
