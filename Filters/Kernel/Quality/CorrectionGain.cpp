// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/CorrectionGain.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Sums over the faces of a cell, with areas outward.
struct Answer
{
  Vector gradient{};   // Gauss's, times the volume, to a change of 1, without boundaries
  Vector boundary{};   // ... of these, where the value there is the cell's
  Vector correction{}; // times a gradient it is what a change of that adds to the flow out
  double matrix = 0;
  double fixed = 0; // ... of boundaries with a value
};

double gainOf(const Answer& answer, double volume)
{
  const double free = dot(answer.correction, plus(answer.gradient, answer.boundary));
  const double fixed = dot(answer.correction, answer.gradient);
  return std::max(std::abs(free) / (answer.matrix * volume + Tiny),
    std::abs(fixed) / ((answer.matrix + answer.fixed) * volume + Tiny));
}

// A cell's volume by its area: what flows answer to a pressure is about in proportion to it.
std::vector<double> lengthsOf(const FaceList& faces, const Quality& quality)
{
  std::vector<double> area(quality.cellGeometry.size());
  for (std::size_t f = 0; f < faces.owner.size(); ++f)
  {
    const double size = norm(quality.faceGeometry[f].area);
    area[faces.owner[f]] += size;
    if (f < faces.neighbour.size())
    {
      area[faces.neighbour[f]] += size;
    }
  }
  for (std::size_t c = 0; c < area.size(); ++c)
  {
    area[c] = std::abs(quality.cellGeometry[c].volume) / (area[c] + Tiny);
  }
  return area;
}

}

std::vector<double> correctionGains(const FaceList& faces, const Quality& quality)
{
  const std::vector<double> lengths = lengthsOf(faces, quality);
  std::vector<Answer> answers(quality.cellGeometry.size());
  for (std::size_t f = 0; f < faces.owner.size(); ++f)
  {
    const FaceGeometry& face = quality.faceGeometry[f];
    const double area = norm(face.area) + Tiny;
    const CellGeometry& cell = quality.cellGeometry[faces.owner[f]];
    Answer& low = answers[faces.owner[f]];
    const double toLow = std::abs(dot(face.area, minus(face.centre, cell.centre))) / area;
    if (f >= faces.neighbour.size())
    {
      low.boundary = plus(low.boundary, face.area);
      low.fixed += lengths[faces.owner[f]] * area / (toLow + Tiny);
      continue;
    }
    const Vector& beyond = quality.cellGeometry[faces.neighbour[f]].centre;
    Answer& high = answers[faces.neighbour[f]];
    const double toHigh = std::abs(dot(face.area, minus(face.centre, beyond))) / area;
    const double weight = toHigh / (toLow + toHigh + Tiny); // of the owner
    const Vector way = minus(beyond, cell.centre);
    const double along = dot(way, face.area) / area;
    const double coefficient =
      weight * lengths[faces.owner[f]] + (1 - weight) * lengths[faces.neighbour[f]];
    const Vector beside = scaled(minus(face.area, scaled(way, area / (along + Tiny))), coefficient);
    low.gradient = plus(low.gradient, scaled(face.area, weight));
    high.gradient = minus(high.gradient, scaled(face.area, 1 - weight));
    low.correction = plus(low.correction, scaled(beside, weight));
    high.correction = minus(high.correction, scaled(beside, 1 - weight));
    const double matrix = coefficient * area / (std::abs(along) + Tiny);
    low.matrix += matrix;
    high.matrix += matrix;
  }
  std::vector<double> gains;
  for (std::size_t c = 0; c < answers.size(); ++c)
  {
    gains.push_back(gainOf(answers[c], std::abs(quality.cellGeometry[c].volume)));
  }
  return gains;
}

}
