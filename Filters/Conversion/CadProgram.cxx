// SPDX-License-Identifier: BSD-3-Clause
#include "CadProgram.h"

#include "Base/Error.h"
#include "Base/Execution.h"

#include "vtksys/Process.h"
#include "vtksys/SystemTools.hxx"

#include <array>
#include <csignal>
#include <memory>
#include <optional>
#include <utility>

#include <dlfcn.h>

namespace cartesian
{

namespace
{

constexpr double SecondsBetweenLooks = 0.1; // whether the user stops it

// vtksysProcess_Delete alone waits for the end.
void end(vtksysProcess* process)
{
  vtksysProcess_Kill(process);
  vtksysProcess_Delete(process);
}

using Process = std::unique_ptr<vtksysProcess, decltype(&end)>;

// vtksysProcess takes the signals that end this program, and then waits for all its children, also for those that others have
// started and that never end, such as MPI's. Once this is gone, they do what they did before.
class KeptSignals
{
public:
  KeptSignals()
  {
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      sigaction(Signals[i], nullptr, &actions_[i]);
    }
  }
  ~KeptSignals()
  {
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      sigaction(Signals[i], &actions_[i], nullptr);
    }
  }
  KeptSignals(const KeptSignals&) = delete;
  KeptSignals& operator=(const KeptSignals&) = delete;

private:
  static constexpr std::array<int, 2> Signals{ SIGINT, SIGTERM };
  std::array<struct sigaction, 2> actions_;
};

// Records out of what came through the pipe so far.
class Records
{
public:
  void add(const char* data, int size) { bytes_.insert(bytes_.end(), data, data + size); }

  // Calls take(record, unpacker) for those that are whole.
  template <typename Take>
  void takeAll(Take&& take)
  {
    constexpr std::size_t Head = 1 + sizeof(std::uint64_t);
    while (bytes_.size() - at_ >= Head)
    {
      std::uint64_t size = 0;
      std::memcpy(&size, bytes_.data() + at_ + 1, sizeof size);
      if (bytes_.size() - at_ - Head < size)
      {
        break;
      }
      take(static_cast<Record>(bytes_[at_]),
        Unpacker(bytes_.data() + at_ + Head, static_cast<std::size_t>(size)));
      at_ += Head + static_cast<std::size_t>(size);
    }
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = 0;
  }

private:
  std::vector<char> bytes_;
  std::size_t at_ = 0;
};

// What the records say.
class Answer
{
public:
  void take(Record record, Unpacker values, Execution& execution)
  {
    const auto text = [&] {
      std::string sentence;
      values.get(sentence);
      return sentence;
    };
    switch (record)
    {
      case Record::Progress:
      {
        double done = 0;
        values.get(done);
        execution.reach(done);
        return;
      }
      case Record::Note:
        content.notes.push_back(text());
        return;
      case Record::Warning:
        content.warnings.push_back(text());
        return;
      case Record::Damage:
        damage = text();
        return;
      case Record::Error:
        error = text();
        return;
      case Record::Names:
        values.get(content.boundaries);
        return;
      case Record::Solid:
        content.solids.emplace_back().visit([&](auto& value) { values.get(value); });
        return;
      case Record::End:
        isWhole = true;
        return;
    }
    throw std::runtime_error("a record is of no kind");
  }

  CadContent content;
  std::string error;
  std::string damage;
  bool isWhole = false;
};

// Why there is no result.
std::string faultOf(
  vtksysProcess* process, const std::string& damage, const std::string& file, double timeLimit)
{
  const std::string found = damage.empty() ? "" : " " + damage;
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Expired:
      return file + " is not read after " + number(timeLimit) +
        " s, the Time Limit: it is damaged, or large." + found +
        " Set a longer Time Limit, choose a larger "
        "Deflection, or export the part again.";
    case vtksysProcess_State_Error:
      return std::string("The program that reads CAD files cannot be started (") +
        vtksysProcess_GetErrorString(process) + ").";
    case vtksysProcess_State_Exception:
      return file + " cannot be read: Open CASCADE crashes on it (" +
        vtksysProcess_GetExceptionString(process) + ")." + found +
        " Export the part again, or in another format.";
    default:
      return file +
        " cannot be read: the program that reads CAD files ended early. Export the part again.";
  }
}

void listen(vtksysProcess* process, Answer& answer, Execution& execution)
{
  Records records;
  for (;;)
  {
    char* data = nullptr;
    int size = 0;
    double wait = SecondsBetweenLooks;
    const int pipe = vtksysProcess_WaitForData(process, &data, &size, &wait);
    execution.poll();
    if (pipe == vtksysProcess_Pipe_None)
    {
      return;
    }
    if (pipe == vtksysProcess_Pipe_STDOUT)
    {
      records.add(data, size);
      records.takeAll(
        [&](Record record, const Unpacker& values) { answer.take(record, values, execution); });
    }
  }
}

}

std::string cadProgram()
{
  Dl_info library{};
  dladdr(reinterpret_cast<const void*>(&cadProgram), &library);
  const std::string folder = vtksys::SystemTools::GetFilenamePath(
    vtksys::SystemTools::GetRealPath(library.dli_fname ? library.dli_fname : ""));
  return vtksys::SystemTools::CollapseFullPath(CARTESIANMESHER_READ_CAD, folder);
}

CadContent runCadProgram(
  const std::vector<std::string>& arguments, double timeLimit, Execution& execution)
{
  const std::string program = cadProgram();
  if (!vtksys::SystemTools::FileExists(program, true))
  {
    throw Error(Fault::CannotRead,
      "CAD files are read by the program " + program +
        ", which is not there: install the package cartesianmesher-cad, or build "
        "CartesianMesher with Open CASCADE.");
  }
  std::vector<const char*> words{ program.c_str() };
  for (const std::string& argument : arguments)
  {
    words.push_back(argument.c_str());
  }
  words.push_back(nullptr);
  const Process process(vtksysProcess_New(), &end);
  vtksysProcess_SetCommand(process.get(), words.data());
  vtksysProcess_SetTimeout(process.get(), timeLimit > 0 ? timeLimit : -1);
  {
    const KeptSignals signals;
    vtksysProcess_Execute(process.get());
  }
  Answer answer;
  listen(process.get(), answer, execution);
  vtksysProcess_WaitForExit(process.get(), nullptr);
  if (!answer.error.empty())
  {
    throw Error(Fault::CannotRead, answer.error);
  }
  if (!answer.isWhole)
  {
    throw Error(
      Fault::CannotRead, faultOf(process.get(), answer.damage, arguments.front(), timeLimit));
  }
  return std::move(answer.content);
}

}
