// A simulated scan of a wobbler: its sector is wide, and dim at the border.
#pragma once

#include <optional>

#include "processing/phantom/phantom.h"
#include "processing/scan_conversion/conversion_grid.h"
#include "processing/scan_conversion/polar_geometry.h"
#include "processing/scan_conversion/scan_conversion.h"

namespace echolucent {

/// The scan of a phantom, sampled along the beams of a wobbler of 80 by 76 degrees, and converted.
inline Volume scanOfWobbler(const PhantomConfig& config) {
    const PolarGeometry polar =
        polarGeometry({PolarKind::wobbler, 0, 1, {-40, 40}, {-38, 38}, 39.6, 24.75}, config.size);
    const ConversionGrid grid = conversionGrid(polar);
    const ScanConversion conversion(polar, grid);
    const auto sampled = makePolarPhantom(configOnGrid(config, grid), polar, grid);
    return Volume(grid.geometry, *conversion.convert(*sampled), std::nullopt).withDataMask(conversion.mask());
}

}  // namespace echolucent
