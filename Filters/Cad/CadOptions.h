// SPDX-License-Identifier: BSD-3-Clause
// How a CAD file is read: the properties of vtkCADReader.
#pragma once

namespace cartesian
{

enum class CadNames
{
  Automatic, // the first of the next three that tells faces apart
  Faces,     // of the file
  Colors,
  TangentGroups, // faces that are joined by smooth edges
  Layers,
  Solids
};

// Of names.
enum class CadEncoding
{
  Automatic, // UTF-8 if all is; else it is guessed
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

struct CadOptions
{
  double unit = 1000; // millimetres in the unit of the result
  double deflection =
    0; // in that unit: largest distance of a triangle's edge from a curve; 0: a part of the size
  double angle = 10; // degrees between a curve's successive edges
  CadNames names = CadNames::Automatic;
  double healTolerance = 0; // in that unit: gaps up to this are closed; 0: those of IGES files only
  bool gluesSolids = false; // faces in which solids touch become one
  bool mergesCoplanar = false;
  bool keepsDamaged = false; // solids whose triangles do not close
  CadEncoding encoding = CadEncoding::Automatic;
};

}
