// Reads and writes values that more than one kind of JSON file holds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_fields.h"
#include "processing/document/read_options.h"
#include "processing/opacity_curve.h"

namespace echolucent {

/// The nodes of a manual curve as a list of {"intensity": ..., "opacity": ...}.
[[nodiscard]] nlohmann::ordered_json manualCurveJson(const ManualCurve& curve);
/// The curve with the nodes under a key: at least one, intensities and opacities in [0,1], intensities never falling.
[[nodiscard]] ManualCurve manualCurveIn(JsonFields& fields, const char* key);

/// {"range_start_mm": ..., "range_step_mm": ..., "lines": {...}, "planes": {...}}. Lines and planes are
/// {"positions_mm": [...]} or {"angles_radians": [...], "radius_mm": ...}.
[[nodiscard]] nlohmann::ordered_json polarJson(const PolarGeometry& polar);
/// The geometry in an object, for this number of samples. The geometry is checked only where it is used (problemOf()).
[[nodiscard]] PolarGeometry polarIn(JsonFields fields, std::int64_t samples);

/// {"size": [x, y, z], "type": ..., "byte_order": ..., "header_bytes": ..., "spacing_mm": [...], "spacing_known": ...},
/// and "polar" (polarJson()) if the voxels are samples along beams.
[[nodiscard]] nlohmann::ordered_json rawLayoutJson(const RawLayout& layout);
/// The layout in an object. Only "size" must be there; all else has a default.
[[nodiscard]] RawLayout rawLayoutIn(JsonFields& fields);

}  // namespace echolucent
