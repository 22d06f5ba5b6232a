// SPDX-License-Identifier: BSD-3-Clause
// Proxies of writers that the window needs more of.
#pragma once

class vtkSMProxy;

namespace cartesian
{

// Called when the plugin is loaded. From then on there are
//
// - <RememberingWriterProxy>, a PWriterProxy of OpenFOAM cases whose properties are at first, in the window, those that the
//   same mesh was last written with, for this session, or the proposed ones (CaseProposal.h); a property with the hint NotRemembered
//   has its default;
// - <RefusingWriterProxy>, which writes nothing and says what to save instead.
void registerWriterProxies();

// Gives a writer the settings that the same mesh was last written with; false: it was not.
bool recallSettings(vtkSMProxy* writer);

}
