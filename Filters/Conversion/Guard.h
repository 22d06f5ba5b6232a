// SPDX-License-Identifier: BSD-3-Clause
// The kernel's exceptions as a VTK algorithm's error codes and messages.
#pragma once

#include "Base/Error.h"
#include "Base/Execution.h"

#include "vtkErrorCode.h"

#include <new>
#include <string>

namespace cartesian
{

constexpr unsigned long errorCode(Fault fault)
{
  return vtkErrorCode::UserError + static_cast<unsigned long>(fault);
}

// Calls `work`; true if it threw nothing. Else calls report(error code, message); stopped by the
// user, there is no message.
template <class Work, class Report>
bool guarded(Work&& work, Report&& report)
{
  try
  {
    work();
    return true;
  }
  catch (const Error& error)
  {
    report(errorCode(error.fault), error.what());
  }
  catch (const Stopped&)
  {
    report(errorCode(Fault::Stopped), "");
  }
  catch (const std::bad_alloc&)
  {
    report(errorCode(Fault::OutOfMemory),
      "Out of memory. Use a larger cell size, or set a lower memory limit to be told before the "
      "work begins.");
  }
  return false;
}

}
