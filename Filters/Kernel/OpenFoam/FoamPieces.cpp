// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamPieces.h"

#include "Base/BoundaryIndex.h"
#include "Base/Error.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

// An open face of any piece.
struct Place
{
  std::size_t piece;
  std::size_t face;
};

// Two places of one face, the owner's first.
struct Link
{
  Place owner;
  Place other;
};

class Linker
{
public:
  explicit Linker(const std::vector<FoamOutline>& outlines)
    : outlines_(outlines)
  {
  }

  std::vector<Link> run()
  {
    std::vector<Link> links;
    const std::vector<Named> faces = sortedFaces();
    for (auto begin = faces.begin(); begin != faces.end();)
    {
      const auto end = std::find_if(
        begin, faces.end(), [&](const Named& face) { return face.corners != begin->corners; });
      // A wall without thickness in a cell is two faces of one piece.
      if (end - begin == 2 && begin[0].place.piece != begin[1].place.piece)
      {
        links.push_back({ begin[0].place, begin[1].place });
        checkOrientation(links.back());
      }
      else if (end - begin > 2)
      {
        refuse(begin->place);
      }
      begin = end;
    }
    return links;
  }

private:
  struct Named
  {
    std::vector<std::int32_t> corners; // ascending
    Place place;
  };

  const FoamOutline::OpenFace& at(const Place& place) const
  {
    return outlines_[place.piece].openFaces[place.face];
  }

  const std::int32_t* cornersOf(const Place& place) const
  {
    return outlines_[place.piece].corners.data() + at(place).firstCorner;
  }

  // By corners, then by piece.
  std::vector<Named> sortedFaces() const
  {
    std::vector<Named> faces;
    for (std::size_t piece = 0; piece < outlines_.size(); ++piece)
    {
      for (std::size_t face = 0; face < outlines_[piece].openFaces.size(); ++face)
      {
        const Place place{ piece, face };
        faces.push_back({ { cornersOf(place), cornersOf(place) + at(place).cornerCount }, place });
        std::sort(faces.back().corners.begin(), faces.back().corners.end());
      }
    }
    std::sort(faces.begin(), faces.end(), [](const Named& a, const Named& b) {
      return std::tie(a.corners, a.place.piece, a.place.face) <
        std::tie(b.corners, b.place.piece, b.place.face);
    });
    return faces;
  }

  void checkOrientation(const Link& link) const
  {
    const std::int32_t* const a = cornersOf(link.owner);
    const std::int32_t* const b = cornersOf(link.other);
    const std::size_t count = at(link.owner).cornerCount;
    const auto isTurned = [&](std::size_t shift) {
      for (std::size_t i = 0; i < count; ++i)
      {
        if (a[i] != b[(shift + count - i) % count])
        {
          return false;
        }
      }
      return true;
    };
    for (std::size_t shift = 0; shift < count; ++shift)
    {
      if (isTurned(shift))
      {
        return;
      }
    }
    refuse(link.owner);
  }

  [[noreturn]] void refuse(const Place& place) const
  {
    throw Error(Fault::BadMesh,
      "A face of cell " + std::to_string(at(place).owner) +
        " is also a face of a cell of another piece on the same side: cells overlap. Write the "
        "mesh as it was before it was changed.");
  }

  const std::vector<FoamOutline>& outlines_;
};

void checkOrder(const std::vector<FoamOutline>& outlines)
{
  std::size_t cells = 0;
  for (const FoamOutline& outline : outlines)
  {
    if (outline.firstCell != cells)
    {
      throw Error(Fault::BadMesh,
        "The cells are not numbered in the order of the pieces: to write a decomposed case, save "
        "the output of Cartesian Mesher itself.");
    }
    cells += outline.cells;
  }
}

class Numbering
{
public:
  explicit Numbering(const std::vector<FoamOutline>& outlines)
    : outlines_(outlines)
    , links_(Linker(outlines).run())
    , result_(outlines.size())
  {
    for (std::size_t piece = 0; piece < outlines.size(); ++piece)
    {
      result_[piece].openFaces.resize(outlines[piece].openFaces.size());
    }
  }

  std::vector<FaceNumbers> run()
  {
    numberLinks();
    numberBoundaries();
    return std::move(result_);
  }

private:
  const FoamOutline::OpenFace& at(const Place& place) const
  {
    return outlines_[place.piece].openFaces[place.face];
  }

  FaceNumbers::OpenFace& resultAt(const Place& place)
  {
    return result_[place.piece].openFaces[place.face];
  }

  // In the order that the whole mesh has them; those of one piece lie among its inner faces.
  void numberLinks()
  {
    std::sort(links_.begin(), links_.end(), [this](const Link& a, const Link& b) {
      return std::make_tuple(at(a.owner).owner, at(a.other).owner, a.owner.face) <
        std::make_tuple(at(b.owner).owner, at(b.other).owner, b.owner.face);
    });
    auto link = links_.begin();
    for (std::size_t piece = 0; piece < outlines_.size(); ++piece)
    {
      result_[piece].firstInner = innerFaces_;
      std::size_t ofPiece = 0;
      for (; link != links_.end() && link->owner.piece == piece; ++link, ++ofPiece)
      {
        const FoamOutline::OpenFace& face = at(link->owner);
        const std::size_t number = innerFaces_ + face.innerFacesUntil + ofPiece;
        const std::int32_t corner = outlines_[piece].corners[face.firstCorner];
        resultAt(
          link->owner) = { link->other.piece, number, corner, false, at(link->other).region };
        resultAt(link->other) = { piece, number, corner, true, face.region };
      }
      innerFaces_ += outlines_[piece].innerFaces + ofPiece;
    }
  }

  void numberBoundaries()
  {
    // Of each boundary, how many faces each piece has.
    std::map<std::int32_t, std::vector<std::size_t>> counts;
    std::vector<std::size_t> open(outlines_.size());
    for (std::size_t piece = 0; piece < outlines_.size(); ++piece)
    {
      for (const auto& [boundary, count] : outlines_[piece].boundaries)
      {
        counts.try_emplace(boundary, outlines_.size()).first->second[piece] = count;
      }
      const auto& faces = result_[piece].openFaces;
      open[piece] = static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(),
        [](const FaceNumbers::OpenFace& face) { return face.piece == FaceNumbers::None; }));
    }
    std::size_t next = innerFaces_;
    const auto append = [&](std::int32_t boundary, const std::vector<std::size_t>& ofPieces) {
      for (std::size_t piece = 0; piece < ofPieces.size(); ++piece)
      {
        result_[piece].boundaries.push_back({ boundary, next, ofPieces[piece] });
        next += ofPieces[piece];
      }
    };
    for (const auto& [boundary, ofPieces] : counts)
    {
      append(boundary, ofPieces);
    }
    if (std::any_of(open.begin(), open.end(), [](std::size_t count) { return count > 0; }))
    {
      append(NoBoundary, open);
    }
    if (next >= std::numeric_limits<std::int32_t>::max())
    {
      throw Error(Fault::BadMesh,
        "The mesh has more faces than OpenFOAM can number in 32 bits: make it coarser.");
    }
  }

  const std::vector<FoamOutline>& outlines_;
  std::vector<Link> links_;
  std::size_t innerFaces_ = 0; // of the pieces so far
  std::vector<FaceNumbers> result_;
};

// Puts the open faces of a piece in order: those of no boundary, then those that other pieces have too.
class Completion
{
public:
  Completion(FoamPiece piece, std::size_t number, const FaceNumbers& numbers)
    : piece_(std::move(piece))
    , number_(number)
    , numbers_(numbers)
    , mesh_(piece_.mesh)
    , firstOpen_(mesh_.owner.size() - numbers.openFaces.size())
  {
  }

  CompletePiece run(std::vector<FoamPatch> patches)
  {
    numberFaces();
    sortOpenFaces();
    addressing_.points = std::move(piece_.points);
    addressing_.cells.resize(mesh_.cellCount);
    std::iota(addressing_.cells.begin(), addressing_.cells.end(),
      static_cast<std::int32_t>(piece_.firstCell));
    addressing_.patches.resize(patches.size());
    std::iota(addressing_.patches.begin(), addressing_.patches.end(), 0);
    mesh_.patches = std::move(patches);
    addProcessPatches();
    mesh_.addressing = std::move(addressing_);
    return { std::move(mesh_), std::move(piece_.regions) };
  }

private:
  // Of all but the open faces.
  void numberFaces()
  {
    std::vector<std::uint32_t> ownersOfLinks; // those before which inner faces of later owners come
    for (std::size_t i = 0; i < numbers_.openFaces.size(); ++i)
    {
      const FaceNumbers::OpenFace& face = numbers_.openFaces[i];
      if (face.piece != FaceNumbers::None && !face.isTurned)
      {
        ownersOfLinks.push_back(mesh_.owner[firstOpen_ + i]);
      }
    }
    std::sort(ownersOfLinks.begin(), ownersOfLinks.end());
    for (std::size_t i = 0, links = 0; i < mesh_.neighbour.size(); ++i)
    {
      while (links < ownersOfLinks.size() && ownersOfLinks[links] < mesh_.owner[i])
      {
        ++links;
      }
      addNumber(numbers_.firstInner + i + links, false);
    }
    for (const FaceNumbers::Boundary& boundary : numbers_.boundaries)
    {
      for (std::size_t i = 0; boundary.boundary != NoBoundary && i < boundary.count; ++i)
      {
        addNumber(boundary.first + i, false);
      }
    }
  }

  // Counted from one, negative if the whole mesh has the face reversed.
  void addNumber(std::size_t number, bool isTurned)
  {
    const auto label = static_cast<std::int32_t>(number + 1);
    addressing_.faces.push_back(isTurned ? -label : label);
  }

  void sortOpenFaces()
  {
    // Faces of no boundary stay in order: they are by owner, then by face, as in the whole mesh.
    std::size_t noBoundary = 0;
    if (!numbers_.boundaries.empty() && numbers_.boundaries.back().boundary == NoBoundary)
    {
      noBoundary = numbers_.boundaries.back().first;
    }
    std::vector<std::size_t> linked;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < numbers_.openFaces.size(); ++i)
    {
      const bool isLinked = numbers_.openFaces[i].piece != FaceNumbers::None;
      (isLinked ? linked : order).push_back(i);
      if (!isLinked)
      {
        addNumber(noBoundary++, false);
      }
    }
    std::sort(linked.begin(), linked.end(), [this](std::size_t a, std::size_t b) {
      const FaceNumbers::OpenFace& x = numbers_.openFaces[a];
      const FaceNumbers::OpenFace& y = numbers_.openFaces[b];
      return std::tie(x.piece, x.number) < std::tie(y.piece, y.number);
    });
    for (const std::size_t i : linked)
    {
      addNumber(numbers_.openFaces[i].number, numbers_.openFaces[i].isTurned);
      ++countOfPiece_[numbers_.openFaces[i].piece];
      piece_.regions.beyond.push_back(numbers_.openFaces[i].region);
    }
    order.insert(order.end(), linked.begin(), linked.end());
    rewriteOpenFaces(order);
  }

  void rewriteOpenFaces(const std::vector<std::size_t>& order)
  {
    const std::vector<std::size_t> start(
      mesh_.start.begin() + static_cast<std::ptrdiff_t>(firstOpen_), mesh_.start.end());
    const std::vector<std::uint32_t> owner(
      mesh_.owner.begin() + static_cast<std::ptrdiff_t>(firstOpen_), mesh_.owner.end());
    const std::vector<std::uint32_t> corners(
      mesh_.corners.begin() + static_cast<std::ptrdiff_t>(start.front()), mesh_.corners.end());
    mesh_.start.resize(firstOpen_ + 1);
    mesh_.owner.resize(firstOpen_);
    mesh_.corners.resize(start.front());
    for (const std::size_t i : order)
    {
      const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(start[i] - start.front());
      const auto end = corners.begin() + static_cast<std::ptrdiff_t>(start[i + 1] - start.front());
      const FaceNumbers::OpenFace& face = numbers_.openFaces[i];
      // Both pieces begin a face with the same corner.
      const auto corner = face.isTurned
        ? std::find_if(begin, end,
            [&](std::uint32_t point) { return piece_.points[point] == face.firstCorner; })
        : begin;
      std::rotate_copy(begin, corner, end, std::back_inserter(mesh_.corners));
      mesh_.start.push_back(mesh_.corners.size());
      mesh_.owner.push_back(owner[i]);
    }
  }

  void addProcessPatches()
  {
    for (const auto& [piece, count] : countOfPiece_)
    {
      FoamPatch patch{ "procBoundary" + std::to_string(number_) + "to" + std::to_string(piece),
        count };
      patch.processes = { static_cast<int>(number_), static_cast<int>(piece) };
      mesh_.patches.push_back(std::move(patch));
      addressing_.patches.push_back(-1);
    }
  }

  FoamPiece piece_;
  std::size_t number_;
  const FaceNumbers& numbers_;
  FoamMesh& mesh_;
  std::size_t firstOpen_;
  std::map<std::size_t, std::size_t> countOfPiece_; // faces in common with other pieces
  FoamAddressing addressing_;
};

}

std::vector<double> FoamOutline::toNumbers() const
{
  std::vector<double> numbers;
  const auto add = [&](auto number) { numbers.push_back(static_cast<double>(number)); };
  add(firstCell);
  add(cells);
  add(innerFaces);
  add(boundaries.size());
  for (const auto& [boundary, count] : boundaries)
  {
    add(boundary);
    add(count);
  }
  for (const OpenFace& face : openFaces)
  {
    add(face.owner);
    add(face.innerFacesUntil);
    add(face.cornerCount);
    add(face.region);
    std::for_each(corners.begin() + static_cast<std::ptrdiff_t>(face.firstCorner),
      corners.begin() + static_cast<std::ptrdiff_t>(face.firstCorner + face.cornerCount), add);
  }
  return numbers;
}

FoamOutline FoamOutline::fromNumbers(const std::vector<double>& numbers)
{
  FoamOutline outline;
  auto next = numbers.begin();
  const auto take = [&] { return static_cast<std::size_t>(*next++); };
  outline.firstCell = take();
  outline.cells = take();
  outline.innerFaces = take();
  outline.boundaries.resize(take());
  for (auto& [boundary, count] : outline.boundaries)
  {
    boundary = static_cast<std::int32_t>(*next++);
    count = take();
  }
  while (next != numbers.end())
  {
    const std::size_t owner = take();
    const std::size_t until = take();
    outline.openFaces.push_back({ owner, until, outline.corners.size(), take(), 0 });
    outline.openFaces.back().region = static_cast<std::uint32_t>(take());
    for (std::size_t i = 0; i < outline.openFaces.back().cornerCount; ++i)
    {
      outline.corners.push_back(static_cast<std::int32_t>(*next++));
    }
  }
  return outline;
}

FoamOutline outlineOf(const FoamPiece& piece)
{
  const FoamMesh& mesh = piece.mesh;
  FoamOutline outline;
  outline.firstCell = piece.firstCell;
  outline.cells = mesh.cellCount;
  outline.innerFaces = mesh.neighbour.size();
  outline.boundaries = piece.boundaries;
  std::size_t face = outline.innerFaces;
  for (const auto& [boundary, count] : piece.boundaries)
  {
    face += count;
  }
  const auto lastInner = mesh.owner.begin() + static_cast<std::ptrdiff_t>(outline.innerFaces);
  for (; face < mesh.owner.size(); ++face)
  {
    const auto until = std::upper_bound(mesh.owner.begin(), lastInner, mesh.owner[face]);
    outline.openFaces.push_back(
      { piece.firstCell + mesh.owner[face], static_cast<std::size_t>(until - mesh.owner.begin()),
        outline.corners.size(), mesh.start[face + 1] - mesh.start[face],
        piece.regions.ofCell.empty() ? 0 : piece.regions.ofCell[mesh.owner[face]] });
    for (std::size_t at = mesh.start[face]; at < mesh.start[face + 1]; ++at)
    {
      outline.corners.push_back(piece.points[mesh.corners[at]]);
    }
  }
  return outline;
}

std::vector<FaceNumbers> numberFaces(const std::vector<FoamOutline>& outlines)
{
  checkOrder(outlines);
  return Numbering(outlines).run();
}

CompletePiece completed(
  FoamPiece piece, std::size_t number, const FaceNumbers& numbers, std::vector<FoamPatch> patches)
{
  return Completion(std::move(piece), number, numbers).run(std::move(patches));
}

}
