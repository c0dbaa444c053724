#include "io/study/value_window.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/voxels/stored_values.h"
#include "processing/volume/black_level.h"
#include "processing/volume/value_digits.h"
#include "processing/volume/white_level.h"

namespace echolucent {

namespace {

struct ChosenBlack {
    double level = 0.0;
    std::string source = "assumed";
};

/// Whether the whole window of the file suits values that 0 would hide.
bool windowSuits(const DisplayWindow& window, const ValueBlocks& values, const BlackLevel& measured,
                 const ValueExtent& extent) {
    if (!(window.black < window.white) || !suitsAsBlack(window.black, measured, extent)) return false;
    const ValueBlocks above = [&](const std::function<void(std::span<const double>)>& take) {
        std::vector<double> shifted;
        values([&](std::span<const double> block) {
            shifted.clear();
            for (const double value : block) shifted.push_back(value - window.black);
            take(shifted);
        });
    };
    return judgeDeclaredWhite(window.white - window.black, whiteLevelOf(above, false)) == DeclaredWhite::suits;
}

ChosenBlack blackOfData(const BlackLevel& measured, const ValueExtent& extent, std::vector<std::string>& warnings) {
    const int digits = digitsToTell({measured.level, extent.highest}, 6);
    ChosenBlack black{measured.level, "smallest value in the data"};
    if (measured.padding) {
        black.source = "smallest value in the data but for padding";
        warnings.push_back(
            fmt::format("Many voxels hold {:.{}g}, far below all others: that is taken for padding, and "
                        "is shown as black.",
                        *measured.padding, digits));
    } else if (measured.below > 0) {
        black.source = "smallest value in the data but for cold voxels";
        warnings.push_back(
            fmt::format("{} voxels hold values down to {:.{}g}, far below all others: the black level is "
                        "{:.{}g} without them, and they are shown as black.",
                        measured.below, measured.lowest, digits, measured.level, digits));
    }
    return black;
}

ChosenBlack chooseBlack(StudyParts& parts, const ValueBlocks& values, bool wholeNumbers, const ValueExtent& extent,
                        const ReadOptions& options) {
    if (options.blackAtZero) {
        if (parts.blackLevel.value_or(0.0) != 0.0 || mayHideMuch(extent)) parts.warnings.emplace_back(blackKeptAtZero);
        return {0.0, "asked for"};
    }
    if (parts.blackLevel) return {*parts.blackLevel, parts.blackLevelSource};
    if (parts.whiteLevel && !parts.lowestLevel) return {};
    const BlackLevel measured = blackLevelOf(values, wholeNumbers, extent);
    if (measured.level == 0.0) return {};
    if (parts.lowestLevel) return {*parts.lowestLevel, parts.whiteLevelSource};
    if (parts.window && windowSuits(*parts.window, values, measured, extent))
        return {parts.window->black, parts.window->source + ": " + parts.window->words};
    if (parts.window) {
        const int digits = digitsToTell({extent.lowest, extent.highest}, 6);
        parts.warnings.push_back(
            fmt::format("The window of the file ({}) is not taken: it does not suit values from "
                        "{:.{}g} to {:.{}g}.",
                        parts.window->words, extent.lowest, digits, extent.highest, digits));
        parts.window.reset();
    }
    return blackOfData(measured, extent, parts.warnings);
}

/// The scale of the voxels; the identity if they are kept as they are.
ValueScale chooseScale(StudyParts& parts, const StoredValues& stored, const ReadOptions& options, ValueExtent& extent) {
    const bool stated = parts.blackLevel.value_or(0.0) != 0.0;
    if (!stated && areOrdinary(stored)) return {};
    extent = extentOf(stored);
    if (!stated && !mayNeedWindow(extent)) return {};
    const ValueBlocks values = blocksOf(stored);
    const bool wholeNumbers = isWholeNumber(stored.type) && stored.rescale.isIdentity();
    const ChosenBlack black = chooseBlack(parts, values, wholeNumbers, extent, options);
    const ValueScale scale = scaleFrom(black.level, values, wholeNumbers, extent);
    if (!scale.isIdentity()) parts.shown = ShownValues{extent.lowest, extent.highest, black.source};
    return scale;
}

}  // namespace

void keepVoxels(StudyParts& parts, std::vector<VoxelBytes> phases, StoredType type,
                const std::optional<Rescale>& rescale, const ReadOptions& options) {
    const Rescale line = rescale.value_or(Rescale{});
    ValueExtent extent;
    const ValueScale scale = chooseScale(parts, {phases, type, line}, options, extent);
    if (scale.isIdentity()) {
        parts.voxels =
            rescale ? convertRescaledVoxels(std::move(phases), type, *rescale) : convertVoxels(std::move(phases), type);
    } else {
        parts.voxels = convertToScale(std::move(phases), type, line, scale, extent);
    }
    // Bits may mean values that all lie at or below black, or beyond float32, where the data do not.
    if (parts.lowestLevel && parts.whiteLevel && !isSensibleWhite(scale.storedValue(*parts.whiteLevel)))
        parts.whiteLevel.reset();
}

}  // namespace echolucent
