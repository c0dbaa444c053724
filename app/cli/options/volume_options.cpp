#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/volume_options.h"
#include "io/file_formats.h"
#include "io/files/header_text.h"
#include "io/output/output_place.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/named_study.h"

namespace echolucent::cli {

namespace {

Result<std::optional<RawLayout>> layoutFrom(const VolumeOptions& options) {
    const bool any = !options.rawSpacing.empty() || !options.rawType.empty() || !options.rawByteOrder.empty() ||
                     options.rawHeaderBytes != 0 || options.rawPolar.any();
    if (options.rawSize.empty()) {
        if (any) return wrongUsage("--raw-size", "is missing beside other --raw options", "Give it as XxYxZ.");
        return std::optional<RawLayout>();
    }
    RawLayout layout;
    const auto size = parseNumbers(options.rawSize, 3, "--raw-size", "256x256x128");
    if (!size) return tl::unexpected(size.error());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = (*size)[axis];
        if (value < 1 || value > 1e15 || value != std::floor(value))
            return wrongUsage("--raw-size", "must be three whole numbers above 0, not " + quotedText(options.rawSize),
                              "Give it as XxYxZ.");
        layout.size[axis] = static_cast<std::int64_t>(value);
    }
    if (!options.rawType.empty()) layout.type = options.rawType;
    layout.bigEndian = options.rawByteOrder == "big";
    if (options.rawHeaderBytes < 0)
        return wrongUsage("--raw-header-bytes", "must be 0 or more", "Give the number of bytes before the voxels.");
    layout.headerBytes = options.rawHeaderBytes;
    const auto polar = options.rawPolar.get(layout.size);
    if (!polar) return tl::unexpected(polar.error());
    layout.polar = *polar;
    if (layout.polar && !options.rawSpacing.empty())
        return wrongUsage("--raw-spacing", "has no meaning beside --raw-polar",
                          "Leave it out: the spacing follows the beams.");
    if (!options.rawSpacing.empty()) {
        const auto spacing = parseNumbers(options.rawSpacing, 3, "--raw-spacing", "0.5x0.5x1");
        if (!spacing) return tl::unexpected(spacing.error());
        for (int axis = 0; axis < 3; ++axis) {
            layout.spacing[axis] = (*spacing)[static_cast<std::size_t>(axis)];
            if (!std::isfinite(layout.spacing[axis]) || !(layout.spacing[axis] > 0))
                return wrongUsage("--raw-spacing",
                                  "must be three numbers above 0, not " + quotedText(options.rawSpacing),
                                  "Give it in mm as XxYxZ.");
        }
        layout.spacingKnown = true;
    }
    return std::optional(layout);
}

}  // namespace

Result<void> checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& curveNames) {
    // The file need not exist. Empty if the path cannot be resolved.
    const auto whole = [](const std::string& path) {
        std::error_code error;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
    };
    const auto isSame = [&](const std::string& left, const std::string& right) {
        std::error_code error;
        return left == right || (!whole(left).empty() && whole(left) == whole(right)) ||
               std::filesystem::equivalent(left, right, error);
    };
    for (std::size_t i = 0; i < outputs.size(); ++i)
        for (std::size_t k = i + 1; k < outputs.size(); ++k)
            if (!outputs[i].empty() && outputs[i] != "-" && !outputs[k].empty() && isSame(outputs[i], outputs[k]))
                return fail(FailureKind::wrongUsage, outputs[k], "", "is named twice, and would be overwritten",
                            "Give each output a name of its own.");
    std::vector<std::string> curves(curveNames.size());
    std::transform(curveNames.begin(), curveNames.end(), curves.begin(), curveFileOf);
    keepFromOverwriting(curves);
    for (const std::string& output : outputs) {
        if (output.empty()) continue;
        if (const auto place = placeOfOutput(output); !place) return tl::unexpected<Failure>(place.error());
    }
    return {};
}

void VolumeOptions::addTo(CLI::App& command) {
    command
        .add_option("VOLUME", path,
                    namesAndEndingsOfFormats() +
                        ", a folder of DICOM, or raw with --raw-size; any of these files packed with gzip")
        ->required();
    command.add_option("--series", series,
                       "Series of a folder or DICOMDIR: its number in info's list; what is no number is its UID");
    command.add_option("--phase", phase, "Phase of a 4D volume, from 0")->capture_default_str();
    command.add_option("--raw-size", rawSize,
                       "Voxels of a headerless raw file, XxYxZ; samples, lines and planes with --raw-polar");
    command.add_option("--raw-type", rawType, "Voxel type of a raw file; uint8 where not given")
        ->check(CLI::IsMember({"uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"}));
    command.add_option("--raw-byte-order", rawByteOrder, "Byte order of a raw file; little where not given")
        ->check(CLI::IsMember({"little", "big"}));
    command.add_option("--raw-header-bytes", rawHeaderBytes, "Bytes before the voxels of a raw file")
        ->capture_default_str();
    command.add_option("--raw-spacing", rawSpacing, "Spacing of a raw file in mm, XxYxZ; unknown where not given");
    rawPolar.addTo(command);
    command
        .add_option("--conversion-memory", read.conversionMebibytes,
                    "MiB that a phase may take where voxels along beams are converted to a grid")
        ->check(CLI::Range(std::int64_t{1}, mostConversionMebibytes))
        ->capture_default_str();
    command
        .add_option("--study-memory", read.studyMebibytes,
                    "MiB that the voxels of all phases may take; a larger volume is read reduced. A sixth of this "
                    "machine's memory where not given")
        ->check(CLI::Range(std::int64_t{1}, mostStudyMebibytes));
    command.add_flag(
        "--frames-as-slices", read.framesAsSlices,
        "Take the frames of a 2D cine or of a tracked sweep as slices; their distance stays unknown unless "
        "the file states it");
    command.add_flag(
        "--all-voxels", [this](std::int64_t) { read.guessNoData = false; },
        "Take every voxel as data: do not guess what lies outside the scanned sector");
    command.add_flag("--black-at-zero", read.blackAtZero,
                     "Keep black at 0 where values lie below it, as documents of older programs did");
}

Result<std::optional<SeriesList>> VolumeOptions::listedSeries() const {
    if (!restricted::holdsSeries(path)) {
        if (!series.empty())
            return wrongUsage("--series", "names a series of a folder or DICOMDIR, and " + path + " is neither",
                              "Leave it out.");
        return std::optional<SeriesList>();
    }
    auto list = restricted::listSeries(path);
    if (!list) return tl::unexpected(list.error());
    keepFromOverwriting(list->files);
    return std::optional(std::move(*list));
}

Result<const SeriesEntry*> VolumeOptions::chosenSeries(const SeriesList& list) const {
    const auto number = wholeNumber(series);
    if (series.empty() || !number) {
        auto found = findSeries(list, series);
        if (!found) found.error().kind = FailureKind::wrongUsage;
        return found;
    }
    const auto count = static_cast<std::int64_t>(list.series.size());
    if (*number < 1 || *number > count)
        return fail(FailureKind::wrongUsage, path, "--series",
                    fmt::format("is {}, but there are {} series", *number, count),
                    fmt::format("Choose 1 to {}.", count));
    return &list.series[static_cast<std::size_t>(*number - 1)];
}

Result<VolumeOptions::Named> VolumeOptions::readNamed(const std::vector<std::string>& outputs) const {
    // Compare the path itself at once, and the files behind it when they are known.
    keepFromOverwriting({path});
    if (auto possible = checkOutputs(outputs); !possible) return tl::unexpected(possible.error());
    const auto list = listedSeries();
    if (!list) return tl::unexpected(list.error());
    auto study = readListed(*list, outputs);
    if (!study) return tl::unexpected(study.error());
    StudyFile reference{.path = path, .options = read, .checksum = {}};
    if (*list) reference.options.series = (*chosenSeries(**list))->uid;
    reference = asOpened(std::move(reference), *study);
    return Named{std::move(*study), std::move(reference)};
}

Result<Study> VolumeOptions::readAll(const std::vector<std::string>& outputs) const {
    auto named = readNamed(outputs);
    if (!named) return tl::unexpected(named.error());
    return std::move(named->study);
}

Result<Study> VolumeOptions::readListed(const std::optional<SeriesList>& list,
                                        const std::vector<std::string>& outputs) const {
    ReadOptions options = read;
    const auto layout = layoutFrom(*this);
    if (!layout) return tl::unexpected(layout.error());
    options.raw = *layout;
    if (phase < 0) return wrongUsage("--phase", "must be 0 or more", "Phases are counted from 0.");
    auto study = [&]() -> Result<Study> {
        if (!list) return restricted::readStudy(path, options);
        const auto entry = chosenSeries(*list);
        if (!entry) return tl::unexpected(entry.error());
        return restricted::readSeries(*list, **entry, options);
    }();
    if (!study) return study;
    keepFromOverwriting(study->files);
    if (auto possible = checkOutputs(outputs); !possible) return tl::unexpected(possible.error());
    if (static_cast<std::size_t>(phase) >= study->phases.size())
        return fail(FailureKind::wrongUsage, path, "--phase",
                    fmt::format("is {}, but the volume has {} phase(s)", phase, study->phases.size()),
                    fmt::format("Choose 0 to {}.", study->phases.size() - 1));
    return study;
}

Result<std::shared_ptr<const Volume>> VolumeOptions::readPhase(const std::vector<std::string>& outputs) const {
    const auto study = readAll(outputs);
    if (!study) return tl::unexpected(study.error());
    return study->phases[static_cast<std::size_t>(phase)];
}

}  // namespace echolucent::cli
