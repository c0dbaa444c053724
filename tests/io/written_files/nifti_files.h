// NIfTI headers for tests, field by field, in either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace echolucent {

/// The fields of a NIfTI header under their own names. By default it is a volume of 2 x 3 x 4 bytes, 0.5 x 0.25 x 2 mm,
/// without a frame.
struct NiftiFields {
    int version = 1;
    bool bigEndian = false;
    bool apart = false;  ///< magic "ni": voxels in a file of their own
    std::vector<std::int64_t> dim{3, 2, 3, 4};
    std::vector<double> pixdim{1, 0.5, 0.25, 2};
    int datatype = 2, bitpix = 8;
    int intent = 0;
    double voxOffset = -1;  ///< -1: where the voxels begin
    double slope = 0, inter = 0, calMax = 0, calMin = 0, toffset = 0;
    int units = 2;
    int qformCode = 0, sformCode = 0;
    std::array<double, 3> quatern{}, qoffset{};
    std::array<std::array<double, 4>, 3> srow{};
};

/// The bytes of that header. If the voxels follow it, also the four bytes before them.
inline std::string niftiHeader(const NiftiFields& fields) {
    const bool two = fields.version == 2;
    const std::size_t length = two ? 540 : 348;
    std::string bytes(length + 4, '\0');
    const auto put = [&](std::size_t offset, auto value) {
        std::string raw(sizeof value, '\0');
        std::memcpy(raw.data(), &value, sizeof value);
        if (fields.bigEndian) std::reverse(raw.begin(), raw.end());
        bytes.replace(offset, raw.size(), raw);
    };
    const auto number = [&](std::size_t one, std::size_t other, double value) {
        two ? put(other, value) : put(one, static_cast<float>(value));
    };
    put(0, static_cast<std::int32_t>(length));
    for (std::size_t i = 0; i < 8; ++i) {
        const std::int64_t size = i < fields.dim.size() ? fields.dim[i] : 1;
        two ? put(16 + 8 * i, size) : put(40 + 2 * i, static_cast<std::int16_t>(size));
        const double step = i < fields.pixdim.size() ? fields.pixdim[i] : 0;
        number(76 + 4 * i, 104 + 8 * i, step);
    }
    put(two ? 12 : 70, static_cast<std::int16_t>(fields.datatype));
    put(two ? 14 : 72, static_cast<std::int16_t>(fields.bitpix));
    const double offset = fields.voxOffset >= 0 || fields.voxOffset < -1 || fields.voxOffset != fields.voxOffset
                              ? fields.voxOffset
                              : (fields.apart ? 0.0 : static_cast<double>(length + 4));
    two ? put(168, static_cast<std::int64_t>(offset)) : put(108, static_cast<float>(offset));
    number(112, 176, fields.slope);
    number(116, 184, fields.inter);
    number(124, 192, fields.calMax);
    number(128, 200, fields.calMin);
    number(136, 216, fields.toffset);
    two ? put(500, static_cast<std::int32_t>(fields.units)) : put(123, static_cast<std::uint8_t>(fields.units));
    two ? put(504, static_cast<std::int32_t>(fields.intent)) : put(68, static_cast<std::int16_t>(fields.intent));
    two ? put(344, static_cast<std::int32_t>(fields.qformCode)) : put(252, static_cast<std::int16_t>(fields.qformCode));
    two ? put(348, static_cast<std::int32_t>(fields.sformCode)) : put(254, static_cast<std::int16_t>(fields.sformCode));
    for (std::size_t i = 0; i < 3; ++i) {
        number(256 + 4 * i, 352 + 8 * i, fields.quatern[i]);
        number(268 + 4 * i, 376 + 8 * i, fields.qoffset[i]);
        for (std::size_t k = 0; k < 4; ++k) number(280 + 16 * i + 4 * k, 400 + 32 * i + 8 * k, fields.srow[i][k]);
    }
    const std::string magic = std::string(fields.apart ? "ni" : "n+") + (two ? std::string("2\0\r\n\x1a\n", 6) : "1");
    bytes.replace(two ? 4 : 344, magic.size(), magic);
    if (fields.apart) bytes.resize(length);
    return bytes;
}

/// The values 1 to 24.
template <typename T>
std::vector<T> twentyFour() {
    std::vector<T> values(24);
    std::iota(values.begin(), values.end(), T{1});
    return values;
}
/// The same as bytes: the voxels of the default header.
inline const std::string countedVoxels = bytesFrom(twentyFour<std::uint8_t>());

/// Reads a file of that header and those voxels.
inline Result<Study> readFields(const NiftiFields& fields, const std::string& bytes = countedVoxels,
                                ReadOptions options = {}) {
    const TemporaryFolder folder;
    options.guessNoData = false;
    return readStudy(folder.write("v.nii", niftiHeader(fields) + bytes), options);
}

}  // namespace echolucent
