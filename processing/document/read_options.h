// How a person says that a file is to be read, where the file does not say it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "processing/scan_conversion/conversion_grid.h"
#include "processing/scan_conversion/polar_geometry.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// How a headerless raw file is laid out. Once a person has said it, it is kept beside the file as
/// FILE.echolucent.json.
struct RawLayout {
    std::array<std::int64_t, 3> size{0, 0, 0};  ///< voxels along x (fastest), y and z; samples, lines, planes if polar
    std::string type = "uint8";                 ///< uint8, int8, uint16, int16, uint32, int32, float32, float64
    bool bigEndian = false;
    std::int64_t headerBytes = 0;  ///< bytes before the first voxel
    Vec3 spacing{1, 1, 1};         ///< mm
    bool spacingKnown = false;     ///< false where `spacing` is only assumed
    /// Where the voxels are samples along beams: their geometry, of as many samples, lines and planes as `size` says.
    /// `spacing` has no meaning then. No value where they lie on a Cartesian grid.
    std::optional<PolarGeometry> polar{};
    friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

/// What a person may say about how a file is to be read.
struct ReadOptions {
    std::optional<RawLayout> raw;  ///< for files that are neither MetaImage, NRRD nor DICOM
    bool framesAsSlices = false;   ///< take the frames of a multi-frame file without volume geometry as slices
    bool guessNoData = true;       ///< mark the outside of the scanned sector as no data (guessDataMask)
    std::string series{};          ///< SeriesEntry::uid of the series of a folder to be read; empty: the first listed
    /// MiB that the voxels of one phase may take where polar voxels are converted to a Cartesian grid; at least 1.
    std::int64_t conversionMebibytes = standardConversionBytes >> 20;
    /// MiB that the voxels of all phases may take, from 1 to mostStudyMebibytes; larger studies are opened reduced. No
    /// value: as much as this machine can show.
    std::optional<std::int64_t> studyMebibytes{};
    friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

/// No study may be allowed more MiB than this, an exbibyte.
constexpr std::int64_t mostStudyMebibytes = std::int64_t{1} << 40;

}  // namespace echolucent
