// SPDX-License-Identifier: BSD-3-Clause
// Task files of the present settings: File > Save Data, .toml.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on there are proxies <TaskWriterProxy>.
void registerTaskWriter();

}
