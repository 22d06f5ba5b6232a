// SPDX-License-Identifier: BSD-3-Clause
#include "CadEntities.h"

#include <IGESData_IGESEntity.hxx>
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace cartesian
{

namespace
{

// Of IGES: bounded and trimmed surfaces, faces.
bool isFace(int type)
{
  return type == 143 || type == 144 || type == 510;
}

class Entities
{
public:
  Entities(const Handle(XSControl_WorkSession) & session, const CadReport& report)
    : process_(session->TransferReader()->TransientProcess())
  {
    const Handle(Interface_InterfaceModel) model = session->Model();
    for (int i = 1; i <= model->NbEntities(); ++i)
    {
      const Handle(StepRepr_RepresentationItem) item =
        Handle(StepRepr_RepresentationItem)::DownCast(model->Value(i));
      const bool isFace = !item.IsNull() && item->IsKind(STANDARD_TYPE(StepShape_FaceSurface));
      if (isFace && !add(item, TopAbs_FACE))
      {
        lost_.emplace_back(model->StringLabel(item)->ToCString());
      }
      if (!item.IsNull() && item->IsKind(STANDARD_TYPE(StepShape_ManifoldSolidBrep)))
      {
        add(item, TopAbs_SOLID);
      }
    }
    if (!lost_.empty())
    {
      report.warning("Of " + std::to_string(lost_.size()) + " faces, " + lost_.front() +
        " the first of them in the file, nothing could be made: there are holes. Export the part "
        "again.");
    }
  }

  NamesOfShapes names;

private:
  // False if there is no such shape.
  bool add(const Handle(StepRepr_RepresentationItem) & item, TopAbs_ShapeEnum kind)
  {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process_, item);
    for (TopExp_Explorer part(shape, kind); !shape.IsNull() && part.More(); part.Next())
    {
      if (!item->Name().IsNull() && !item->Name()->IsEmpty())
      {
        names[part.Current().TShape().get()] = item->Name()->ToCString();
      }
    }
    return !shape.IsNull();
  }

  Handle(Transfer_TransientProcess) process_;
  std::vector<std::string> lost_;
};

}

NamesOfShapes namesOfShapes(const Handle(XSControl_WorkSession) & session, const CadReport& report)
{
  return Entities(session, report).names;
}

void noteDamage(const Handle(Interface_InterfaceModel) & model, const CadReport& report)
{
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(Interface_Check) check = model->Check(i, Standard_True);
    if (!check.IsNull() && check->HasFailed())
    {
      report.damage(std::string("Damaged in the file: ") +
        model->StringLabel(model->Value(i))->ToCString() + ", " + check->CFail(1) + ".");
      return;
    }
  }
}

void tellLostGeometry(const Handle(XSControl_WorkSession) & session, const CadReport& report)
{
  const Handle(Interface_InterfaceModel) model = session->Model();
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(IGESData_IGESEntity) entity =
      Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
    const Handle(Interface_Check) check = model->Check(i, Standard_True);
    if (!entity.IsNull() && isFace(entity->TypeNumber()) && !check.IsNull() && check->HasFailed() &&
      TransferBRep::ShapeResult(process, entity).IsNull())
    {
      report.warning(std::string("Of ") + model->StringLabel(entity)->ToCString() +
        ", damaged in the file (" + check->CFail(1) +
        "), nothing could be made: there may be holes. Export the part again.");
      return;
    }
  }
}

}
