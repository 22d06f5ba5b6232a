// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallImprovement.h"

#include "Base/Sorting.h"
#include "Editing/EditMeasures.h"
#include "Editing/EditZones.h"
#include "Editing/FlatFaces.h"
#include "Editing/NodePlaces.h"
#include "Editing/RefusalEnding.h"
#include "Editing/Refusals.h"
#include "Editing/ShortEdges.h"
#include "Editing/SmallCells.h"
#include "Editing/TrueVolume.h"
#include "Editing/WallCentring.h"
#include "Editing/WallSimplification.h"

#include <cmath>
#include <mutex>

namespace cartesian
{

namespace
{

// For what still fails: a wider search, costs count in full, and walls may move farther.
LoopSpec thoroughLoop()
{
  LoopSpec spec;
  spec.rules.objective.saturation = 0;
  spec.rules.objective.distance = 0.03;
  spec.rules.objective.sharpEdge = 50;
  spec.rules.objective.mostLost = 10;
  spec.rules.objective.mostMoved = 0.25;
  spec.rules.objective.mostDrift = 0.08;
  spec.search.edges = 9;
  spec.search.neighbours = 4;
  spec.search.nodes = 4;
  spec.search.cuts = 4;
  spec.search.cutsAlongFaces = true;
  spec.search.cutsFailing = true;
  spec.search.enough = 0.9;
  spec.search.removedShare = 0.05;
  spec.leastCost = 4;
  return spec;
}

// For faces that fail even then: what only is poor counts little, what is left of the wall there may give way, last of all
// whole cells.
LoopSpec lastLoop()
{
  LoopSpec spec = thoroughLoop();
  spec.rules.objective.saturation = ObjectiveSpec().saturation;
  spec.rules.objective.failing = 200;
  spec.rules.objective.sharpEdge = 20;
  spec.rules.objective.mostLost = HUGE_VAL;
  spec.rules.objective.mostMoved = 0.55;
  spec.rules.objective.mostDrift = 0.2;
  spec.search.removedShare = 0.1;
  spec.search.longestEdge = 1.5;
  spec.search.neighbours = 6;
  spec.failingOnly = true;
  spec.leastGain = 0.005;
  spec.leastGainOfMove = 0.005;
  return spec;
}

// Walls that stay cost much however large cells are: then only small ones merge.
double mostMergedOf(const ImprovementSpec& asked, double usual)
{
  return !asked.merges() ? 0 : asked.mayChangeWalls ? usual : asked.smallShare;
}

// All of them, as far as is asked for.
struct Loops
{
  explicit Loops(const ImprovementSpec& asked)
    : removes(asked.removesCells)
  {
    thorough.failingOnly = !asked.mayChangeWalls;
    for (LoopSpec* spec : { &general, &thorough, &last })
    {
      spec->rules.mayChangeWalls = asked.mayChangeWalls;
      spec->rules.mostMerged = mostMergedOf(asked, spec->rules.mostMerged);
      spec->rules.mayCut = asked.cuts;
      spec->search.longestEdge = asked.collapseRatio > 0 ? spec->search.longestEdge : 0;
      spec->search.nodes = asked.movesNodes ? spec->search.nodes : 0;
      spec->search.removedShare = asked.removesCells ? spec->search.removedShare : 0;
    }
  }

  bool removes;
  LoopSpec general;
  LoopSpec thorough = thoroughLoop();
  LoopSpec last = lastLoop();
};

constexpr double LongestSnapped = 0.5; // in boxes

// From here on a face may cost thoroughLoop()'s leastCost, with costs in full.
constexpr double MuchCost = 3.5;

// What faces cost by another specification. Those of a zone that cost next to nothing cost the same.
void rescaleCosts(const ZoneTask& task, const ObjectiveSpec& from, const ObjectiveSpec& to)
{
  constexpr double NextToNothing = 1e-3;
  MeshEditor& mesh = task.mesh;
  for (const Items cells : { task.zone, mesh.madeCells() })
  {
    for (const std::uint32_t c : cells)
    {
      for (std::size_t i = 0; mesh.isFree(c) && i < mesh.cell(c).faces.size; ++i)
      {
        const std::uint32_t f = mesh.facesOf(c)[i];
        EditFace& face = mesh.rawFace(f);
        const bool isFirst = face.below == c || !mesh.isFree(face.below);
        if (isFirst && face.cost > NextToNothing)
        {
          face.cost = costBy(mesh, f, to, from);
        }
      }
    }
  }
}

void append(std::vector<MadeEdit>& all, const std::vector<MadeEdit>& more)
{
  all.insert(all.end(), more.begin(), more.end());
}

// Where any face needs it; costs are as before afterwards.
void improveFailing(const ZoneTask& task, const Loops& loops, const std::function<void()>& poll,
  std::vector<MadeEdit>& edits)
{
  const ObjectiveSpec& usual = loops.general.rules.objective;
  bool isAny = false;
  task.forEachFace([&](std::uint32_t f) { isAny = isAny || task.mesh.face(f).cost > MuchCost; });
  if (isAny)
  {
    const ObjectiveSpec& thorough = loops.thorough.rules.objective;
    const ObjectiveSpec& last = loops.last.rules.objective;
    rescaleCosts(task, usual, thorough);
    append(edits, improve(task, loops.thorough, poll));
    rescaleCosts(task, thorough, last);
    append(edits, improve(task, loops.last, poll));
    rescaleCosts(task, last, usual);
  }
}

std::vector<std::uint32_t> refusedCells(EditMesh& whole, Execution& execution)
{
  constexpr std::size_t CellsAChunk = 1024;
  std::vector<std::vector<std::uint32_t>> ofChunks(chunks(whole.cells.size(), CellsAChunk));
  execution.forEach(whole.cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    const MeshView mesh(whole);
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c)
    {
      if (!mesh.cell(c).gone && !mesh.isGhost(c) && isRefused(mesh, c))
      {
        ofChunks[begin / CellsAChunk].push_back(c);
      }
    }
  });
  return concatenated(ofChunks);
}

// Refused cells that touch themselves, and those around that do, may change from now on.
void thaw(EditMesh& whole, const std::vector<std::uint32_t>& refused)
{
  MeshEditor mesh(whole, 0, 0, {});
  for (const std::uint32_t c : refused)
  {
    mesh.forEachCellAround(c, [&](std::uint32_t other) {
      if (mesh.cell(other).state == CellState::Frozen)
      {
        mesh.rawCell(other).state = CellState::Free;
        setCostOfCell(mesh, other);
      }
    });
  }
}

// What the last step made poor: as all else, so that nothing fails that did not.
void improveMade(const ZoneTask& task, const Loops& loops, const std::function<void()>& poll,
  std::vector<MadeEdit>& edits)
{
  const MeshEditor& mesh = task.mesh;
  const Items made = mesh.madeCells();
  std::vector<std::uint32_t> poor;
  for (const Items cells :
    { Items{ task.cells.data(), task.cells.data() + task.cells.size() }, made })
  {
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(poor), [&](std::uint32_t c) {
      const Items faces = mesh.facesOf(c);
      return mesh.isFree(c) && std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        return mesh.face(f).fails > 0;
      });
    });
  }
  if (!poor.empty())
  {
    const ZoneTask again{ task.mesh, poor, task.zone, task.isDone };
    append(edits, improve(again, loops.general, poll));
    improveFailing(again, loops, poll, edits);
  }
  const std::vector<std::uint32_t> all(mesh.madeCells().begin(), mesh.madeCells().end());
  mergeOrRemoveSmallCells(
    { task.mesh, all, task.zone, task.isDone }, loops.general.rules, loops.removes, edits);
}

// Whatever solvers still refuse.
void endAll(EditMesh& whole, Loops loops, Execution& execution, std::vector<MadeEdit>& edits)
{
  for (LoopSpec* spec : { &loops.general, &loops.thorough, &loops.last })
  {
    spec->rules.mayTrade = false;
  }
  constexpr int Rounds = 5;
  const auto poll = [&] { execution.poll(); };
  std::vector<RemovedPiece> removed;
  std::mutex mutex;
  for (int round = 0; round < Rounds; ++round)
  {
    const std::vector<std::uint32_t> cells = refusedCells(whole, execution);
    if (cells.empty())
    {
      return;
    }
    thaw(whole, cells);
    std::vector<RemovedPiece> all = removed;
    editInGroups(whole, execution, cells, [&](const ZoneTask& task) {
      std::vector<MadeEdit> ofZone;
      std::vector<RemovedPiece> pieces = removed;
      endRefusals(task, loops.general.rules, loops.removes, pieces, ofZone, poll);
      if (round + 1 < Rounds)
      {
        improveMade(task, loops, poll, ofZone);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      edits.insert(edits.end(), ofZone.begin(), ofZone.end());
      all.insert(all.end(), pieces.begin() + std::ptrdiff_t(removed.size()), pieces.end());
    });
    removed = std::move(all);
    std::sort(removed.begin(), removed.end());
  }
}

}

std::vector<MadeEdit> improveWall(
  MeshEditor& mesh, const ImprovementSpec& spec, Execution& execution)
{
  EditMesh& whole = mesh.mesh();
  const Loops loops(spec);
  const LoopSpec& general = loops.general;
  const auto poll = [&] { execution.poll(); };
  const auto pay = [&] {
    if (spec.trueVolume)
    {
      redistributeVolume(whole, general.rules.objective, execution);
    }
  };
  whole.wantedShare = spec.smallShare * Wanted::ShareByRatio;
  whole.small = spec.small;
  SnapSpec snap;
  snap.length = std::min(3 * spec.collapseRatio, LongestSnapped);
  std::mutex mutex;
  std::vector<MadeEdit> edits;
  costAll(whole, general.rules.objective, execution);
  editInZones(whole, execution, [&](const ZoneTask& task) {
    if (spec.improves() && (spec.mayChangeWalls || spec.collapseRatio > 0))
    {
      simplifyWalls(task, SimplificationSpec(), general.rules, poll);
    }
    snapEdges(task, general.rules, snap, poll);
  });
  if (!spec.improves())
  {
    append(edits, removeFlatFaces(whole, general.rules, execution));
    return edits;
  }
  pay();
  editInZones(
    whole, execution,
    [&](const ZoneTask& task) {
      std::vector<MadeEdit> ofZone;
      if (!spec.mayChangeWalls)
      {
        mergeOrRemoveSmallCells(task, general.rules, false, ofZone); // what edges could not take
      }
      append(ofZone, improve(task, general, poll));
      improveFailing(task, loops, poll, ofZone);
      mergeOrRemoveSmallCells(task, general.rules, spec.removesCells, ofZone);
      const std::lock_guard<std::mutex> lock(mutex);
      edits.insert(edits.end(), ofZone.begin(), ofZone.end());
    },
    true);
  if (spec.movesNodes)
  {
    centreWalls(whole, general.rules.objective, execution);
  }
  pay();
  if (spec.mayChangeWalls)
  {
    endAll(whole, loops, execution, edits);
  }
  separateNodes(whole, general.rules.objective, execution);
  append(edits, removeFlatFaces(whole, general.rules, execution));
  sortAll(edits, execution); // zones end in any order
  return edits;
}

}
