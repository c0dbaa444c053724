// The options that state the geometry of polar voxels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "processing/result.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace CLI {
class App;
}

namespace echolucent::cli {

/// --raw-polar, --raw-range, --raw-lines, --raw-planes and --raw-radius, as they are written.
struct PolarOptions {
    std::string kind, range, lines, planes, radius;
    void addTo(CLI::App& command);
    [[nodiscard]] bool any() const;
    /// The geometry of `size` samples, lines and planes; no value if none of the options is given. Fails (wrong usage)
    /// if an option is missing, superfluous for the kind or no number, or if the geometry makes no sense.
    [[nodiscard]] Result<std::optional<PolarGeometry>> get(const std::array<std::int64_t, 3>& size) const;
};

/// The kind of probe with this name. Fails (wrong usage), naming `option`, if there is none.
[[nodiscard]] Result<PolarKind> polarKindOf(const std::string& name, const std::string& option);

}  // namespace echolucent::cli
