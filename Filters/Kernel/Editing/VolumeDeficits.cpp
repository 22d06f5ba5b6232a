// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/VolumeDeficits.h"

namespace cartesian
{

namespace
{

// Calls visit(face, what it owed, whether it is there) for the walls that changed, or the faces between regions; it may
// change what they owe.
template <class Visitor>
void forEachChanged(const MeshEditor& mesh, bool ofWalls, Visitor&& visit)
{
  const auto isMeant = [&](const EditFace& face) {
    return !face.gone && isSurface(face) && (face.above == None) == ofWalls;
  };
  const std::size_t count = mesh.faceRecords().size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& [f, was] = mesh.faceRecords()[i];
    const EditFace& is = mesh.face(f);
    const bool hasMoved = isMeant(was) != isMeant(is) || was.corners.first != is.corners.first ||
      was.centre != is.centre;
    if (hasMoved && MeshEditor::isOldest(was))
    {
      visit(f, isMeant(was) ? mesh.signOf(was) * was.volumeDeficit : 0, isMeant(is));
    }
  }
}

void passOnDeficits(MeshEditor& mesh, bool ofWalls)
{
  const ChangedDeficit deficit = changedDeficit(mesh, ofWalls);
  forEachChanged(mesh, ofWalls, [&](std::uint32_t f, double, bool isThere) {
    if (isThere)
    {
      const double share = deficit.area > 0 ? norm(mesh.face(f).area) / deficit.area : 0;
      mesh.changeFace(f).volumeDeficit = mesh.signOf(f) * deficit.after * share;
    }
  });
}

}

ChangedDeficit changedDeficit(const MeshEditor& mesh, bool ofWalls)
{
  ChangedDeficit deficit;
  forEachChanged(mesh, ofWalls, [&](std::uint32_t f, double was, bool isThere) {
    deficit.before += was;
    ++deficit.walls;
    deficit.area += isThere ? norm(mesh.face(f).area) : 0;
  });
  deficit.after = deficit.before - (ofWalls ? mesh.delta.volume : mesh.delta.interRegionVolume);
  return deficit;
}

void passOnDeficits(MeshEditor& mesh)
{
  passOnDeficits(mesh, true);
  if (mesh.delta.interRegionVolume != 0)
  {
    passOnDeficits(mesh, false);
  }
}

}
