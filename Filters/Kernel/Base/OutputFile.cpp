// SPDX-License-Identifier: BSD-3-Clause
#include "Base/OutputFile.h"

#include "Base/Error.h"

#include <cerrno>

namespace cartesian
{

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path path)
  : path_(std::move(path))
  , file_(path_, std::ios::binary)
{
}

void OutputFile::close()
{
  flush();
  file_.close();
  if (!file_)
  {
    throw Error(Fault::CannotWrite,
      "Cannot write " + path_.string() + " (" + std::strerror(errno) +
        "): choose another folder, or free disk space.");
  }
}

void OutputFile::flush()
{
  file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
}

namespace
{

void refuseFailure(const fs::path& path, std::error_code failure)
{
  if (failure)
  {
    throw Error(Fault::CannotWrite,
      "Cannot write " + path.string() + " (" + failure.message() + "): choose another name.");
  }
}

}

void replaceFiles(const std::vector<fs::path>& paths,
  const std::function<void(const std::vector<fs::path>& unfinished)>& write)
{
  std::error_code failure;
  std::vector<fs::path> unfinished = paths;
  for (fs::path& path : unfinished)
  {
    if (fs::is_directory(path, failure))
    {
      refuseFailure(path, std::make_error_code(std::errc::is_a_directory));
    }
    path += ".unfinished";
  }
  try
  {
    fs::create_directories(
      fs::absolute(paths.front()).parent_path(), failure); // if not, opening the file tells
    write(unfinished);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      fs::rename(unfinished[i], paths[i], failure);
      refuseFailure(paths[i], failure);
    }
  }
  catch (...)
  {
    for (const fs::path& path : unfinished)
    {
      fs::remove(path, failure);
    }
    throw;
  }
}

}
