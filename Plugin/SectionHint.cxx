// SPDX-License-Identifier: BSD-3-Clause
#include "SectionHint.h"

#include "PortHints.h"
#include "Registration.h"
#include "TaskSources.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkType.h"

#include <string>

namespace cartesian
{

namespace
{

// As statistics of a mesh of ours say, whatever filters kept them.
bool hasPolyhedra(vtkPVDataInformation* mesh)
{
  vtkPVArrayInformation* const polyhedra =
    mesh->GetFieldDataInformation()->GetArrayInformation("Polyhedra");
  const bool isDivided = mesh->GetCellDataInformation()->GetArrayInformation("OriginalCellId");
  return mesh->GetDataSetType() == VTK_UNSTRUCTURED_GRID && !isDivided && polyhedra &&
    polyhedra->GetComponentRange(0)[1] > 0;
}

bool cutsCells(vtkSMProxy* section)
{
  return vtkSMPropertyHelper(section, "PreserveInputCells", true).GetAsInt() == 0; // Crinkle
}

// Of one Clip or Slice.
class Hint : public vtkCommand
{
public:
  static Hint* New() { return new Hint; }

  void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
  {
    static bool isTold = false;
    auto* const section = vtkSMSourceProxy::SafeDownCast(caller);
    const auto [mesh, port] = inputOf(section);
    if (!isTold && mesh && cutsCells(section) &&
      hasPolyhedra(mesh->GetDataInformation(static_cast<unsigned int>(port))))
    {
      isTold = true;
      vtkOutputWindowDisplayText((nameInBrowser(section) +
        ": ParaView cuts polyhedra only roughly. Filters > Meshing > Divide Polyhedra before this "
        "filter makes "
        "it exact; Slice Polyhedra cuts the mesh as it is.\n")
                                   .c_str());
    }
  }
};

void watchNew(vtkSMProxy* proxy, const std::string& group)
{
  const std::string name = proxy->GetXMLName() ? proxy->GetXMLName() : "";
  if (group == "sources" && (name == "Clip" || name == "Cut") && isInWindow())
  {
    proxy->AddObserver(vtkCommand::UpdateDataEvent, vtkNew<Hint>());
  }
}

}

void watchSections()
{
  onRegistered<watchNew>();
}

}
