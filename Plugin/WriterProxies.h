// SPDX-License-Identifier: BSD-3-Clause
// Proxies of writers that the window needs more of.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on there are
//
// - <RememberingWriterProxy>, a PWriterProxy whose properties are at first, in the window, those that were last written
//   with, for this session; a property with the hint NotRemembered has its default;
// - <RefusingWriterProxy>, which writes nothing and says what to save instead.
void registerWriterProxies();

}
