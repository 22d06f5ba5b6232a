// SPDX-License-Identifier: BSD-3-Clause
// How the quality of a mesh is shown at first: colours and charts; and the button that shows failing cells.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a representation that is new to a view is coloured by the measure that
// is worst, which its source names in a property, if the hint of its port says so:
//
//   <WorstMeasure port="0" property="WorstMeasure"/>
//
// A chart is over the column that the axis's title begins with, with logarithmic numbers of cells:
//
//   <Chart port="0" title="AxisTitle"/>
//
// And a button is a property that shows the cells of another port, which it names in a hint of the source:
//
//   <ShowCells property="ShowFailingCells" port="2"/>
//
// What else the source shows is looked through then, other sources are hidden, and the camera goes to the cells; a
// message says so if there are none. States keep the colours that they were saved with.
void watchQuality();

}
