// SPDX-License-Identifier: BSD-3-Clause
// What representations show, and the hints of our sources about their outputs.
#pragma once

class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMSourceProxy;

namespace cartesian
{

struct Output
{
  vtkSMSourceProxy* source;
  int port;
};

// The Input of a representation, or of a filter. Source null: it is not one output of a source.
Output inputOf(vtkSMProxy* consumer);

// The source's hint of this name for a port, by its attribute "port", which is 0 if left out; null: none.
vtkPVXMLElement* hintOf(vtkSMProxy* source, int port, const char* name);

}
