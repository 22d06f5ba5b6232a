// SPDX-License-Identifier: BSD-3-Clause
#include "CadReferences.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <StepBasic_DocumentFile.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>

#include <set>

namespace cartesian
{

std::vector<std::string> unreadFiles(const STEPCAFControl_Reader& reader)
{
  STEPConstruct_ExternRefs references(reader.Reader().WS());
  references.LoadExternRefs();
  std::set<std::string> files;
  for (int i = 1; i <= references.NbExternRefs(); ++i)
  {
    const Standard_CString name = references.FileName(i);
    Handle(STEPCAFControl_ExternFile) file;
    const bool isRead = name && reader.ExternFile(name, file) && !file.IsNull() &&
      file->GetLoadStatus() == IFSelect_RetDone && file->GetTransferStatus();
    if (name && *name && !isRead && !references.ProdDef(i).IsNull())
    {
      files.insert(name);
    }
  }
  return { files.begin(), files.end() };
}

std::vector<std::string> namedFiles(const STEPCAFControl_Reader& reader)
{
  const Handle(Interface_InterfaceModel) model = reader.Reader().WS()->Model();
  std::set<std::string> files;
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(StepBasic_DocumentFile) file =
      Handle(StepBasic_DocumentFile)::DownCast(model->Value(i));
    if (!file.IsNull() && !file->Id().IsNull() && !file->Id()->IsEmpty())
    {
      files.insert(file->Id()->ToCString());
    }
  }
  return { files.begin(), files.end() };
}

std::string listOf(const std::vector<std::string>& files)
{
  constexpr std::size_t Most = 5;
  std::string list;
  for (std::size_t i = 0; i < files.size() && i < Most; ++i)
  {
    list += (i > 0 ? ", " : "") + files[i];
  }
  return files.size() > Most ? list + " and " + std::to_string(files.size() - Most) + " more"
                             : list;
}

}
