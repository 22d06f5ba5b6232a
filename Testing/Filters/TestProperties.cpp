// Setting a property to what it is must not make the pipeline run again, changing it must.
#include "vtkCartesianMesher.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

TEST(Properties, MeshlinesOfEachAxisAreKeptApart)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfMeshlinesX(2);
  mesher->SetMeshlineX(1, 1.5);
  mesher->SetNumberOfMeshlinesZ(1);
  mesher->SetMeshlineZ(0, -3.0);
  EXPECT_EQ(mesher->GetNumberOfMeshlines(0), 2);
  EXPECT_EQ(mesher->GetNumberOfMeshlines(1), 0);
  EXPECT_EQ(mesher->GetNumberOfMeshlines(2), 1);
  EXPECT_EQ(mesher->GetMeshline(0, 1), 1.5);
  EXPECT_EQ(mesher->GetMeshline(2, 0), -3.0);
}

TEST(Properties, OnlyAChangeModifies)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfMeshlinesY(2);
  mesher->SetMeshlineY(1, 2.5);
  const vtkMTimeType before = mesher->GetMTime();
  mesher->SetNumberOfMeshlinesY(2);
  mesher->SetMeshlineY(1, 2.5);
  mesher->SetBoundaryArray("");
  EXPECT_EQ(mesher->GetMTime(), before);
  mesher->SetMeshlineY(1, 3.5);
  EXPECT_GT(mesher->GetMTime(), before);
}

TEST(Properties, NegativeThreadsAndMemoryBecomeAutomatic)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfThreads(-4);
  mesher->SetMemoryLimit(-1.0);
  EXPECT_EQ(mesher->GetNumberOfThreads(), 0);
  EXPECT_EQ(mesher->GetMemoryLimit(), 0.0);
}
