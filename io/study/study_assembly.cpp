#include "io/study/study_assembly.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "io/study/study_facts.h"
#include "io/voxels/voxel_bytes.h"
#include "processing/intensity/no_data.h"
#include "processing/one_line.h"
#include "processing/volume/value_digits.h"
#include "processing/volume/white_level.h"

namespace echolucent {

namespace {

/// The stored value of white, if it is known, and its source.
struct ChosenWhite {
    std::optional<double> level;
    std::string source;
};

std::string windowNotTaken(const DisplayWindow& window, DeclaredWhite judged, const WhiteLevel& measured,
                           const ValueScale& scale) {
    const char* why = judged == DeclaredWhite::tooHigh
                          ? "the values in the data lie so far below it that the picture would be black"
                      : judged == DeclaredWhite::tooLow ? "most values in the data lie above it"
                      : judged == DeclaredWhite::suits  ? "no voxel can show it"
                                                        : "it is not above 0";
    const double reached = scale.fileValue(measured.level);
    const int digits = digitsToTell({scale.black, reached}, 6);
    return fmt::format(
        "The window of the file ({}) puts white at {:.{}g}, which is not taken: {} (they reach {:.{}g}).", window.words,
        window.white, digits, why, reached, digits);
}

ChosenWhite whiteFromData(const WhiteLevel& measured, const ValueScale& scale, std::vector<std::string>& warnings) {
    ChosenWhite white{std::nullopt, "largest value in the data"};
    if (measured.level > 0) {
        white.level = measured.level;
    } else if (scale.black != 0) {
        // No value lies above black. White lies as far above it as 0 lies from it.
        white = {std::abs(scale.black) / scale.factor, "above all values"};
    }
    if (white.level && !std::isfinite(scale.fileValue(*white.level)))
        white.level = scale.storedValue(std::numeric_limits<double>::max());
    if (measured.above == 0) return white;
    white.source = "largest value in the data but for hot voxels";
    const double level = scale.fileValue(measured.level);
    const int digits = digitsToTell({scale.black, level}, 6);
    warnings.push_back(
        fmt::format("{} voxels hold values up to {:.{}g}, far above all others: the white level is {:.{}g} without "
                    "them, and they are shown as white.",
                    measured.above, scale.fileValue(measured.largest), digits, level, digits));
    return white;
}

/// The white level of all phases, as voxels hold it: what the file declares, 255 for 8 bits from 0 on, the file's
/// window if it suits the voxels, else what the voxels say.
ChosenWhite chooseWhite(const StudyParts& parts, std::vector<std::string>& warnings) {
    const ValueScale& scale = parts.voxels.scale;
    if (parts.whiteLevel) return {scale.storedValue(*parts.whiteLevel), parts.whiteLevelSource};
    if (scale.isIdentity() && std::holds_alternative<VoxelArray<std::uint8_t>>(parts.voxels.phases.front()))
        return {std::nullopt, "8-bit voxels"};
    const WhiteLevel measured = whiteLevelOf(parts.voxels.phases);
    if (parts.window) {
        const double level = scale.storedValue(parts.window->white);
        const DeclaredWhite judged = judgeDeclaredWhite(level, measured);
        if (judged == DeclaredWhite::suits && isSensibleWhite(level))
            return {level, parts.window->source + ": " + parts.window->words};
        warnings.push_back(windowNotTaken(*parts.window, judged, measured, scale));
    }
    return whiteFromData(measured, scale, warnings);
}

/// The volume with the format's mask, else with a guess if one is wanted. Voxels that are not finite are never data.
Volume withMask(const Volume& volume, const StudyParts& parts, const ReadOptions& options) {
    if (parts.dataMask) {
        if (volume.dataMask().empty()) return volume.withDataMask(parts.dataMask);
        std::vector<std::uint8_t> both = volume.dataMask().toVector();
        std::transform(both.begin(), both.end(), parts.dataMask->begin(), both.begin(), std::bit_and<>());
        return volume.withDataMask(std::move(both));
    }
    return options.guessNoData ? volume.withDataMask(guessDataMask(volume, voxelMemory())) : volume;
}

template <typename T>
void fillSlices(std::vector<T>& values, const std::vector<std::size_t>& slices, const VolumeGeometry& geometry,
                T value) {
    const std::int64_t count = geometry.size[0] * geometry.size[1];
    for (const std::size_t slice : slices)
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(slice) * count, count, value);
}

/// As withMask(), if slices are missing.
Volume withoutMissing(const Volume& volume, const StudyParts& parts, const ReadOptions& options) {
    // Zeros of a missing slice would join fluid to the outside.
    Voxels filled = std::visit(
        [&]<typename T>(const VoxelArray<T>& given) -> Voxels {
            std::vector<T> all = given.toVector();
            fillSlices(all, parts.missingSlices, parts.geometry, T{1});
            return all;
        },
        volume.voxels());
    std::vector<std::uint8_t> mask =
        withMask(Volume(parts.geometry, std::move(filled), volume.whiteLevel()).withValueScale(volume.valueScale()),
                 parts, options)
            .dataMask()
            .toVector();
    mask.resize(static_cast<std::size_t>(parts.geometry.voxelCount()), 1);
    fillSlices(mask, parts.missingSlices, parts.geometry, std::uint8_t{0});
    return volume.withDataMask(std::move(mask));
}

/// Gives all phases one box, so that the picture of a beating heart keeps still.
void shareDataBox(std::vector<std::shared_ptr<const Volume>>& phases) {
    if (phases.size() < 2) return;
    DataBox box = phases.front()->dataBox();
    for (const auto& phase : phases) box = box.joined(phase->dataBox());
    for (auto& phase : phases) phase = std::make_shared<const Volume>(phase->withDataBox(box));
}

}  // namespace

Result<void> requirePhases(const std::string& file, const std::string& element, std::int64_t phases) {
    if (phases <= mostPhases) return {};
    return fail(FailureKind::unreadable, file, element,
                fmt::format("makes {} phases, and no more than {} can be opened", phases, mostPhases),
                "Save a shorter part of the recording.");
}

std::string nameFromPath(const std::string& path) {
    std::filesystem::path file(path);
    if (!file.has_filename()) file = file.parent_path();
    return file.has_filename() ? file.filename().string() : path;
}

bool isPosition(const Vec3& position) {
    constexpr double farthestMm = 1e7;
    // Every comparison with NaN is false, so NaN is refused.
    return std::abs(position[0]) <= farthestMm && std::abs(position[1]) <= farthestMm &&
           std::abs(position[2]) <= farthestMm;
}

namespace {

constexpr double largestSpacingRatio = 1000;

bool areLengthsOfVoxels(const Vec3& spacing) {
    constexpr double smallestMm = 1e-4, largestMm = 1e4;
    // Every comparison with NaN is false, so NaN is refused.
    return std::all_of(spacing.val, spacing.val + 3, [](double mm) { return mm >= smallestMm && mm <= largestMm; });
}

}  // namespace

bool isSensibleSpacing(const Vec3& spacing) {
    const auto [smallest, largest] = std::minmax({spacing[0], spacing[1], spacing[2]});
    return areLengthsOfVoxels(spacing) && largest <= largestSpacingRatio * smallest;
}

bool isSensibleWhite(double level) {
    using Float = std::numeric_limits<float>;
    return level >= static_cast<double>(Float::min()) && level <= static_cast<double>(Float::max());
}

bool normalizeDirection(Mat3& direction) {
    for (int column = 0; column < 3; ++column) {
        const Vec3 axis(direction(0, column), direction(1, column), direction(2, column));
        const double size = length(axis);
        if (!std::isfinite(size) || size < 1e-9) return false;
        for (int row = 0; row < 3; ++row) direction(row, column) = axis[row] / size;
    }
    return std::abs(cv::determinant(direction)) > 1e-3;
}

bool saysMoreThanItsAxes(const Mat3& direction) {
    const Mat3 axesOfRas = Mat3::diag({-1, -1, 1});
    return cv::norm(direction - Mat3::eye()) > 1e-6 && cv::norm(direction - axesOfRas) > 1e-6;
}

std::string saidOf(const std::string& sentence, std::size_t count, std::size_t parts, const char* partsInWords) {
    return count == parts ? sentence : fmt::format("{} (Said of {} of {} {}.)", sentence, count, parts, partsInWords);
}

std::string skewWarning(const Mat3& direction) {
    const Mat3 products = direction.t() * direction;
    const double skew = std::max({std::abs(products(0, 1)), std::abs(products(0, 2)), std::abs(products(1, 2))});
    if (skew < 1e-3) return {};
    return fmt::format(
        "The grid axes are not perpendicular (off by up to {:.2g} degrees); they are shown as if they were.",
        std::asin(std::min(1.0, skew)) * 180.0 / CV_PI);
}

namespace {

/// Refuses a volume that is much too long. Rays and tube cores along it would have millions of samples, and the ray
/// caster's packed voxels would take a hundred times the volume's memory.
Result<void> checkLength(const StudyParts& parts) {
    constexpr double mostUnits = 100'000;
    const auto& [size, spacing] = std::tie(parts.geometry.size, parts.geometry.spacing);
    const double unit = std::min({spacing[0], spacing[1], spacing[2]});
    for (int axis = 0; axis < 3; ++axis) {
        const double units = static_cast<double>(size[static_cast<std::size_t>(axis)]) * spacing[axis] / unit;
        if (units <= mostUnits) continue;
        return fail(FailureKind::unreadable, parts.path, parts.sizeSource,
                    fmt::format("gives a volume of {} voxels, which is {:.0f} times as long as its smallest spacing; "
                                "the most is {:.0f}",
                                sizeText(size), units, mostUnits),
                    "Cut it into shorter volumes, or correct its size or spacing.");
    }
    return {};
}

/// Refuses too many phases, a spacing that no scanner has, a volume that is too long, and an origin that is no
/// position.
Result<void> checkGeometry(const StudyParts& parts) {
    if (auto few = requirePhases(parts.path, parts.phasesSource.empty() ? parts.sizeSource : parts.phasesSource,
                                 static_cast<std::int64_t>(parts.voxels.phases.size()));
        !few)
        return few;
    const Vec3& spacing = parts.geometry.spacing;
    const std::string element = parts.spacingSource.empty() ? "the spacing" : parts.spacingSource;
    if (!areLengthsOfVoxels(spacing))
        return fail(FailureKind::unreadable, parts.path, element,
                    fmt::format("gives voxels of {}, which no scanner makes", spacingText(parts.geometry.spacing)),
                    "Give the spacing in mm.");
    if (!isSensibleSpacing(spacing))
        return fail(FailureKind::unreadable, parts.path, element,
                    fmt::format("gives voxels of {}, more than {} times as long as wide",
                                spacingText(parts.geometry.spacing), largestSpacingRatio),
                    "Correct the spacing.");
    if (auto sensible = checkLength(parts); !sensible) return sensible;
    if (!isPosition(parts.geometry.origin))
        return fail(FailureKind::unreadable, parts.path, "the origin",
                    "lies farther from 0 than 10 km, or is no number", "Correct the position of the volume.");
    return {};
}

/// Refuses a white level that float32 cannot hold.
Result<void> checkWhite(const StudyParts& parts) {
    if (!parts.whiteLevel || isSensibleWhite(parts.voxels.scale.storedValue(*parts.whiteLevel))) return {};
    return fail(FailureKind::unreadable, parts.path, parts.whiteLevelSource,
                fmt::format("puts white at {:.6g}, which no voxel can show", *parts.whiteLevel),
                "Correct the white level or leave it out.");
}

/// The longest fact in the report. A file may say anything of itself, at any length.
constexpr std::size_t longestFact = 300;

}  // namespace

Result<Study> assembleStudy(StudyParts parts, const ReadOptions& options, const Progress& progress) {
    if (auto sensible = checkGeometry(parts); !sensible) return tl::unexpected(sensible.error());
    if (auto sensible = checkWhite(parts); !sensible) return tl::unexpected(sensible.error());
    if (!(cv::determinant(parts.geometry.direction) > 0.0))
        throw std::invalid_argument("assembleStudy: the grid must be right-handed");
    Study study;
    study.name = nameFromPath(parts.path);
    study.files = std::move(parts.files);
    // Times far apart overflow. No time is better than one that no clock can wait for.
    if (!areTimesOf(parts.phaseTimes, parts.voxels.phases.size())) parts.phaseTimes = {};
    study.phaseTimes = parts.phaseTimes;
    study.turnedAxis = parts.turnedAxis;
    study.lossyCompression = parts.lossyCompression;
    study.burnedInText = parts.burnedInText;
    study.facts = std::move(parts.facts);
    for (ImportFact& fact : study.facts) fact.value = oneLine(fact.value, longestFact);
    study.warnings = std::move(parts.warnings);

    const ChosenWhite white = chooseWhite(parts, study.warnings);
    for (Voxels& voxels : parts.voxels.phases) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, parts.path, "", "was not read: cancelled");
        const Volume volume = Volume(parts.geometry, std::move(voxels), white.level).withValueScale(parts.voxels.scale);
        study.phases.push_back(std::make_shared<const Volume>(
            parts.missingSlices.empty() ? withMask(volume, parts, options) : withoutMissing(volume, parts, options)));
        progress.at(0.9 +
                    0.1 * static_cast<double>(study.phases.size()) / static_cast<double>(parts.voxels.phases.size()));
    }

    shareDataBox(study.phases);
    addAssembledFacts(parts, options, white.source, study);
    return study;
}

}  // namespace echolucent
