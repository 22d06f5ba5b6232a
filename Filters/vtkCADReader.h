// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCADReader
 * @brief reads the solids of STEP, IGES and BREP files, closed, with names
 *
 * Output: a vtkMultiBlockDataSet with a block (vtkPolyData) for each solid, called as it, and one for all faces that belong
 * to none. Solids of one name are numbered. The blocks' triangles are welded: neighbours share their points. Lengths are
 * in LengthUnit, times Scale.
 *
 * Cells of a block: lines, which are the sharp edges, those at which faces meet that are not tangent; then triangles.
 * Cell arrays: BoundaryId (int), the same numbers in all blocks; BoundaryName (string); SharpEdge (unsigned char), 1 of lines,
 * 0 of triangles; OpenBody (unsigned char), 1 where faces belong to no solid. Field data of a block: BoundaryIds (int) and BoundaryNames (string), its boundaries; SolidName (string);
 * Volume and Area of the exact shape (Volume is 0 of one that is open, and where it is not known to 1e-6), VolumeOfTriangles; OpenEdges, of triangles without
 * a neighbour; Deflection, the one that was asked for, also where it is the default; MetresPerUnit, the length of LengthUnit.
 *
 * Open CASCADE reads the files, in a process of its own (Filters/Cad): it may crash on damaged files.
 *
 * Errors: CannotRead (also without Open CASCADE), BadParameter, Stopped.
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkCADReader_h
#define vtkCADReader_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkNew.h"                          // for tables of what was found
#include "vtkTimeStamp.h"                    // for the time of reading

#include <string> // for names of files

class vtkMultiBlockDataSet;
class vtkStringArray;

namespace cartesian
{
struct CadContent;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCADReader : public vtkCartesianAlgorithm
{
public:
  static vtkCADReader* New();
  vtkTypeMacro(vtkCADReader, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The file: .step, .stp, .iges, .igs or .brep.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /**
   * Largest distance of triangles from the exact shape, in LengthUnit; 0, the default: a thousandth of the longest side
   * of all solids together.
   */
  vtkSetMacro(Deflection, double);
  vtkGetMacro(Deflection, double);

  /**
   * Largest angle between successive edges along a curve, in degrees, 1 to 45; default 10.
   */
  vtkSetMacro(Angle, double);
  vtkGetMacro(Angle, double);

  enum LengthUnits
  {
    Metre,
    Centimetre,
    Millimetre,
    Inch,
    Foot
  };

  /**
   * The unit of the output; default Metre. The file says in which its own numbers are.
   */
  vtkSetMacro(LengthUnit, int);
  vtkGetMacro(LengthUnit, int);

  /**
   * All lengths are multiplied by it, for files that are wrong about their unit; default 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);

  enum NameSources
  {
    Automatic,     ///< names of faces; if they do not tell faces apart, colours; else groups
    Faces,         ///< the names of faces in the file; those without one are called as their solid
    Colors,        ///< RRGGBB
    TangentGroups, ///< the solid's name and a number for faces that are joined by smooth edges
    Layers,
    Solids
  };
  vtkSetMacro(BoundaryNamesFrom, int);
  vtkGetMacro(BoundaryNamesFrom, int);

  /**
   * Gaps between faces up to this are closed, in LengthUnit. 0, the default: none, but of IGES files, whose faces do not
   * know their neighbours, those up to 1e-4 of the size.
   */
  vtkSetMacro(HealTolerance, double);
  vtkGetMacro(HealTolerance, double);

  /**
   * Whether faces in which solids touch become one, with the same triangles on both sides; default true. Solids that
   * overlap are divided, with a warning.
   */
  vtkSetMacro(GlueSolids, bool);
  vtkGetMacro(GlueSolids, bool);

  /**
   * Whether neighbouring faces on one plane, cylinder or other surface become one, if the file says the same about them;
   * default false.
   */
  vtkSetMacro(MergeCoplanar, bool);
  vtkGetMacro(MergeCoplanar, bool);

  /**
   * Whether a solid stays of whose faces one cannot be triangulated, with the hole that this leaves and a warning; default false:
   * it is an error.
   */
  vtkSetMacro(KeepDamagedFaces, bool);
  vtkGetMacro(KeepDamagedFaces, bool);

  enum Encodings
  {
    Guessed, ///< UTF-8; of a file that is not, what is frequent in a language tells
    Utf8,
    WesternEuropean,
    CentralEuropean,
    Cyrillic,
    Greek,
    Turkish,
    SimplifiedChinese,
    TraditionalChinese,
    Japanese,
    Korean
  };

  /**
   * In which encoding the file has its names; default Guessed.
   */
  vtkSetMacro(NameEncoding, int);
  vtkGetMacro(NameEncoding, int);

  /**
   * Seconds after which a file that is not read is given up; 0: never. Default 1800.
   */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);

  /**
   * Of the last update, six columns with a first row that names them: solids, their volume, how far that of the triangles
   * is off, area, triangles, open edges.
   */
  vtkStringArray* GetFoundSolids();

  /**
   * Of the last update: what was found and done, a sentence each.
   */
  vtkStringArray* GetFindings();

protected:
  vtkCADReader();
  ~vtkCADReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkCADReader(const vtkCADReader&) = delete;
  void operator=(const vtkCADReader&) = delete;

  void Check() const;
  std::vector<std::string> Arguments() const;
  void Describe(const cartesian::CadContent& content);

  char* FileName = nullptr;
  double Deflection = 0;
  double Angle = 10;
  int LengthUnit = Metre;
  double Scale = 1;
  int BoundaryNamesFrom = Automatic;
  double HealTolerance = 0;
  bool GlueSolids = true;
  bool MergeCoplanar = false;
  bool KeepDamagedFaces = false;
  int NameEncoding = Guessed;
  double TimeLimit = 1800;
  vtkNew<vtkStringArray> FoundSolids;
  vtkNew<vtkStringArray> Findings;
  vtkNew<vtkMultiBlockDataSet>
    Read; // the output: where there are ranks, several pieces are asked for, all of them the whole
  vtkTimeStamp TimeOfRead;
};

#endif
