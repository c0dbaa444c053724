// How a person wants a file to be read if the file itself does not say it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "processing/scan_conversion/conversion_grid.h"
#include "processing/scan_conversion/polar_geometry.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// The layout of a headerless raw file. Once a person has given it, it is kept beside the file as FILE.echolucent.json.
struct RawLayout {
    std::array<std::int64_t, 3> size{0, 0, 0};  ///< voxels along x (fastest), y and z; samples, lines, planes if polar
    std::string type = "uint8";                 ///< uint8, int8, uint16, int16, uint32, int32, float32, float64
    bool bigEndian = false;
    std::int64_t headerBytes = 0;  ///< bytes before the first voxel
    Vec3 spacing{1, 1, 1};         ///< mm
    bool spacingKnown = false;     ///< false if `spacing` is only assumed
    /// The geometry of samples along beams, with as many samples, lines and planes as `size` says. `spacing` has no
    /// meaning then. No value: the voxels lie on a Cartesian grid.
    std::optional<PolarGeometry> polar{};
    friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

/// What a person may say about reading a file.
struct ReadOptions {
    std::optional<RawLayout> raw;  ///< for files without a known header
    bool framesAsSlices = false;   ///< take the frames of a multi-frame file without volume geometry as slices
    bool guessNoData = true;  ///< mark the outside of the scanned sector as no data (guessDataMask), unless the file
                              ///< says what is no data
    std::string series{};     ///< SeriesEntry::uid of the series to read from a folder; empty: the first listed
    /// MiB for the voxels of one phase if polar voxels are converted to a Cartesian grid; at least 1.
    std::int64_t conversionMebibytes = standardConversionBytes >> 20;
    /// MiB for the voxels of all phases, from 1 to mostStudyMebibytes. Larger studies are opened reduced. No value: as
    /// much as this machine can show.
    std::optional<std::int64_t> studyMebibytes{};
    /// Black is 0 whatever the values are, and what lies below is black too, as in documents that were saved before
    /// black could lie elsewhere. Values with which the file states black itself are no exception.
    bool blackAtZero = false;
    friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

/// The largest ReadOptions::studyMebibytes: an exbibyte.
constexpr std::int64_t mostStudyMebibytes = std::int64_t{1} << 40;

}  // namespace echolucent
