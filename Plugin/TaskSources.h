// SPDX-License-Identifier: BSD-3-Clause
// What feeds a mesher, as the files that a task file names.
#pragma once

#include <string>
#include <vector>

class vtkSMProxy;

namespace cartesian
{

constexpr int InputShape = 2; // of Refinement Region

struct TaskFile
{
  std::string path;
  std::string name; // of its block; empty: it is no block
};

// The name that the pipeline browser shows, with what it is: "Clip1 (Clip)".
std::string nameInBrowser(vtkSMProxy* source);

// Throws std::runtime_error: why a task cannot have a source, and what to do instead. `input`: of which input of which mesher.
[[noreturn]] void refuse(vtkSMProxy* source, const std::string& why, const std::string& input);

// The label of a setting of a reader that another of its kind has not: any but the file. Empty: none.
std::string differingSetting(vtkSMProxy* reader, vtkSMProxy* other);

// The file of an input of a mesher, if it is a reader of one file just as a task opens it; settings of CAD readers are those of TaskCad.h. Throws std::runtime_error
// that says what to do instead.
std::string fileOf(vtkSMProxy* source, unsigned int port, const std::string& input);

// Those of a surface: a reader's, or all of a Group Datasets; throws alike.
std::vector<TaskFile> filesOf(vtkSMProxy* source, unsigned int port, const std::string& input);

}
