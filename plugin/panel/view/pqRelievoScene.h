// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Queries and extends the scene of a view for Relievo's dock. Each change is one undo step, with
// its lines of a Python trace.
#ifndef pqRelievoScene_h
#define pqRelievoScene_h

#include <QString>
#include <QVector>

class pqDataRepresentation;
class pqView;

namespace pqRelievoScene
{
/** The representations visible as surfaces, which can have a material. */
QVector<pqDataRepresentation*> FindSurfaces(pqView* view);

/** Whether a visible representation has the switch of that name on ("RelievoFog"). */
bool IsUsed(pqView* view, const QString& name);

/** World bounds of all surfaces together; false if there are none. */
bool GetBounds(pqView* view, double bounds[6]);

/** The up axis, by the surfaces and the camera; z if there are none. */
int FindUpAxis(pqView* view);

/** Whether one of the surfaces is flat along the up axis, so that shadows are visible on it. */
bool HasGround(pqView* view);

/** Adds a plane below all surfaces, at least three times as wide. */
void MakeGround(pqView* view);

/** Whether all surfaces mirror the environment and are lit by it; false if there are none. */
bool IsLitByEnvironment(pqView* view);

/** Makes all surfaces mirror the environment, and be lit by it. */
void LightByEnvironment(pqView* view);
}

#endif
