#include "io/writers/kretz_writer.h"

#include <bit>
#include <cstdint>
#include <stdexcept>

#include "io/kretz/kretz_items.h"
#include "io/kretz/kretz_tags.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

/// Appends the lowest `count` bytes of a number, lowest first.
void append(std::string& bytes, std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(number >> (8 * i) & 0xFF));
}

void appendHeader(std::string& bytes, KretzTag tag, std::uint64_t length) {
    append(bytes, tag.group, 2);
    append(bytes, tag.element, 2);
    append(bytes, length, 4);
}

void appendWhole(std::string& bytes, KretzTag tag, std::int64_t number) {
    appendHeader(bytes, tag, 2);
    append(bytes, static_cast<std::uint64_t>(number), 2);
}

void appendNumbers(std::string& bytes, KretzTag tag, const std::vector<double>& numbers) {
    appendHeader(bytes, tag, 8 * numbers.size());
    for (const double number : numbers) append(bytes, std::bit_cast<std::uint64_t>(number), 8);
}

void appendVoxels(std::string& bytes, const std::vector<std::uint8_t>& voxels) {
    bytes.append(reinterpret_cast<const char*>(voxels.data()), voxels.size());
}

void requireWritable(const PolarGeometry& polar, const std::vector<std::vector<std::uint8_t>>& phases) {
    const auto size = polar.size();
    if (problemOf(polar) || kindOf(polar) != PolarKind::wobbler)
        throw std::invalid_argument("kretzBytes: the geometry is not that of a wobbler");
    constexpr std::int64_t most = 65535;
    if (size[0] > most || size[1] > most || size[2] > most) throw std::invalid_argument("kretzBytes: too large");
    const auto voxels = static_cast<std::uint64_t>(size[0] * size[1] * size[2]);
    if (phases.empty() || voxels * phases.size() > UINT32_MAX)
        throw std::invalid_argument("kretzBytes: no or too many phases");
    for (const auto& phase : phases)
        if (phase.size() != voxels) throw std::invalid_argument("kretzBytes: a phase has another size");
}

}  // namespace

std::string kretzBytes(const PolarGeometry& polar, const std::vector<std::vector<std::uint8_t>>& phases) {
    requireWritable(polar, phases);
    const auto size = polar.size();
    // The file counts in samples from the axis of the lines. It knows no face of the probe.
    const double firstSample = (polar.lines.radiusMm + polar.rangeStartMm) / polar.rangeStepMm;
    const double planesAxis = (polar.planes.radiusMm - polar.lines.radiusMm) / polar.rangeStepMm;
    std::vector<double> lines = polar.lines.values, planes = polar.planes.values;
    for (double& angle : lines) angle += kretz::straightOn;
    for (double& angle : planes) angle = kretz::straightOn - angle;

    std::string bytes(kretzSignature);
    appendWhole(bytes, kretz::samples, size[0]);
    appendWhole(bytes, kretz::lines, size[1]);
    appendWhole(bytes, kretz::planes, size[2]);
    appendNumbers(bytes, kretz::resolution, {polar.rangeStepMm / 1000});
    appendNumbers(bytes, kretz::firstSample, {firstSample});
    appendNumbers(bytes, kretz::planesAxis, {planesAxis});
    appendNumbers(bytes, kretz::planeAngles, planes);
    appendNumbers(bytes, kretz::lineAngles, lines);
    appendHeader(bytes, kretz::voxels, phases.front().size());
    appendVoxels(bytes, phases.front());
    if (phases.size() > 1) {
        appendHeader(bytes, kretz::sequenceVoxels, phases.front().size() * phases.size());
        for (const auto& phase : phases) appendVoxels(bytes, phase);
    }
    appendHeader(bytes, kretz::end, 0);
    return bytes;
}

Result<void> writeKretz(const std::string& path, const PolarGeometry& polar,
                        const std::vector<std::vector<std::uint8_t>>& phases) {
    return writeFileAtomically(path, kretzBytes(polar, phases));
}

}  // namespace echolucent
