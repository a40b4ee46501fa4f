// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free memory in control groups of both versions, from folders like those of Linux.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoCgroup.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <fstream>
#include <string>

namespace testCgroup
{
namespace
{
void Write(const std::string& path, const std::string& text)
{
  vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(path));
  std::ofstream(path) << text;
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testCgroup)
{
  relievoTest::Session session;
  const std::string root = relievoTest::OutputFolder() + "/cgroup";
  vtksys::SystemTools::RemoveADirectory(root);
  const std::string groups = root + "/self";
  const auto free = [&]() { return relievo::FreeBytesOfCgroup(groups, root); };
  RELIEVO_CHECK(std::isinf(free())); // no such file

  Write(groups, "0::/slice/job:1\n");
  RELIEVO_CHECK(std::isinf(free())); // a group that is not seen from here
  Write(root + "/slice/job:1/memory.max", "max\n");
  Write(root + "/slice/job:1/memory.current", "500\n");
  RELIEVO_CHECK(std::isinf(free()));
  Write(root + "/slice/memory.max", "10000\n");
  Write(root + "/slice/memory.current", "4000\n");
  Write(root + "/slice/memory.stat", "anon 3000\nfile 900\ninactive_file 700\n");
  RELIEVO_CHECK(free() == 6700.);
  Write(root + "/slice/job:1/memory.max", "2000\n");
  RELIEVO_CHECK(free() == 1500.);
  Write(root + "/memory.max", "1200\n"); // a container's own
  RELIEVO_CHECK(free() == 1200.);
  Write(root + "/slice/job:1/memory.current", "3000\n");
  RELIEVO_CHECK(free() == 0.);

  Write(groups, "5:cpu,cpuacct:/x\n4:hugetlb,memory:/lxc\n1:name=systemd:/\n");
  RELIEVO_CHECK(std::isinf(free()));
  Write(root + "/memory/lxc/memory.limit_in_bytes", "8000\n");
  Write(root + "/memory/lxc/memory.usage_in_bytes", "5000\n");
  Write(root + "/memory/lxc/memory.stat", "inactive_file 1\ntotal_inactive_file 250\n");
  Write(root + "/memory/memory.limit_in_bytes", "9223372036854771712\n");
  RELIEVO_CHECK(free() == 3250.);
  RELIEVO_CHECK(relievo::FreeBytesOfCgroup() >= 0.);
  return session.Result();
}
}
