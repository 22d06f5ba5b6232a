// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianAlgorithm
 * @brief base of the filters of the Cartesian mesher
 *
 * Results do not depend on the number of threads.
 *
 * On an error a filter says what is wrong, where and what to do (vtkErrorMacro), sets an `ErrorCode`
 * (vtkAlgorithm::GetErrorCode) from the list below, and gives an empty output. Without an error the code is 0, even
 * if warnings report flaws.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCellAssembler vtkCartesianMesher
 */
#ifndef vtkCartesianAlgorithm_h
#define vtkCartesianAlgorithm_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkDataObjectAlgorithm.h"

#include <functional> // for std::function
#include <ostream>    // for what PrintColumn prints
#include <string>     // for std::string
#include <vector>     // for std::vector

namespace cartesian
{
class Execution;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkCartesianAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of GetErrorCode() after a failed update; from vtkErrorCode::UserError on.
   */
  enum ErrorCodes
  {
    EmptySurface = 40001,  ///< the input is missing or has no triangles
    BadCoordinate = 40002, ///< a coordinate is NaN, infinite or too large
    BadCellSize = 40003,  ///< the cell size is negative, NaN, or too small or large for the surface
    BadMeshlines = 40004, ///< meshlines do not increase, are too few, or miss the surface
    TooManyBoxes = 40005, ///< the estimated memory exceeds the limit
    MissingArray = 40006, ///< an array is missing, or has the wrong length or type
    FlawedSurface = 40007, ///< so flawed that there is nothing to mesh
    BadParameter = 40008,  ///< another property is out of its range
    Stopped = 40009,       ///< by the user
    OutOfMemory = 40010,   ///< there was less memory than estimated
    BadMesh = 40011,       ///< cells to write overlap, are inverted, or too many
    CannotWrite = 40012,   ///< a file cannot be written
    CannotRead = 40013     ///< a file cannot be read
  };

  ///@{
  /**
   * Entries of legends, boundaries in order of their ids: each value of a string array on the cells of an output, as
   * "array/value", and each region as "Region/number/name". The status is 1. Collected once per update.
   */
  int GetNumberOfLegendArrays();
  const char* GetLegendArrayName(int i);
  int GetLegendArrayStatus(const char* name);
  ///@}

  /**
   * The warnings of the last update.
   */
  const std::vector<std::string>& GetWarnings() const { return this->ToldWarnings; }

  ///@{
  /**
   * Number of threads; 0, the default, means one for each core.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkCartesianAlgorithm() = default;
  ~vtkCartesianAlgorithm() override = default;

  /**
   * Calls `work` with this filter's threads, progress and abort flag, and turns exceptions into an error message and
   * an error code. True if nothing was thrown. The work is the part from `begin` to `end` of the whole task
   * (Kernel/Mesher/Stages.h); the filter's progress never decreases.
   */
  bool Run(double begin, double end, const std::function<void(cartesian::Execution&)>& work);

  /**
   * A warning, unless the text is empty: for example of surface flaws that do not prevent meshing. It is printed when
   * the filter has finished, or before an error: ParaView's window shows no more progress after a warning.
   */
  void Warn(const std::string& text);

  /**
   * Prints the warnings so far: after work that is no update.
   */
  void TellWarnings();

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * An input port for a vtkPolyData, or many in a vtkMultiBlockDataSet, a vtkPartitionedDataSet or a
   * vtkPartitionedDataSetCollection. It accepts anything: other data give one error of our own instead of several by
   * VTK without a code.
   */
  static void AcceptAnything(vtkInformation* info);

  /**
   * The first process requests all of its inputs, whole: it makes the mesh alone.
   */
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * Requests all inputs, whole.
   */
  int AskForWholeInputs(vtkInformationVector** input);

  /**
   * Requests one more layer of ghost cells for a piece of the first input, if it has several.
   */
  static int AskForNeighbours(vtkInformationVector** input);

  /**
   * The requested output: only that one knows its piece.
   */
  static vtkInformation* AskedOutput(vtkInformation* request, vtkInformationVector* output);

  /**
   * True on all processes except the first: they give an empty output.
   */
  static bool IsLeftToFirstProcess(vtkInformation* request, vtkInformationVector* output);

  ///@{
  /**
   * For properties that are tables: new rows are empty; a missing row is an error.
   */
  template <class Row>
  void Resize(std::vector<Row>& table, int number)
  {
    if (number >= 0 && table.size() != static_cast<std::size_t>(number))
    {
      table.resize(static_cast<std::size_t>(number), Row{});
      this->Modified();
    }
  }
  template <class Row>
  void SetRow(std::vector<Row>& table, int row, const Row& values)
  {
    if (row < 0 || static_cast<std::size_t>(row) >= table.size())
    {
      vtkErrorMacro("There is no row " << row << ": set the number of rows first.");
      return;
    }
    if (table[static_cast<std::size_t>(row)] != values)
    {
      table[static_cast<std::size_t>(row)] = values;
      this->Modified();
    }
  }
  template <class Row>
  static void PrintColumn(
    ostream& os, vtkIndent indent, const std::string& name, const std::vector<Row>& table)
  {
    os << indent << name << ":";
    for (const Row& row : table)
    {
      os << " " << row;
    }
    os << "\n";
  }
  ///@}

  int NumberOfThreads = 0;
  bool IsSilent = false;                // the first process prints for all
  bool IsWaitedFor = false;             // by other processes: too late to stop
  std::function<bool()> HasOtherFailed; // of the processes; null: there are no others

private:
  std::vector<std::string> Warnings; // not printed yet
  std::vector<std::string> ToldWarnings;
  std::vector<std::string> Legend;
  vtkMTimeType LegendTime = 0; // of the outputs it describes

  vtkCartesianAlgorithm(const vtkCartesianAlgorithm&) = delete;
  void operator=(const vtkCartesianAlgorithm&) = delete;
};

#endif
