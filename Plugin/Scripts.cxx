// SPDX-License-Identifier: BSD-3-Clause
#include "Scripts.h"

#include <dlfcn.h>

namespace cartesian
{

namespace
{

// Of the interpreter that ParaView has loaded, if it has: the plugin is built without Python. Null: none.
template <typename Function>
Function* ofPython(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}

bool isInScript()
{
  auto* const isInitialized = ofPython<int()>("Py_IsInitialized");
  auto* const hasThread = ofPython<int()>("PyGILState_Check");
  auto* const frame = ofPython<void*()>("PyEval_GetFrame");
  return isInitialized && hasThread && frame && isInitialized() != 0 && hasThread() != 0 &&
    frame() != nullptr;
}

}
