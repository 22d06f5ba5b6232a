// SPDX-License-Identifier: BSD-3-Clause
// What the entities of a STEP or IGES file say by themselves.
#pragma once

#include "CadPart.h"

#include <TopoDS_TShape.hxx>

#include <map>

class Interface_InterfaceModel;
class XSControl_WorkSession;

namespace cartesian
{

// Names of solids and faces, by what all instances of a part share.
using NamesOfShapes = std::map<const TopoDS_TShape*, std::string>;

// Of a STEP file: the reader's own way to get them (read.stepcaf.subshapes.name) crashes on some files. Faces of which
// nothing could be made are told.
NamesOfShapes namesOfShapes(const Handle(XSControl_WorkSession) & session, const CadReport& report);

// What is wrong in the file itself, before shapes are made of it: Open CASCADE may crash on that.
void noteDamage(const Handle(Interface_InterfaceModel) & model, const CadReport& report);

// Warns of what is wrong in an IGES file if it is geometry of which nothing could be made.
void tellLostGeometry(const Handle(XSControl_WorkSession) & session, const CadReport& report);

}
