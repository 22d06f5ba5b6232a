// Surfaces in the folder Data.
#pragma once

#include "Support/Shapes.h"

namespace cartesian
{

// STL in ASCII, whose solids are boundaries, or OBJ.
NamedShape readData(const std::string& name);

}
