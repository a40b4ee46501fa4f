// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeakCounter.h"

#include <vtkObject.h>

#include <dlfcn.h>

#include <mutex>
#include <sstream>
#include <unordered_map>

namespace
{
struct ObjectBook
{
  std::mutex Mutex;
  std::unordered_map<const void*, std::string> Living;
};

// Never deleted: VTK objects are still destroyed after the program's own statics.
ObjectBook& TheBook()
{
  static ObjectBook* instance = new ObjectBook;
  return *instance;
}

using ObjectFunction = void (*)(void*);

// The library's original function, which ours hides.
ObjectFunction Original(const char* symbol)
{
  return reinterpret_cast<ObjectFunction>(dlsym(RTLD_NEXT, symbol));
}
}

//------------------------------------------------------------------------------
// Called by New() of every VTK class once the object is complete.
void vtkObjectBase::InitializeObjectBase()
{
  {
    ObjectBook& all = TheBook();
    const std::lock_guard<std::mutex> lock(all.Mutex);
    all.Living[this] = this->GetClassName();
  }
  static const ObjectFunction original = Original("_ZN13vtkObjectBase20InitializeObjectBaseEv");
  if (original)
  {
    original(this);
  }
}

//------------------------------------------------------------------------------
// The base-object destructor of vtkObjectBase, by its name in the Itanium C++ ABI.
extern "C" void relievoTestObjectBaseDestructor(void* object) __asm__("_ZN13vtkObjectBaseD2Ev");
extern "C" void relievoTestObjectBaseDestructor(void* object)
{
  {
    ObjectBook& all = TheBook();
    const std::lock_guard<std::mutex> lock(all.Mutex);
    all.Living.erase(object);
  }
  static const ObjectFunction original = Original("_ZN13vtkObjectBaseD2Ev");
  original(object);
}

#ifdef __SANITIZE_ADDRESS__
//------------------------------------------------------------------------------
// An unloaded driver has no name in the leak report, so lsan.supp cannot match it: drivers stay
// loaded.
extern "C" int dlclose(void*) noexcept
{
  return 0;
}
#endif

namespace relievoTest
{
//------------------------------------------------------------------------------
std::map<std::string, int> LiveObjects()
{
  std::map<std::string, int> count;
  ObjectBook& all = TheBook();
  const std::lock_guard<std::mutex> lock(all.Mutex);
  for (const auto& entry : all.Living)
  {
    ++count[entry.second];
  }
  return count;
}

//------------------------------------------------------------------------------
bool CanCountObjects()
{
  const int before = LiveObjects()["vtkObject"];
  vtkObject* object = vtkObject::New();
  const int during = LiveObjects()["vtkObject"];
  object->Delete();
  const int after = LiveObjects()["vtkObject"];
  return during == before + 1 && after == before;
}

//------------------------------------------------------------------------------
LeakCounter::LeakCounter()
  : Before(LiveObjects())
{
}

//------------------------------------------------------------------------------
std::string LeakCounter::Leaks() const
{
  // Kept by VTK until the process ends, in any case. The text renderer keeps the properties of the
  // texts that it drew last.
  static const char* const singletons[] = { "vtkFreeTypeTools", "vtkMathTextFreeTypeTextRenderer",
    "vtkOutputWindow", "vtkTextProperty" };
  std::ostringstream text;
  for (const auto& entry : LiveObjects())
  {
    bool known = false;
    for (const char* name : singletons)
    {
      known = known || entry.first == name;
    }
    const auto before = this->Before.find(entry.first);
    const int more = entry.second - (before == this->Before.end() ? 0 : before->second);
    if (more > 0 && !known)
    {
      text << (text.tellp() > 0 ? ", " : "") << entry.first << ": " << more << " more";
    }
  }
  return text.str();
}
}
