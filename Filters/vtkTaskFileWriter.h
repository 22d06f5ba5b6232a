// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTaskFileWriter
 * @brief writes the text of a task file where the data are: the server
 *
 * Its input is the mesher, which is not updated; ParaView's client composes the text. On several processes the first
 * writes.
 *
 * Errors (GetErrorCode): vtkErrorCode::NoFileNameError; vtkErrorCode::CannotOpenFileError. An existing file is then
 * unchanged.
 */
#ifndef vtkTaskFileWriter_h
#define vtkTaskFileWriter_h

#include "vtkAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkTaskFileWriter : public vtkAlgorithm
{
public:
  static vtkTaskFileWriter* New();
  vtkTypeMacro(vtkTaskFileWriter, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * What to write, in UTF-8.
   */
  vtkSetStringMacro(Text);
  vtkGetStringMacro(Text);
  ///@}

  /**
   * Writes the file. Returns 1, or 0 with an error code.
   */
  int Write();

protected:
  vtkTaskFileWriter();
  ~vtkTaskFileWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  char* FileName = nullptr;
  char* Text = nullptr;

private:
  vtkTaskFileWriter(const vtkTaskFileWriter&) = delete;
  void operator=(const vtkTaskFileWriter&) = delete;
};

#endif
