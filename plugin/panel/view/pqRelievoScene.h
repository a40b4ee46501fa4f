// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a view of ParaView's window shows, as far as Relievo's dock asks for it and adds to it. Each
// change is one step of undo, with its lines of a Python trace.
#ifndef pqRelievoScene_h
#define pqRelievoScene_h

#include <QString>
#include <QVector>

class pqDataRepresentation;
class pqView;

namespace pqRelievoScene
{
/** The representations that are seen as surfaces: they can have a material. */
QVector<pqDataRepresentation*> FindSurfaces(pqView* view);

/** Whether a representation that is seen has the switch of that name on ("RelievoFog"). */
bool IsUsed(pqView* view, const QString& name);

/** Bounds in the world of all surfaces together; false if there are none. */
bool GetBounds(pqView* view, double bounds[6]);

/** The axis that points up, by what is shown and by the camera; z where nothing is. */
int FindUpAxis(pqView* view);

/** Whether one of the surfaces is flat along the up axis: shadows can fall on it. */
bool HasGround(pqView* view);

/** Shows a plane below all surfaces, of three times their width and more. */
void MakeGround(pqView* view);

/** Whether all surfaces mirror the environment and are lit by it; false if there are none. */
bool IsLitByEnvironment(pqView* view);

/** Has all surfaces mirror the environment, and be lit by it. */
void LightByEnvironment(pqView* view);
}

#endif
