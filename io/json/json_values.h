// Values that stand in more than one kind of JSON file.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_fields.h"
#include "processing/document/read_options.h"
#include "processing/opacity_curve.h"

namespace echolucent {

/// The nodes of a manual curve as a list of {"intensity": ..., "opacity": ...}.
[[nodiscard]] nlohmann::ordered_json manualCurveJson(const ManualCurve& curve);
/// The curve whose nodes stand under a key: at least one, intensities and opacities in [0,1], no intensity below the
/// one before it.
[[nodiscard]] ManualCurve manualCurveIn(JsonFields& fields, const char* key);

/// {"range_start_mm": ..., "range_step_mm": ..., "lines": {...}, "planes": {...}}, where lines and planes are
/// {"positions_mm": [...]} or {"angles_radians": [...], "radius_mm": ...}.
[[nodiscard]] nlohmann::ordered_json polarJson(const PolarGeometry& polar);
/// The geometry that an object holds, of so many samples. Whether it makes sense is asked where it is used
/// (problemOf()).
[[nodiscard]] PolarGeometry polarIn(JsonFields fields, std::int64_t samples);

/// {"size": [x, y, z], "type": ..., "byte_order": ..., "header_bytes": ..., "spacing_mm": [...], "spacing_known": ...},
/// and "polar" (polarJson()) where the voxels are samples along beams.
[[nodiscard]] nlohmann::ordered_json rawLayoutJson(const RawLayout& layout);
/// The layout that an object holds. Only the size must be there; what else is missing has its default.
[[nodiscard]] RawLayout rawLayoutIn(JsonFields& fields);

}  // namespace echolucent
