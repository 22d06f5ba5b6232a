// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshReportWriter.h"

#include "Base/OutputFile.h"
#include "MeshReport.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMeshReportWriter);

void vtkMeshReportWriter::WriteGrid(vtkUnstructuredGrid* grid)
{
  const std::string page = cartesian::html(cartesian::reportOf(grid, cartesian::upstreamOf(this)));
  cartesian::replaceFiles(
    { this->FileName }, [&](const std::vector<std::filesystem::path>& unfinished) {
      cartesian::OutputFile file(unfinished.front());
      file.text(page);
      file.close();
    });
}
