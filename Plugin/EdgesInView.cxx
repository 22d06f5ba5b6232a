// SPDX-License-Identifier: BSD-3-Clause
#include "EdgesInView.h"

#include "PortHints.h"
#include "Registration.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMOutputPort.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h"

#include <cstring>
#include <string>

namespace cartesian
{

namespace
{

// More than these have no edges: a view of a million pixels would be full of them.
constexpr vtkTypeInt64 MostFacesWithEdges = 60000;

constexpr const char* WithEdges = "Surface With Edges";
constexpr const char* Without = "Surface";

// Of one representation.
class Edges : public vtkCommand
{
public:
  static Edges* New() { return new Edges; }

  void Begin(vtkSMProxy* representation, const Output& shown)
  {
    this->Representation = representation;
    this->Source = shown.source;
    this->Port = static_cast<unsigned int>(shown.port);
    this->Fit();
    this->Source->AddObserver(vtkCommand::UpdateDataEvent, this);
    representation->GetProperty("Representation")->AddObserver(vtkCommand::ModifiedEvent, this);
  }

  void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
  {
    if (caller == this->Source)
    {
      this->Fit();
    }
    else
    {
      this->IsChosen = this->IsChosen || !this->IsFitting;
    }
  }

private:
  void Fit()
  {
    vtkSMProxy* representation = this->Representation;
    if (!representation || !this->Source || this->IsChosen)
    {
      return;
    }
    const char* const wanted =
      this->Source->GetOutputPort(this->Port)->GetDataInformation()->GetNumberOfCells() >
        MostFacesWithEdges
      ? Without
      : WithEdges;
    vtkSMPropertyHelper type(representation, "Representation");
    if (std::strcmp(type.GetAsString(), wanted) != 0)
    {
      this->IsFitting = true;
      type.Set(wanted);
      representation->UpdateVTKObjects();
      this->IsFitting = false;
    }
  }

  vtkWeakPointer<vtkSMProxy> Representation;
  vtkWeakPointer<vtkSMSourceProxy> Source;
  unsigned int Port = 0;
  bool IsFitting = false;
  bool IsChosen = false; // by somebody else
};

void watchNew(vtkSMProxy* proxy, const std::string& group)
{
  if (group != "representations" || proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  const Output shown = inputOf(proxy);
  vtkPVXMLElement* const hint =
    shown.source ? hintOf(shown.source, shown.port, "RepresentationType") : nullptr;
  const vtkSMPropertyHelper type(proxy, "Representation", true);
  if (hint && std::strcmp(hint->GetAttributeOrEmpty("type"), WithEdges) == 0 &&
    type.GetNumberOfElements() == 1 && std::strcmp(type.GetAsString(), WithEdges) == 0)
  {
    vtkNew<Edges> edges;
    edges->Begin(proxy, shown);
  }
}

}

void watchEdges()
{
  onRegistered<watchNew>();
}

}
