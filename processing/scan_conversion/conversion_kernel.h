// The inner loop of the scan conversion, many voxels at once. Highway compiles it for each instruction set. Products
// and sums are separate, so that every instruction set gives the same bits.
#pragma once

#include <cstdint>

#include "processing/scan_conversion/line_lookup.h"

namespace echolucent {

/// The common values of one row of the grid.
template <typename Value>
struct ConversionRow {
    const LineLookup* lines = nullptr;
    bool angular = false;    ///< whether lines stand at angles
    float firstMm = 0;       ///< x of the row's voxel 0, probe mm
    float spacingMm = 1;     ///< from a voxel to the next
    float alongMm = 0;       ///< depth within the plane: from the axis of the lines, or from the face if there is none
    float rangeStartMm = 0;  ///< of the first sample, from the same axis or face
    float samplesPerMm = 1;
    float planeShare = 0;      ///< [0,1] between the two planes
    std::int32_t samples = 2;  ///< along a line; also the distance of one line from the next
    std::int32_t lineCount = 2;
    const Value* nearPlane = nullptr;
    const Value* farPlane = nullptr;
    /// Whether to read samples one by one, because the two bytes after the last one of `farPlane` are not readable.
    bool endsHere = false;
};

/// Interpolates the voxels [first, end) of a row into out[first] to out[end - 1]. Bytes and words are rounded.
void convertRun(const ConversionRow<std::uint8_t>& row, std::int32_t first, std::int32_t end, std::uint8_t* out);
void convertRun(const ConversionRow<std::uint16_t>& row, std::int32_t first, std::int32_t end, std::uint16_t* out);
void convertRun(const ConversionRow<float>& row, std::int32_t first, std::int32_t end, float* out);

}  // namespace echolucent
