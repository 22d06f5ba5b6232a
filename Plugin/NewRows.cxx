// SPDX-License-Identifier: BSD-3-Clause
#include "NewRows.h"

#include "Registration.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace cartesian
{

namespace
{

constexpr unsigned int Width = 3; // of the columns

unsigned int elementsOf(vtkSMProperty* column)
{
  vtkSMPropertyHelper helper(column);
  helper.SetUseUnchecked(true);
  return helper.GetNumberOfElements();
}

// Replaces the values of the last row of a column in the panel.
void setLastRow(vtkSMProperty* column, const std::vector<double>& values)
{
  vtkSMPropertyHelper helper(column);
  helper.SetUseUnchecked(true);
  std::vector<double> all = helper.GetDoubleArray();
  std::copy(values.begin(), values.end(), all.end() - Width);
  vtkSMDoubleVectorProperty::SafeDownCast(column)->SetUncheckedElements(
    all.data(), static_cast<unsigned int>(all.size()));
}

// Of one table.
class NewRow : public vtkCommand
{
public:
  static NewRow* New() { return new NewRow; }

  void Begin(vtkSMProxy* source, vtkSMPropertyGroup* table, vtkPVXMLElement* hint)
  {
    this->Source = source;
    this->Position = source->GetProperty(hint->GetAttribute("position"));
    this->Lengths = source->GetProperty(hint->GetAttribute("lengths"));
    for (unsigned int i = 0; i < table->GetNumberOfProperties(); ++i)
    {
      this->Columns.emplace_back(table->GetProperty(i));
      table->GetProperty(i)->AddObserver(vtkCommand::UncheckedPropertyModifiedEvent, this);
    }
    this->Rows = elementsOf(this->Lengths) / Width;
  }

  // Columns change in turn: a row is there when all have it.
  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override
  {
    const unsigned int rows = elementsOf(this->Lengths) / Width;
    for (vtkSMProperty* column : this->Columns)
    {
      if (elementsOf(column) !=
        rows * (column == this->Position || column == this->Lengths ? Width : 1))
      {
        return;
      }
    }
    const bool isNew = rows == this->Rows + 1;
    this->Rows = rows;
    if (isNew)
    {
      this->Place();
    }
  }

private:
  void Place()
  {
    vtkSMPropertyHelper position(this->Position);
    position.SetUseUnchecked(true);
    vtkSMPropertyHelper lengths(this->Lengths);
    lengths.SetUseUnchecked(true);
    const vtkSMPropertyHelper input(this->Source, "Input");
    auto* surface = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    for (unsigned int i = (this->Rows - 1) * Width; i < this->Rows * Width; ++i)
    {
      if (!surface || position.GetAsDouble(i) != 0 || lengths.GetAsDouble(i) != 1)
      {
        return; // not as the panel makes it
      }
    }
    double bounds[6];
    surface->GetDataInformation(input.GetOutputPort())->GetBounds(bounds);
    if (bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] < bounds[5])
    {
      setLastRow(this->Position, { bounds[0], bounds[2], bounds[4] });
      setLastRow(
        this->Lengths, { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    }
  }

  vtkWeakPointer<vtkSMProxy> Source;
  vtkWeakPointer<vtkSMProperty> Position;
  vtkWeakPointer<vtkSMProperty> Lengths;
  std::vector<vtkWeakPointer<vtkSMProperty>> Columns;
  unsigned int Rows = 0;
};

void watchTables(vtkSMProxy* source, const std::string& registeredAs)
{
  for (std::size_t i = 0; registeredAs == "sources" && i < source->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = source->GetPropertyGroup(i);
    vtkPVXMLElement* hint =
      group->GetHints() ? group->GetHints()->FindNestedElementByName("BeginAtInput") : nullptr;
    if (hint)
    {
      vtkNew<NewRow> row;
      row->Begin(source, group, hint);
    }
  }
}

}

void watchNewRows()
{
  onRegistered<watchTables>();
}

}
