// SPDX-License-Identifier: BSD-3-Clause
// Exceptions as a VTK algorithm's error codes and messages: none may leave a filter.
#pragma once

#include "Base/Error.h"
#include "Base/Execution.h"

#include "vtkErrorCode.h"

#include <exception>
#include <new>
#include <string>

namespace cartesian
{

constexpr unsigned long errorCode(Fault fault)
{
  return vtkErrorCode::UserError + static_cast<unsigned long>(fault);
}

// Calls `work`; true if it threw nothing. Else calls report(error code, message); the message is empty if the user
// stopped the work. Unexpected exceptions are vtkErrorCode::UnknownError.
template <class Work, class Report>
bool reportErrors(Work&& work, Report&& report)
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
      "Out of memory: choose a larger Cell Size, or set a lower Memory Limit to be warned before "
      "meshing starts.");
  }
  catch (const std::exception& error)
  {
    report(vtkErrorCode::UnknownError, std::string("Unexpected error: ") + error.what());
  }
  catch (...)
  {
    report(vtkErrorCode::UnknownError, "Unexpected error.");
  }
  return false;
}

}
