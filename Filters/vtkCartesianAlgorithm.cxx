// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianAlgorithm.h"

#include "Legend.h"
#include "ReportErrors.h"
#include "StopRequests.h"

#include "Base/Recording.h"

#include "vtkAbstractArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <utility>

static_assert(
  cartesian::errorCode(cartesian::Fault::EmptySurface) == vtkCartesianAlgorithm::EmptySurface);
static_assert(
  cartesian::errorCode(cartesian::Fault::CannotWrite) == vtkCartesianAlgorithm::CannotWrite);

namespace
{

// Does the work, recorded if the environment asks for it (Benchmark scaling).
void recordIfAsked(
  cartesian::Execution& execution, const std::function<void(cartesian::Execution&)>& work)
{
  const char* const file = std::getenv(cartesian::Recording::Variable);
  if (!file)
  {
    work(execution);
    return;
  }
  cartesian::Recording recording;
  execution.record(recording);
  work(execution);
  recording.end();
  std::ofstream stream(file, std::ios::app);
  recording.write(stream);
}

// Statistics are read by name; menus of arrays to colour by list dozens of them otherwise. Those of the input are
// another's.
void hideFields(vtkDataObject* output, vtkDataObject* input)
{
  vtkFieldData* const fields = output ? output->GetFieldData() : nullptr;
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = fields->GetAbstractArray(i);
    const bool isGiven = input && input->GetFieldData() && array->GetName() &&
      input->GetFieldData()->GetAbstractArray(array->GetName()) == array;
    if (!isGiven)
    {
      array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
    }
  }
}

}

bool vtkCartesianAlgorithm::Run(
  double begin, double end, const std::function<void(cartesian::Execution&)>& work)
{
  this->ErrorCode = vtkErrorCode::NoError; // SetErrorCode would make the filter run again
  const auto runIt = [&] {
    const auto monitor = [&](double fraction, const char* stage) {
      this->SetProgressText(stage);
      this->UpdateProgress(fraction);
      const bool stops =
        cartesian::isStopped(this) || (this->HasOtherFailed && this->HasOtherFailed());
      return this->IsWaitedFor || !stops;
    };
    cartesian::Execution execution(this->NumberOfThreads, monitor, begin, end);
    recordIfAsked(execution, work);
  };
  return cartesian::reportErrors(runIt, [this](unsigned long code, const std::string& message) {
    this->ErrorCode = code;
    this->TellWarnings();
    if (!message.empty())
    {
      vtkErrorMacro(<< message);
    }
  });
}

void vtkCartesianAlgorithm::Warn(const std::string& text)
{
  if (!text.empty() && !this->IsSilent)
  {
    this->Warnings.push_back(text);
  }
}

void vtkCartesianAlgorithm::TellWarnings()
{
  for (const std::string& text : std::exchange(this->Warnings, {}))
  {
    vtkWarningMacro(<< text);
    this->ToldWarnings.push_back(text);
  }
}

vtkTypeBool vtkCartesianAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    this->ToldWarnings.clear();
  }
  const vtkTypeBool done = this->Superclass::ProcessRequest(request, input, output);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    for (int port = 0; port < output->GetNumberOfInformationObjects(); ++port)
    {
      hideFields(vtkDataObject::GetData(output, port),
        this->GetNumberOfInputPorts() > 0 ? vtkDataObject::GetData(input[0], 0) : nullptr);
    }
  }
  this->TellWarnings();
  return done;
}

void vtkCartesianAlgorithm::AcceptAnything(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
}

int vtkCartesianAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  return IsLeftToFirstProcess(request, output) ? 1 : this->AskForWholeInputs(input);
}

int vtkCartesianAlgorithm::AskForWholeInputs(vtkInformationVector** input)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < input[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = input[port]->GetInformationObject(i);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

int vtkCartesianAlgorithm::AskForNeighbours(vtkInformationVector** input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = input[0]->GetInformationObject(0);
  if (info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) + 1);
  }
  return 1;
}

int vtkCartesianAlgorithm::GetNumberOfLegendArrays()
{
  std::vector<vtkDataObject*> outputs;
  vtkMTimeType time = 0;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs.push_back(this->GetOutputDataObject(port));
    time = std::max(time, outputs.back() ? outputs.back()->GetMTime() : 0);
  }
  if (time != this->LegendTime)
  {
    this->Legend = cartesian::legendOf(outputs);
    this->LegendTime = time;
  }
  return static_cast<int>(this->Legend.size());
}

const char* vtkCartesianAlgorithm::GetLegendArrayName(int i)
{
  return i >= 0 && i < this->GetNumberOfLegendArrays()
    ? this->Legend[static_cast<std::size_t>(i)].c_str()
    : nullptr;
}

int vtkCartesianAlgorithm::GetLegendArrayStatus(const char* name)
{
  this->GetNumberOfLegendArrays();
  return name && std::find(this->Legend.begin(), this->Legend.end(), name) != this->Legend.end()
    ? 1
    : 0;
}

vtkInformation* vtkCartesianAlgorithm::AskedOutput(
  vtkInformation* request, vtkInformationVector* output)
{
  const int asked = request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT());
  return output->GetInformationObject(asked < 0 ? 0 : asked);
}

bool vtkCartesianAlgorithm::IsLeftToFirstProcess(
  vtkInformation* request, vtkInformationVector* output)
{
  vtkInformation* info = AskedOutput(request, output);
  return info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) &&
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
}

void vtkCartesianAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
