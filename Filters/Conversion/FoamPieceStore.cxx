// SPDX-License-Identifier: BSD-3-Clause
#include "FoamPieceStore.h"

#include "Base/Error.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace cartesian
{

namespace
{

// Calls visit(vector) for all that is stored.
template <class Piece, class Visitor>
void forEachVector(Piece& piece, Visitor&& visit)
{
  visit(piece.mesh.points);
  visit(piece.mesh.start);
  visit(piece.mesh.corners);
  visit(piece.mesh.owner);
  visit(piece.mesh.neighbour);
  visit(piece.points);
  visit(piece.boundaries);
  visit(piece.regions.ofCell);
}

[[noreturn]] void fail(const std::filesystem::path& file)
{
  throw Error(Fault::CannotWrite,
    "Cannot store a piece of the mesh in " + file.string() + " (" + std::strerror(errno) +
      "): choose another folder, or free disk space.");
}

}

FoamPieceStore::FoamPieceStore(const FoamPiece& piece, std::filesystem::path file)
  : file_(std::move(file))
{
  std::error_code ignored; // the stream will tell
  std::filesystem::create_directories(file_.parent_path(), ignored);
  std::ofstream stream(file_, std::ios::binary);
  const auto write = [&](const void* data, std::size_t bytes) {
    stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  };
  for (const std::size_t number :
    { piece.firstCell, piece.mesh.cellCount, piece.regions.names.size() })
  {
    write(&number, sizeof(number));
  }
  for (const std::string& name : piece.regions.names)
  {
    const std::size_t length = name.size();
    write(&length, sizeof(length));
    write(name.data(), length);
  }
  forEachVector(piece, [&](const auto& vector) {
    const std::size_t size = vector.size();
    write(&size, sizeof(size));
    write(vector.data(), size * sizeof(vector[0]));
  });
  stream.close();
  if (!stream)
  {
    const int reason = errno;
    std::filesystem::remove(file_);
    errno = reason;
    fail(file_);
  }
}

FoamPieceStore::FoamPieceStore(FoamPieceStore&& other) noexcept
  : file_(std::move(other.file_))
{
  other.file_.clear();
}

FoamPieceStore::~FoamPieceStore()
{
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

FoamPiece FoamPieceStore::load() const
{
  std::ifstream stream(file_, std::ios::binary);
  const auto read = [&](void* data, std::size_t bytes) {
    stream.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes));
    if (!stream)
    {
      fail(file_);
    }
  };
  const auto readSize = [&] {
    std::size_t size = 0;
    read(&size, sizeof(size));
    return size;
  };
  FoamPiece piece{};
  piece.firstCell = readSize();
  piece.mesh.cellCount = readSize();
  piece.regions.names.resize(readSize());
  for (std::string& name : piece.regions.names)
  {
    name.resize(readSize());
    read(name.data(), name.size());
  }
  forEachVector(piece, [&](auto& vector) {
    vector.resize(readSize());
    read(vector.data(), vector.size() * sizeof(vector[0]));
  });
  return piece;
}

}
