// --reduction NAME: how quiet the voxels are that a picture is taken from.
#pragma once

#include <string>

#include "processing/result.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

struct ReductionOption {
    std::string name{nameOf(defaultSpeckleReduction)};

    /// `what` says what the option does, as the help has it.
    void addTo(CLI::App& command, const std::string& what);
    /// Fails (wrong usage) where no reduction has the name.
    [[nodiscard]] Result<SpeckleReduction> get() const;
};

}  // namespace echolucent::cli
