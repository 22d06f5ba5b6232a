// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallImprovement.h"

#include "Base/Sorting.h"
#include "Editing/EditBlocks.h"
#include "Editing/EditMeasures.h"
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

// How much is edited at once, as measured: where cells only are simplified, or cost a bit, edits reach no farther than two
// boxes; what fails takes four (three leave twice as much of it). Wide blocks have fewer cells around them, small ones wait
// for less; walls that are simplified in small ones lean more.
constexpr std::uint32_t AnyWeight = ~std::uint32_t(0);
constexpr EditBlockSize SimplifiedAtOnce{ 16, 2, AnyWeight, 0 };
constexpr EditBlockSize ImprovedAtOnce{ 8, 2, 200 };
constexpr EditBlockSize MendedAtOnce{ 8, 4, AnyWeight };

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

// In order.
template <class Predicate>
std::vector<std::uint32_t> findCells(
  const EditMesh& whole, Execution& execution, Predicate&& isWanted)
{
  constexpr std::size_t CellsAChunk = 1024;
  std::vector<std::vector<std::uint32_t>> ofChunks(chunks(whole.cells.size(), CellsAChunk));
  execution.forEach(whole.cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    const MeshView mesh(whole);
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c)
    {
      if (!mesh.cell(c).gone && !mesh.isGhost(c) && isWanted(mesh, c))
      {
        ofChunks[begin / CellsAChunk].push_back(c);
      }
    }
  });
  return concatenated(ofChunks);
}

// Whether the loops find anything to do in it.
bool isPoor(const MeshView& mesh, std::uint32_t c, double leastCost)
{
  const Items faces = mesh.facesOf(c);
  return mesh.cell(c).cost > leastCost || isSmallCell(mesh, c) ||
    std::any_of(
      faces.begin(), faces.end(), [&](std::uint32_t f) { return mesh.face(f).cost > leastCost; });
}

bool hasFailingFace(const MeshView& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  return std::any_of(
    faces.begin(), faces.end(), [&](std::uint32_t f) { return mesh.face(f).fails > 0; });
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
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(poor),
      [&](std::uint32_t c) { return mesh.isFree(c) && hasFailingFace(mesh, c); });
  }
  if (!poor.empty())
  {
    const ZoneTask again = task.with(poor);
    append(edits, improve(again, loops.general, poll));
    improveFailing(again, loops, poll, edits);
  }
  const std::vector<std::uint32_t> all(mesh.madeCells().begin(), mesh.madeCells().end());
  mergeOrRemoveSmallCells(task.with(all), loops.general.rules, loops.removes, edits);
}

class WallImprover
{
public:
  WallImprover(EditMesh& whole, const ImprovementSpec& spec, Execution& execution)
    : whole_(whole)
    , spec_(spec)
    , execution_(execution)
    , poll_([&] { execution.poll(); })
    , loops_(spec)
    , blocks_(whole, execution)
  {
  }

  std::vector<MadeEdit> run()
  {
    simplify();
    if (spec_.improves())
    {
      pay();
      improvePoor();
      mend();
      if (spec_.movesNodes)
      {
        centreWalls(whole_, usual(), execution_);
      }
      pay();
      if (spec_.mayChangeWalls)
      {
        endAll();
      }
    }
    blocks_.finish();
    if (spec_.improves())
    {
      separateNodes(whole_, usual(), execution_);
    }
    keep(removeFlatFaces(whole_, loops_.general.rules, execution_));
    sortAll(edits_, execution_); // blocks end in any order
    return std::move(edits_);
  }

private:
  const ObjectiveSpec& usual() const { return loops_.general.rules.objective; }

  void keep(const std::vector<MadeEdit>& ofBlock)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    append(edits_, ofBlock);
  }

  void pay()
  {
    if (spec_.trueVolume)
    {
      redistributeVolume(whole_, usual(), execution_);
    }
  }

  void simplify()
  {
    SnapSpec snap;
    snap.length = std::min(3 * spec_.collapseRatio, LongestSnapped);
    blocks_.edit(SimplifiedAtOnce, [&](const ZoneTask& task) {
      if (spec_.improves() && (spec_.mayChangeWalls || spec_.collapseRatio > 0))
      {
        simplifyWalls(task, SimplificationSpec(), loops_.general.rules, poll_);
      }
      snapEdges(task, loops_.general.rules, snap, poll_);
    });
  }

  std::vector<std::uint32_t> poorCells(double leastCost)
  {
    return findCells(whole_, execution_,
      [&](const MeshView& mesh, std::uint32_t c) { return isPoor(mesh, c, leastCost); });
  }

  void improvePoor()
  {
    blocks_.edit(poorCells(loops_.general.leastCost), ImprovedAtOnce, [&](const ZoneTask& task) {
      std::vector<MadeEdit> edits;
      if (!spec_.mayChangeWalls)
      {
        mergeSmall(task, false, edits); // what edges could not take
      }
      append(edits, improve(task, loops_.general, poll_));
      keep(edits);
    });
  }

  // What still costs much; then what fails even so, with its surroundings as they are by then.
  void mend()
  {
    blocks_.edit(poorCells(MuchCost), MendedAtOnce, [&](const ZoneTask& task) {
      std::vector<MadeEdit> edits;
      improveFailing(task, loops_, poll_, edits);
      mergeSmall(task, spec_.removesCells, edits);
      keep(edits);
    });
    constexpr int Looks = 2;
    for (int look = 0; look < Looks; ++look)
    {
      blocks_.edit(
        findCells(whole_, execution_, hasFailingFace), MendedAtOnce, [&](const ZoneTask& task) {
          std::vector<MadeEdit> edits = improve(task, loops_.general, poll_);
          improveFailing(task, loops_, poll_, edits);
          mergeSmall(task, spec_.removesCells, edits);
          keep(edits);
        });
    }
  }

  void mergeSmall(const ZoneTask& task, bool removes, std::vector<MadeEdit>& edits) const
  {
    mergeOrRemoveSmallCells(task, loops_.general.rules, removes, edits);
  }

  // Whatever solvers still refuse.
  void endAll()
  {
    constexpr int Rounds = 5;
    Loops loops = loops_;
    for (LoopSpec* spec : { &loops.general, &loops.thorough, &loops.last })
    {
      spec->rules.mayTrade = false;
    }
    std::vector<RemovedPiece> removed;
    for (int round = 0; round < Rounds; ++round)
    {
      const std::vector<std::uint32_t> cells = findCells(whole_, execution_, isRefused);
      if (cells.empty())
      {
        return;
      }
      thaw(whole_, cells);
      std::vector<RemovedPiece> all = removed;
      blocks_.edit(cells, MendedAtOnce, [&](const ZoneTask& task) {
        std::vector<MadeEdit> edits;
        std::vector<RemovedPiece> pieces = removed;
        endRefusals(task, loops.general.rules, loops.removes, pieces, edits, poll_);
        if (round + 1 < Rounds)
        {
          improveMade(task, loops, poll_, edits);
        }
        keep(edits);
        const std::lock_guard<std::mutex> lock(mutex_);
        all.insert(all.end(), pieces.begin() + std::ptrdiff_t(removed.size()), pieces.end());
      });
      removed = std::move(all);
      std::sort(removed.begin(), removed.end());
    }
  }

  EditMesh& whole_;
  const ImprovementSpec& spec_;
  Execution& execution_;
  const std::function<void()> poll_;
  const Loops loops_;
  BlockEditing blocks_;
  std::mutex mutex_; // of
  std::vector<MadeEdit> edits_;
};

}

std::vector<MadeEdit> improveWall(
  MeshEditor& mesh, const ImprovementSpec& spec, Execution& execution)
{
  EditMesh& whole = mesh.mesh();
  whole.wantedShare = spec.smallShare * Wanted::ShareByRatio;
  whole.small = spec.small;
  costAll(whole, Loops(spec).general.rules.objective, execution);
  return WallImprover(whole, spec, execution).run();
}

}
