// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTaskFileWriter.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <filesystem>
#include <fstream>

vtkStandardNewMacro(vtkTaskFileWriter);

vtkTaskFileWriter::vtkTaskFileWriter()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

vtkTaskFileWriter::~vtkTaskFileWriter()
{
  delete[] this->FileName;
  this->SetText(nullptr);
}

int vtkTaskFileWriter::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkTaskFileWriter::Write()
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (processes && processes->GetLocalProcessId() > 0)
  {
    return 1;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("A task needs the name of a file.");
    return 0;
  }
  // Beside, so that a full disk leaves what was there.
  const std::filesystem::path file(this->FileName);
  const std::filesystem::path beside(std::string(this->FileName) + ".new");
  std::ofstream stream(beside, std::ios::binary);
  stream << (this->Text ? this->Text : "") << std::flush;
  stream.close();
  std::error_code failure;
  if (stream)
  {
    std::filesystem::rename(beside, file, failure);
  }
  if (!stream || failure)
  {
    std::filesystem::remove(beside, failure);
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< this->FileName << " cannot be written: choose another folder.");
    return 0;
  }
  return 1;
}

void vtkTaskFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Text: " << (this->Text ? this->Text : "(none)") << "\n";
}
