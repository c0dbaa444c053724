// Parts of objects, copies and slices over time whose numbers contradict each other or the files.
#include <algorithm>

#include "dicom_bytes.h"
#include "hostile_file.h"
#include "hostile_slices.h"

namespace echolucent {

namespace {

namespace fs = std::filesystem;

/// A part of an object of frames of 2 x 2 pixels.
struct HostilePart {
    std::string number = "1", whole = "1.2.8";
    std::vector<DicomBytes> shared{};  ///< items of a group of all frames
    std::uint16_t total = 2;
    std::uint32_t offset = 0;
    int frames = 2;
    int described = 2;  ///< frames with functional groups

    [[nodiscard]] std::string bytes() const {
        const auto sequence = [](std::uint16_t group, std::uint16_t element, const DicomBytes& item) {
            return DicomBytes().sequence(group, element, {item});
        };
        std::vector<DicomBytes> own;
        for (int frame = 0; frame < described; ++frame)
            own.push_back(
                sequence(0x0020, 0x9113,
                         DicomBytes().text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(offset % 1000 + frame))));
        DicomBytes groups = sequence(0x0020, 0x9116, DicomBytes().text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0"));
        if (!shared.empty()) groups.sequence(0x0018, 0x9152, shared);
        DicomBytes file;
        file.text(0x0008, 0x0018, "UI", "1.2.3." + number + std::to_string(offset)).text(0x0020, 0x000e, "UI", "1.2.3");
        file.text(0x0020, 0x9161, "UI", whole).text(0x0020, 0x9162, "IS", number).word(0x0020, 0x9163, total);
        file.put(0x0020, 0x9228, "UL", {reinterpret_cast<const char*>(&offset), sizeof(offset)});
        file.picture(2, 2, frames).sequence(0x5200, 0x9229, {groups}).sequence(0x5200, 0x9230, own);
        return file.put(0x7fe0, 0x0010, "OB", std::string(4 * static_cast<std::size_t>(std::min(frames, 100)), 'p'))
            .file("1.2.840.10008.5.1.4.1.1.2.1");
    }
};

/// A row with a folder of two parts, which `change` makes what they are; `spoil` changes the second.
HostileFile parts(const std::string& name, std::function<void(HostilePart&)> spoil, std::vector<std::string> words,
                  HostileOutcome outcome = HostileOutcome::refused, std::function<void(HostilePart&)> change = {}) {
    return hostileFolder(
        "parts-" + name,
        [spoil = std::move(spoil), change = std::move(change)](const fs::path& folder) {
            HostilePart part;
            if (change) change(part);
            writeBytes(folder / "a", part.bytes());
            part.number = "2";
            part.offset = 2;
            spoil(part);
            writeBytes(folder / "b", part.bytes());
        },
        outcome, std::move(words));
}

std::vector<HostileFile> hostileParts() {
    const std::string missing = "of one object is missing";
    return {
        parts(
            "that-are-whole", [](HostilePart&) {}, {"2 files are the parts of one object"},
            HostileOutcome::opensWithNote),
        parts("of-65535", [](HostilePart& part) { part.total = 65535; }, {"and more of 65535", missing}),
        parts("numbered-as-large-as-numbers-go", [](HostilePart& part) { part.number = "999999999999"; },
              {"2, 3, 4, 5, 6, 7, 8, 9 and more", missing}),
        parts("numbered-below-0", [](HostilePart& part) { part.number = "-5"; }, {missing}),
        parts(
            "numbered-with-letters", [](HostilePart& part) { part.number = "two"; }, {"2 files are the parts"},
            HostileOutcome::opensWithNote),
        parts("numbered-alike", [](HostilePart& part) { part.number = "1"; }, {"is 1 in two different files"}),
        parts("far-behind", [](HostilePart& part) { part.offset = 4000000000U; },
              {"frames 3 to 4000000000 of one object are missing"}),
        parts("over-each-other", [](HostilePart& part) { part.offset = 1; }, {"over frames of the part before it"}),
        parts("of-two-thousand-million-frames", [](HostilePart& part) { part.frames = 2147483647; },
              {"(0028,0008) Number of Frames"}),
        parts("with-groups-for-four-frames", [](HostilePart& part) { part.described = 4; },
              {"describes 4 frames where Number of Frames says 2"}),
        parts("with-groups-too-many-to-keep",
              [](HostilePart& part) {
                  part.shared.assign(20000, DicomBytes().text(0x0018, 0x9151, "DT", "20200101"));
                  part.frames = part.described = 20;
              },
              {"differ from part to part and are too many to be kept"}),
        // Comparing them item by item would be quadratic if each were looked up by its index.
        parts(
            "with-100000-empty-items-for-all-frames", [](HostilePart&) {}, {"2 files are the parts of one object"},
            HostileOutcome::opensWithNote, [](HostilePart& part) { part.shared.resize(100000); }),
        parts("of-another-object-with-its-numbers", [](HostilePart& part) { part.whole = "1.2.9"; }, {missing}),
    };
}

std::vector<HostileFile> hostileCopies() {
    const auto row = [](const std::string& name, std::function<void(const fs::path&)> more,
                        std::vector<std::string> words, HostileOutcome outcome) {
        return hostileFolder(
            "copies-" + name,
            [more = std::move(more)](const fs::path& folder) {
                writeSeries(folder, 4, {});
                more(folder);
            },
            outcome, std::move(words));
    };
    return {
        row(
            "of-all-files", [](const fs::path& folder) { writeSeries(folder / "again", 4, {}); },
            {"4 file(s) are copies of others"}, HostileOutcome::opensWithNote),
        row(
            "with-a-false-length-of-the-meta-header",
            [](const fs::path& folder) {
                HostileSlice slice;
                slice.position = "0\\0\\0";
                std::string bytes = bytesOf(slice);
                bytes.replace(140, 4, "\xff\xff\xff\x7f");
                writeBytes(folder / "t", bytes);
            },
            {"1 file(s) are copies of others"}, HostileOutcome::opensWithNote),
        row(
            "with-another-pixel",
            [](const fs::path& folder) {
                HostileSlice slice;
                slice.pixels = "12345678";
                writeBytes(folder / "t00", bytesOf(slice));
            },
            {"is the same in two files that differ, \"s00\", \"t00\"", "Take away"}, HostileOutcome::refused),
    };
}

/// Half of the slices lie at one place. Each slice has its own moment. A table of moments and places would need memory
/// quadratic in their number, so the reader makes none: it names two slices of one place, and no missing slices.
HostileFile halfAtOnePlace() {
    constexpr int slices = 4000;
    return hostileSeries("half-of-4000-at-one-place", slices,
                         [](int number, HostileSlice& slice) {
                             slice.position = "0\\0\\" + std::to_string(std::max(0, number - slices / 2));
                             slice.acquisition = slice.instance;
                         },
                         HostileOutcome::refused, {"is the same for two slices"});
}

}  // namespace

std::vector<HostileFile> hostileDicomParts() {
    std::vector<HostileFile> rows = hostileParts();
    for (HostileFile& row : hostileCopies()) rows.push_back(std::move(row));
    rows.push_back(halfAtOnePlace());
    return rows;
}

}  // namespace echolucent
