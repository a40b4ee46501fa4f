// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoViewSettings.h"

#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRelievoViews.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"

#include <QVariant>

#include <utility>

namespace
{
// The word of view.xml for the picture itself.
constexpr const char* NoLayer = "None";
// On a view whose shadows came with its sun.
constexpr const char* SunsShadows = "RelievoShadowsOfSun";

using Change = std::pair<const char*, QVariant>;

void Apply(pqView* view, const QString& label, const QVector<Change>& changes)
{
  if (!pqRelievoViewSettings::Find(view))
  {
    return;
  }
  vtkSMProxy* proxy = view->getProxy();
  {
    SCOPED_UNDO_SET(label);
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    for (const Change& change : changes)
    {
      vtkSMPropertyHelper property(proxy, change.first);
      if (change.second.type() == QVariant::String)
      {
        property.Set(qUtf8Printable(change.second.toString()));
      }
      else
      {
        property.Set(change.second.toInt());
      }
    }
    proxy->UpdateVTKObjects();
  }
  view->render();
}

int GetNumber(pqView* view, const char* name)
{
  vtkSMProxy* settings = pqRelievoViewSettings::Find(view);
  return settings ? vtkSMPropertyHelper(settings, name).GetAsInt() : 0;
}
}

//------------------------------------------------------------------------------
vtkSMProxy* pqRelievoViewSettings::Find(pqView* view)
{
  return view ? vtkSMRelievoViews::GetSettings(view->getProxy()) : nullptr;
}

//------------------------------------------------------------------------------
bool pqRelievoViewSettings::AreShadowsOn(pqView* view)
{
  return GetNumber(view, "Shadows") != 0;
}

//------------------------------------------------------------------------------
bool pqRelievoViewSettings::IsSunOn(pqView* view)
{
  return GetNumber(view, "Sun") != 0;
}

//------------------------------------------------------------------------------
QString pqRelievoViewSettings::GetShownLayer(pqView* view)
{
  vtkSMProxy* settings = pqRelievoViewSettings::Find(view);
  const QString name =
    settings ? vtkSMPropertyHelper(settings, "DisplayLayer").GetAsString() : NoLayer;
  return name == NoLayer ? QString() : name;
}

//------------------------------------------------------------------------------
QVector<QString> pqRelievoViewSettings::GetLayerNames(pqView* view)
{
  QVector<QString> names;
  vtkSMProxy* settings = pqRelievoViewSettings::Find(view);
  auto* domain =
    settings ? settings->GetProperty("DisplayLayer")->FindDomain<vtkSMStringListDomain>() : nullptr;
  for (unsigned int i = 0; domain && i < domain->GetNumberOfStrings(); ++i)
  {
    names.append(domain->GetString(i));
  }
  return names;
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::SetShadows(pqView* view, bool on)
{
  if (view)
  {
    view->setProperty(SunsShadows, false); // somebody wants them, or not, for themselves
  }
  Apply(view, on ? "Shadows on" : "Shadows off", { { "RelievoShadows", on ? 1 : 0 } });
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::SetSun(pqView* view, bool on)
{
  if (!view)
  {
    return;
  }
  QVector<Change> changes = { { "RelievoSun", on ? 1 : 0 } };
  if (on != AreShadowsOn(view) && (on || view->property(SunsShadows).toBool()))
  {
    changes.append({ "RelievoShadows", on ? 1 : 0 });
    view->setProperty(SunsShadows, on);
  }
  Apply(view, on ? "Sun on" : "Sun off", changes);
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::SetShownLayer(pqView* view, const QString& name)
{
  Apply(
    view, "Show layer", { { "RelievoDisplayLayer", name.isEmpty() ? QString(NoLayer) : name } });
}
