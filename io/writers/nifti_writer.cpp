#include "io/writers/nifti_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "io/nifti/nifti_header.h"
#include "io/output/atomic_file.h"
#include "io/study/study_assembly.h"
#include "io/writers/deflate_stream.h"
#include "io/writers/file_values.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

constexpr std::size_t headerBytes = 348, voxelOffset = 352;
constexpr std::int16_t scannerFrame = 1;

/// A header whose fields are written at byte offsets, little endian like this machine.
class HeaderWriter {
public:
    template <typename T>
    void put(std::size_t offset, T value) {
        std::memcpy(m_bytes.data() + offset, &value, sizeof value);
    }
    void putFloat(std::size_t offset, double value) { put(offset, static_cast<float>(value)); }
    /// Writes a text of less than 80 bytes.
    void putText(std::size_t offset, const std::string& text) { m_bytes.replace(offset, text.size(), text); }
    [[nodiscard]] std::string text() const { return m_bytes; }

private:
    std::string m_bytes = std::string(voxelOffset, '\0');
};

/// The unit quaternion (a, b, c, d) of a rotation, a at least 0.
std::array<double, 4> quaternionOf(const Mat3& rotation) {
    const auto r = [&](int row, int column) { return rotation(row, column); };
    // The largest of the four is found first, so that nothing is divided by a small number.
    const std::array<double, 4> squares{1 + r(0, 0) + r(1, 1) + r(2, 2), 1 + r(0, 0) - r(1, 1) - r(2, 2),
                                        1 - r(0, 0) + r(1, 1) - r(2, 2), 1 - r(0, 0) - r(1, 1) + r(2, 2)};
    const auto largest = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    const double twice = std::sqrt(squares[largest]);
    const double ab = (r(2, 1) - r(1, 2)) / twice / 2, ac = (r(0, 2) - r(2, 0)) / twice / 2,
                 ad = (r(1, 0) - r(0, 1)) / twice / 2, bc = (r(0, 1) + r(1, 0)) / twice / 2,
                 bd = (r(0, 2) + r(2, 0)) / twice / 2, cd = (r(1, 2) + r(2, 1)) / twice / 2;
    std::array<double, 4> quaternion{};
    switch (largest) {
        case 0: quaternion = {twice / 2, ab, ac, ad}; break;
        case 1: quaternion = {ab, twice / 2, bc, bd}; break;
        case 2: quaternion = {ac, bc, twice / 2, cd}; break;
        default: quaternion = {ad, bd, cd, twice / 2}; break;
    }
    if (quaternion[0] < 0)
        for (double& part : quaternion) part = -part;
    return quaternion;
}

void putFrame(HeaderWriter& header, const VolumeGeometry& geometry) {
    const Mat3 rasFromLps = Mat3::diag({-1, -1, 1});
    Mat3 direction = rasFromLps * geometry.direction;
    const Vec3 origin = rasFromLps * geometry.origin;
    // A quaternion holds no skew, so only sform is written then.
    const bool skew = !skewWarning(geometry.direction).empty();
    header.put(252, static_cast<std::int16_t>(skew ? 0 : scannerFrame));
    header.put(254, scannerFrame);
    for (int row = 0; row < 3; ++row) {
        const auto place = static_cast<std::size_t>(row);
        for (int axis = 0; axis < 3; ++axis)
            header.putFloat(280 + 16 * place + 4 * static_cast<std::size_t>(axis),
                            direction(row, axis) * geometry.spacing[axis]);
        header.putFloat(280 + 16 * place + 12, origin[row]);
        header.putFloat(268 + 4 * place, origin[row]);
    }
    if (skew) return;
    // A quaternion cannot mirror: qfac -1 reverses the third axis.
    const double qfac = cv::determinant(direction) < 0 ? -1.0 : 1.0;
    for (int row = 0; row < 3; ++row) direction(row, 2) *= qfac;
    const auto quaternion = quaternionOf(direction);
    header.putFloat(76, qfac);
    for (std::size_t i = 0; i < 3; ++i) header.putFloat(256 + 4 * i, quaternion[i + 1]);
}

std::int16_t typeCode(StoredType type) {
    switch (type) {
        case StoredType::uint8: return 2;
        case StoredType::uint16: return 512;
        case StoredType::int16: return 4;
        case StoredType::int32: return 8;
        case StoredType::float64: return 64;
        default: return 16;
    }
}

/// Puts black and white, if the header's float32 holds them closely. If not, readers find them in the data.
void putLevels(HeaderWriter& header, const Volume& volume) {
    const double black = volume.blackValue(), white = volume.whiteValue();
    const auto isHeld = [&](double level) {
        const auto held = static_cast<double>(static_cast<float>(level));
        return std::isfinite(held) && std::abs(held - level) <= 1e-6 * (white - black);
    };
    if (!isHeld(black) || !isHeld(white)) return;
    header.putFloat(124, white);
    header.putFloat(128, black);
    header.putText(
        148, niftiWhiteText(static_cast<float>(black), static_cast<float>(white), nameOf(typeOfFileValues(volume))));
}

std::string headerOf(const Volume& volume, std::size_t phases, std::optional<double> phaseSeconds) {
    constexpr std::uint8_t unitMm = 2, unitSeconds = 8;
    const VolumeGeometry& geometry = volume.geometry();
    HeaderWriter header;
    header.put(0, static_cast<std::int32_t>(headerBytes));
    header.put(38, 'r');
    header.put(40, static_cast<std::int16_t>(phases > 1 ? 4 : 3));
    for (std::size_t axis = 0; axis < 7; ++axis) {
        const std::int64_t size = axis < 3 ? geometry.size[axis] : axis == 3 ? static_cast<std::int64_t>(phases) : 1;
        header.put(42 + 2 * axis, static_cast<std::int16_t>(size));
    }
    const StoredType type = typeOfFileValues(volume);
    header.put(70, typeCode(type));
    header.put(72, static_cast<std::int16_t>(8 * bytesOf(type)));
    for (std::size_t axis = 0; axis < 3 && geometry.spacingKnown; ++axis)
        header.putFloat(80 + 4 * axis, geometry.spacing[static_cast<int>(axis)]);
    if (phases > 1 && phaseSeconds) header.putFloat(92, *phaseSeconds);
    header.putFloat(108, voxelOffset);
    header.putFloat(112, 1.0);  // scl_slope
    header.put(123, static_cast<std::uint8_t>(geometry.spacingKnown ? unitMm | unitSeconds : unitSeconds));
    putLevels(header, volume);
    if (geometry.spacingKnown) putFrame(header, geometry);
    header.put(344, std::array<char, 4>{'n', '+', '1', '\0'});
    return header.text();
}

}  // namespace

Result<void> writeNifti(const std::string& path, const std::vector<std::shared_ptr<const Volume>>& phases,
                        std::optional<double> phaseSeconds) {
    if (phases.empty()) throw std::invalid_argument("writeNifti: no volume");
    for (const auto& phase : phases)
        if (!canBeWrittenTogether(*phase, *phases.front()))
            throw std::invalid_argument("writeNifti: phases of different size, type or scale");
    constexpr std::int64_t longest = std::numeric_limits<std::int16_t>::max();
    const auto& size = phases.front()->geometry().size;
    if (*std::max_element(size.begin(), size.end()) > longest || phases.size() > static_cast<std::size_t>(longest))
        return fail(FailureKind::unwritable, path, "",
                    fmt::format("cannot be NIfTI-1, which counts to {} along an axis", longest),
                    "Write a MetaImage (.mha).");
    const std::string header = headerOf(*phases.front(), phases.size(), phaseSeconds);
    const auto addVoxels = [&](const auto& add) {
        for (const auto& phase : phases)
            addFileValues(*phase, [&](std::span<const std::uint8_t> values) { add(values.data(), values.size()); });
    };
    if (!lowerCase(path).ends_with(".gz")) {
        std::string bytes = header;
        addVoxels([&](const std::uint8_t* values, std::size_t count) {
            bytes.append(reinterpret_cast<const char*>(values), count);
        });
        return writeFileAtomically(path, bytes);
    }
    DeflateStream stream(DeflateFormat::gzip);
    stream.add(reinterpret_cast<const std::uint8_t*>(header.data()), header.size());
    addVoxels([&](const std::uint8_t* values, std::size_t count) { stream.add(values, count); });
    return writeFileAtomically(path, stream.finish());
}

}  // namespace echolucent
