#include "io/headers/raw_volume.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/headers/header_text.h"
#include "io/output/atomic_file.h"
#include "io/study_assembly.h"

namespace echolucent {

namespace {

using nlohmann::json;

tl::unexpected<Failure> wrongSideCar(const std::string& file, const std::string& key, const std::string& problem) {
    return fail(FailureKind::unreadable, file, key, problem,
                "Delete this file and describe the raw file again, with --raw-size and the options beside it.");
}

/// Reads one key if it is there; false where it has another type.
template <typename T>
bool readKey(const json& object, const char* key, T& value) {
    const auto found = object.find(key);
    if (found == object.end()) return true;
    try {
        found->get_to(value);
    } catch (const json::exception&) {
        return false;
    }
    return true;
}

}  // namespace

std::string rawLayoutPath(const std::string& path) { return path + ".echolucent.json"; }

Result<StoredVolume> storedVolumeFromLayout(const std::string& path, const RawLayout& layout,
                                            const std::string& source) {
    const auto wrong = [&](const std::string& option, const std::string& problem) {
        return fail(FailureKind::unreadable, path, option, problem, "Describe the raw file again.");
    };
    StoredVolume stored;
    stored.path = path;
    stored.dataPath = path;
    stored.sizeKey = source;
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
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(layout.spacing[axis]) || layout.spacing[axis] <= 0)
            return wrong("--raw-spacing", "must be three numbers above 0");
    stored.geometry.spacing = layout.spacing;
    stored.geometry.spacingKnown = layout.spacingKnown;
    if (layout.spacingKnown) stored.spacingSource = "given by a person";
    stored.facts.push_back({"format", "raw, without a header", source});
    return stored;
}

Result<void> rememberRawLayout(const std::string& path, const RawLayout& layout) {
    const json object{{"format", "echolucent-raw-layout"},
                      {"version", 1},
                      {"size", layout.size},
                      {"type", layout.type},
                      {"byte_order", layout.bigEndian ? "big" : "little"},
                      {"header_bytes", layout.headerBytes},
                      {"spacing_mm", {layout.spacing[0], layout.spacing[1], layout.spacing[2]}},
                      {"spacing_known", layout.spacingKnown}};
    return writeFileAtomically(rawLayoutPath(path), object.dump(2) + "\n");
}

Result<std::optional<RawLayout>> recalledRawLayout(const std::string& path) {
    const std::string file = rawLayoutPath(path);
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::optional<RawLayout>();
    const auto text = readWholeFile(file, headerLimit);
    if (!text) return tl::unexpected(text.error());
    const json object = json::parse(*text, nullptr, false);
    std::string format;
    if (!object.is_object() || !readKey(object, "format", format) || format != "echolucent-raw-layout")
        return wrongSideCar(file, "", "does not describe a raw file");
    RawLayout layout;
    std::string byteOrder = "little";
    std::array<double, 3> spacing{1, 1, 1};
    if (!object.contains("size") || !readKey(object, "size", layout.size) || object["size"].size() != 3)
        return wrongSideCar(file, "size", "must be three whole numbers");
    if (!readKey(object, "type", layout.type)) return wrongSideCar(file, "type", "must be a word");
    if (!readKey(object, "byte_order", byteOrder) || (byteOrder != "little" && byteOrder != "big"))
        return wrongSideCar(file, "byte_order", "must be little or big");
    if (!readKey(object, "header_bytes", layout.headerBytes))
        return wrongSideCar(file, "header_bytes", "must be a whole number");
    if (!readKey(object, "spacing_mm", spacing) || (object.contains("spacing_mm") && object["spacing_mm"].size() != 3))
        return wrongSideCar(file, "spacing_mm", "must be three numbers");
    if (!readKey(object, "spacing_known", layout.spacingKnown))
        return wrongSideCar(file, "spacing_known", "must be true or false");
    layout.bigEndian = byteOrder == "big";
    layout.spacing = {spacing[0], spacing[1], spacing[2]};
    return std::optional(layout);
}

}  // namespace echolucent
