#include "hostile_slices.h"

#include <fmt/format.h>

#include <utility>

#include "dicom_bytes.h"

namespace echolucent {

std::string bytesOf(const HostileSlice& slice) {
    DicomBytes file;
    const auto text = [&](std::uint16_t group, std::uint16_t element, const char* vr, const std::string& value) {
        if (!value.empty()) file.text(group, element, vr, value);
    };
    text(0x0008, 0x0016, "UI", pictureClass);
    text(0x0008, 0x0018, "UI", slice.series + "." + slice.instance);
    text(0x0008, 0x0060, "CS", slice.modality);
    text(0x0008, 0x103e, "LO", slice.description);
    text(0x0010, 0x0010, "PN", slice.patientName);
    text(0x0010, 0x0020, "LO", slice.patientId);
    text(0x0010, 0x0030, "DA", slice.birthDate);
    text(0x0020, 0x000e, "UI", slice.series);
    text(0x0020, 0x0012, "IS", slice.acquisition);
    text(0x0020, 0x0013, "IS", slice.instance);
    text(0x0020, 0x0032, "DS", slice.position);
    text(0x0020, 0x0037, "DS", slice.orientation);
    text(0x0020, 0x0052, "UI", slice.frame);
    const int samples = slice.photometric.starts_with("MONO") ? 1 : 3;
    file.word(0x0028, 0x0002, static_cast<std::uint16_t>(samples));
    text(0x0028, 0x0004, "CS", slice.photometric);
    if (samples == 3) file.word(0x0028, 0x0006, 0);
    if (slice.sized) file.word(0x0028, 0x0010, slice.rows).word(0x0028, 0x0011, slice.columns);
    text(0x0028, 0x0030, "DS", slice.spacing);
    file.word(0x0028, 0x0100, slice.bits).word(0x0028, 0x0101, slice.bits);
    file.word(0x0028, 0x0102, static_cast<std::uint16_t>(slice.bits - 1)).word(0x0028, 0x0103, slice.representation);
    text(0x0028, 0x1052, "DS", slice.intercept);
    text(0x0028, 0x1053, "DS", slice.slope);
    const std::size_t held =
        static_cast<std::size_t>(slice.columns) * slice.rows * slice.bits / 8 * static_cast<std::size_t>(samples);
    if (slice.hasPixels && slice.syntax == rleSyntax)
        file.fragments("", {slice.pixels});
    else if (slice.hasPixels)
        file.put(0x7fe0, 0x0010, "OW", slice.pixels.empty() ? std::string(held, '\x20') : slice.pixels);
    std::string bytes = file.file(pictureClass, slice.syntax);
    if (slice.kept > 0) bytes.resize(slice.kept);
    bytes.resize(bytes.size() - slice.cut);
    return bytes;
}

void writeSeries(const std::filesystem::path& folder, int count, const SpoilSlice& spoil, const std::string& prefix) {
    for (int number = 0; number < count; ++number) {
        HostileSlice slice;
        slice.instance = std::to_string(number + 1);
        slice.position = fmt::format("0\\0\\{}", number);
        if (spoil) spoil(number, slice);
        writeBytes(folder / fmt::format("{}{:02}", prefix, number), bytesOf(slice));
    }
}

HostileFile hostileFolder(const std::string& name, std::function<void(const std::filesystem::path& folder)> write,
                          HostileOutcome outcome, std::vector<std::string> words) {
    HostileFile row;
    row.name = "dicom-series/" + name;
    row.opened = ".";
    row.write = std::move(write);
    row.outcome = outcome;
    row.words = std::move(words);
    return row;
}

HostileFile hostileSeries(const std::string& name, int count, SpoilSlice spoil, HostileOutcome outcome,
                          std::vector<std::string> words) {
    return hostileFolder(
        name,
        [count, spoil = std::move(spoil)](const std::filesystem::path& folder) { writeSeries(folder, count, spoil); },
        outcome, std::move(words));
}

}  // namespace echolucent
