#pragma once

#include "app/report.h"
#include "app/staged_outputs.h"
#include "morskin/pipeline.h"

namespace morskin::app {

/// The options of the pipeline that a command line means. Notes in the report the step of marching
/// cubes and, as it runs, the growth of the dynamic method.
/// @param arguments, outputs, report  must outlive the run
morskin::MeshingOptions options_of(const morskin::PreparedSkin& skin,
                                   const MeshArguments& arguments, StagedOutputs& outputs,
                                   MeshReport& report);

}  // namespace morskin::app
