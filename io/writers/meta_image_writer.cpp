#include "io/writers/meta_image_writer.h"

#include <optional>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "io/output/atomic_file.h"
#include "io/writers/deflate_stream.h"
#include "io/writers/file_values.h"

namespace echolucent {

namespace {

std::string plain(const std::vector<std::shared_ptr<const Volume>>& phases) {
    std::string bytes;
    for (const auto& phase : phases)
        addFileValues(*phase, [&](std::span<const std::uint8_t> values) {
            bytes.append(reinterpret_cast<const char*>(values.data()), values.size());
        });
    return bytes;
}

std::string compressed(const std::vector<std::shared_ptr<const Volume>>& phases) {
    DeflateStream compressor(DeflateFormat::zlib);
    for (const auto& phase : phases)
        addFileValues(*phase,
                      [&](std::span<const std::uint8_t> values) { compressor.add(values.data(), values.size()); });
    return compressor.finish();
}

/// The transform matrix as text: its rows are the grid axes' directions. A time axis is independent of them.
std::string matrixText(const Mat3& direction, int dimensions) {
    std::string text;
    for (int axis = 0; axis < dimensions; ++axis)
        for (int row = 0; row < dimensions; ++row) {
            const bool space = axis < 3 && row < 3;
            text += fmt::format(" {}", space ? direction(row, axis) : (axis == row ? 1.0 : 0.0));
        }
    return text;
}

const char* typeName(StoredType type) {
    switch (type) {
        case StoredType::uint8: return "MET_UCHAR";
        case StoredType::uint16: return "MET_USHORT";
        case StoredType::int16: return "MET_SHORT";
        case StoredType::int32: return "MET_INT";
        case StoredType::float64: return "MET_DOUBLE";
        default: return "MET_FLOAT";
    }
}

/// `compressedBytes` is not set for plain voxels.
std::string headerText(const Volume& volume, std::size_t phases, std::optional<std::size_t> compressedBytes) {
    const VolumeGeometry& geometry = volume.geometry();
    const bool moving = phases > 1;
    const int dimensions = moving ? 4 : 3;
    std::string text = "ObjectType = Image\n";
    text += fmt::format("NDims = {}\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = {}\n",
                        dimensions, compressedBytes ? "True" : "False");
    if (compressedBytes) text += fmt::format("CompressedDataSize = {}\n", *compressedBytes);
    text += fmt::format("TransformMatrix ={}\n", matrixText(geometry.direction, dimensions));
    text += fmt::format("Offset = {} {} {}{}\n", geometry.origin[0], geometry.origin[1], geometry.origin[2],
                        moving ? " 0" : "");
    text += fmt::format("ElementSpacing = {} {} {}{}\n", geometry.spacing[0], geometry.spacing[1], geometry.spacing[2],
                        moving ? " 1" : "");
    if (!geometry.spacingKnown) text += "SpacingKnown = False\n";
    text += fmt::format("DimSize = {} {} {}", geometry.size[0], geometry.size[1], geometry.size[2]);
    text += moving ? fmt::format(" {}\n", phases) : "\n";
    if (!volume.valueScale().isIdentity()) text += fmt::format("BlackLevel = {}\n", volume.blackValue());
    text += fmt::format("WhiteLevel = {}\n", volume.whiteValue());
    return text + fmt::format("ElementType = {}\nElementDataFile = LOCAL\n", typeName(typeOfFileValues(volume)));
}

}  // namespace

Result<void> writeMetaImage(const std::string& path, const std::vector<std::shared_ptr<const Volume>>& phases,
                            MetaImageVoxels voxels) {
    if (phases.empty()) throw std::invalid_argument("writeMetaImage: no volume");
    for (const auto& phase : phases)
        if (!canBeWrittenTogether(*phase, *phases.front()))
            throw std::invalid_argument("writeMetaImage: phases of different size, type or scale");
    const bool isPlain = voxels == MetaImageVoxels::plain;
    const std::string body = isPlain ? plain(phases) : compressed(phases);
    std::string bytes =
        headerText(*phases.front(), phases.size(), isPlain ? std::nullopt : std::optional<std::size_t>(body.size()));
    bytes += body;
    return writeFileAtomically(path, bytes);
}

}  // namespace echolucent
