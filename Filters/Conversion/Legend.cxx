// SPDX-License-Identifier: BSD-3-Clause
#include "Legend.h"

#include "Mesher/Mesher.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

#include <set>

namespace cartesian
{

namespace
{

vtkStringArray* stringsOf(vtkFieldData* data, const std::string& name)
{
  return vtkStringArray::SafeDownCast(data->GetAbstractArray(name.c_str()));
}

class Legend
{
public:
  void add(vtkDataObject* data)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        add(blocks->GetBlock(i));
      }
    }
    else if (auto* single = vtkDataSet::SafeDownCast(data))
    {
      addArrays(single);
    }
  }

  std::vector<std::string> entries;

private:
  void addArrays(vtkDataSet* data)
  {
    vtkCellData* cells = data->GetCellData();
    for (int a = 0; a < cells->GetNumberOfArrays(); ++a)
    {
      if (auto* values = vtkStringArray::SafeDownCast(cells->GetAbstractArray(a)))
      {
        addValues(values, stringsOf(data->GetFieldData(), values->GetName() + std::string("s")));
      }
    }
    vtkStringArray* regions = stringsOf(data->GetFieldData(), "RegionNames");
    for (vtkIdType i = 0; regions && i < regions->GetNumberOfValues(); ++i)
    {
      add("Region/" + std::to_string(FirstRegion + i) + "/" + regions->GetValue(i));
    }
  }

  void addValues(vtkStringArray* values, vtkStringArray* inOrder)
  {
    std::set<std::string> distinct;
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      distinct.insert(values->GetValue(i));
    }
    const std::string array = std::string(values->GetName()) + "/";
    for (vtkIdType i = 0; inOrder && i < inOrder->GetNumberOfValues(); ++i)
    {
      if (distinct.erase(inOrder->GetValue(i)) == 1)
      {
        add(array + inOrder->GetValue(i));
      }
    }
    for (const std::string& value : distinct)
    {
      add(array + value);
    }
  }

  // Two outputs may list the same.
  void add(const std::string& entry)
  {
    if (known_.insert(entry).second)
    {
      entries.push_back(entry);
    }
  }

  std::set<std::string> known_;
};

}

std::vector<std::string> legendOf(const std::vector<vtkDataObject*>& outputs)
{
  Legend legend;
  for (vtkDataObject* output : outputs)
  {
    legend.add(output);
  }
  return legend.entries;
}

}
