// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/EditTrials.h"

#include "Acceptance/Acceptance.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

bool EditTrials::editBest(std::uint32_t face)
{
  proposeEdits(m_, face, edits_);
  double best = 0;
  const ProposedEdit* chosen = nullptr;
  for (const ProposedEdit& edit : edits_)
  {
    const double gain = tryOut(edit);
    if (gain > 0)
    {
      takeBack();
    }
    if (gain > best)
    {
      best = gain;
      chosen = &edit;
    }
  }
  if (chosen)
  {
    tryOut(*chosen);
    m_.faces.commit();
    m_.changes.mark(around_.cells);
  }
  return chosen != nullptr;
}

// Makes the edit if the objective falls; returns by how much, or 0.
double EditTrials::tryOut(const ProposedEdit& edit)
{
  if (edit.kind == ProposedEdit::Kind::Join)
  {
    around_.faces = { std::min(edit.one, edit.other), std::max(edit.one, edit.other) };
  }
  else
  {
    const NumberLists::List faces = m_.faces.facesOf(edit.one);
    around_.faces.assign(faces.begin(), faces.end());
  }
  m_.faces.lookAround(around_);
  m_.energy.keep(around_, kept_);
  const double before = m_.energy.known(around_);
  const double volume = volumeAround();
  const bool isMesh = edit.kind == ProposedEdit::Kind::Join
    ? m_.faces.join(edit.one, edit.other, around_)
    : m_.faces.collapse(edit.one, edit.other, around_);
  after_.faces = m_.faces.remaining();
  m_.energy.measure(after_.faces);
  if (isMesh && keepsShapes() && keepsWall(edit))
  {
    m_.faces.lookAround(after_);
    const double most = acceptedBelow(before);
    const double after = m_.energy.evaluate(after_, most) +
      AcceptedEdit::CostOfVolume * std::abs(volumeAround() - volume) /
        m_.mesh.cells.volumeOfBox[around_.cells.front()];
    if (after < most && m_.faces.isSound())
    {
      return before - after;
    }
  }
  takeBack();
  return 0;
}

void EditTrials::takeBack()
{
  m_.faces.putBack();
  m_.energy.putBack(around_, kept_);
}

// Whether faces have stars and areas, and those of the wall about the normals that they had.
bool EditTrials::keepsShapes() const
{
  return std::all_of(after_.faces.begin(), after_.faces.end(), [&](std::uint32_t f) {
    const auto at = std::lower_bound(around_.faces.begin(), around_.faces.end(), f);
    const auto i = static_cast<std::size_t>(at - around_.faces.begin());
    const double edge = m_.task.edges[f];
    const FaceGeometry& face = m_.energy.measures(f);
    return m_.energy.star(f) >= std::min(AcceptedEdit::LeastStar, kept_.stars[i]) &&
      norm(face.area) >=
      std::min(AcceptedEdit::LeastArea * edge * edge, norm(kept_.faces[i].area)) &&
      (!m_.mesh.isWall(f) ||
        dot(unit(kept_.faces[i].area), unit(face.area)) >= AcceptedEdit::WallCosine);
  });
}

bool EditTrials::keepsWall(const ProposedEdit& edit) const
{
  for (std::size_t i = 0; i < around_.faces.size(); ++i)
  {
    const std::uint32_t f = edit.kind == ProposedEdit::Kind::Join ? edit.one : around_.faces[i];
    if (m_.mesh.isWall(f) && !m_.faces.isGone(f))
    {
      const FaceGeometry& face = m_.energy.measures(f);
      const double off = dot(minus(kept_.faces[i].centre, face.centre), unit(face.area));
      if (std::abs(off) > AcceptedEdit::FarthestFromWall * m_.task.edges[f])
      {
        return false;
      }
    }
  }
  return true;
}

double EditTrials::volumeAround() const
{
  double sum = 0;
  for (const std::uint32_t c : around_.cells)
  {
    sum += m_.mesh.cells.measures[c].volume;
  }
  return sum;
}

}
