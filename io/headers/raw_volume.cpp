#include "io/headers/raw_volume.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/file_access.h"
#include "io/files/header_text.h"
#include "io/files/input_file.h"
#include "io/json/json_values.h"
#include "io/output/atomic_file.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

// Enough for the most lines and planes of a geometry, each a number on its own line.
constexpr std::size_t layoutLimit = 2 * static_cast<std::size_t>(mostPolarLines) * 64;
constexpr const char* formatName = "echolucent-raw-layout";
constexpr const char* remedyOfLayout =
    "Delete this file and describe the raw file again, with --raw-size and the options beside it.";

}  // namespace

std::string rawLayoutPath(const std::string& path) { return path + std::string(rawLayoutEnding); }

Result<StoredVolume> storedVolumeFromLayout(const InputFile& file, const RawLayout& layout, const std::string& source) {
    const std::string& path = file.path();
    const auto wrong = [&](const std::string& option, const std::string& problem) {
        return fail(FailureKind::unreadable, path, option, problem, "Describe the raw file again.");
    };
    StoredVolume stored;
    stored.path = path;
    stored.data = {{path, file}};
    stored.sizeKey = stored.typeKey = stored.byteOrderKey = source;
    stored.encodingKey = "a raw file is taken as it is";
    stored.sizeRemedy = "Correct the size, the type, or the bytes before the voxels.";
    if (std::any_of(layout.size.begin(), layout.size.end(), [](std::int64_t size) { return size < 1; }))
        return wrong(source, "must be three whole numbers above 0, not " + sizeText(layout.size));
    stored.geometry.size = layout.size;
    const auto type = storedTypeFromName(layout.type);
    if (!type)
        return wrong("--raw-type", "is " + quotedText(layout.type) +
                                       "; it must be uint8, int8, uint16, int16, uint32, int32, float32 or float64");
    stored.type = *type;
    stored.bigEndian = layout.bigEndian;
    if (layout.headerBytes < 0) return wrong("--raw-header-bytes", "must be 0 or above");
    stored.extent.offset = static_cast<std::uint64_t>(layout.headerBytes);
    stored.facts.push_back({"format", "raw, without a header", source});
    if (layout.polar) {
        stored.polar = layout.polar;
        stored.polarSources = {source, source, source, source};
        if (source == "--raw-size") stored.polarSources = {source, "--raw-range", "--raw-lines", "--raw-planes"};
        if (auto sensible = checkPolar(path, *layout.polar, layout.size, stored.polarSources); !sensible)
            return tl::unexpected(sensible.error());
        return stored;
    }
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(layout.spacing[axis]) || layout.spacing[axis] <= 0)
            return wrong("--raw-spacing", "must be three numbers above 0");
    stored.geometry.spacing = layout.spacing;
    stored.geometry.spacingKnown = layout.spacingKnown;
    if (layout.spacingKnown) stored.spacingSource = "given by a person";
    return stored;
}

Result<void> rememberRawLayout(const std::string& path, const RawLayout& layout) {
    nlohmann::ordered_json object{{"format", formatName}, {"version", 1}};
    object.update(rawLayoutJson(layout));
    return writeFileAtomically(rawLayoutPath(path), object.dump(2) + "\n", OutputKind::rawLayout);
}

Result<std::optional<RawLayout>> recalledRawLayout(const std::string& path) {
    const std::string file = rawLayoutPath(path);
    if (fileAccess().kindOf(file) == FileKind::missing) return std::optional<RawLayout>();
    if (auto inside = requireInItsFolder(file); !inside) return tl::unexpected(inside.error());
    const auto text = readWholeFile(file, layoutLimit);
    if (!text) return tl::unexpected(text.error());
    const auto object = jsonObject(*text, file, formatName, remedyOfLayout);
    if (!object) return tl::unexpected(object.error());
    JsonProblems problems{file, std::nullopt};
    JsonFields fields(*object, {}, problems);
    RawLayout layout = rawLayoutIn(fields);
    if (problems.first) return problems.refused(remedyOfLayout);
    return std::optional(layout);
}

}  // namespace echolucent
