// DICOM values that are of another kind than the dictionary says, several where one is meant, or nonsense.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dicom_bytes.h"
#include "hostile_file.h"

namespace echolucent {

namespace {

std::string little(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xff);
    return text;
}

/// What a test may say otherwise; the picture has two frames of 4 x 24 pixels, 0.5 mm, 1 mm apart.
struct Described {
    DicomBytes samples = DicomBytes().word(0x0028, 0x0002, 1);
    DicomBytes planar{};
    DicomBytes frames = DicomBytes().text(0x0028, 0x0008, "IS", "2");
    DicomBytes rows = DicomBytes().word(0x0028, 0x0010, 24);
    DicomBytes columns = DicomBytes().word(0x0028, 0x0011, 4);
    DicomBytes spacing = DicomBytes().text(0x0028, 0x0030, "DS", "0.5\\0.5");
    DicomBytes allocated = DicomBytes().word(0x0028, 0x0100, 8);
    DicomBytes stored = DicomBytes().word(0x0028, 0x0101, 8);
    DicomBytes high = DicomBytes().word(0x0028, 0x0102, 7);
    DicomBytes sign = DicomBytes().word(0x0028, 0x0103, 0);
    DicomBytes rescale{};
    DicomBytes between = DicomBytes().text(0x0018, 0x0088, "DS", "1");
    DicomBytes place{};  ///< in group 0020
    DicomBytes grid{};
    std::string photometric = "MONOCHROME2";
    std::size_t pixelBytes = 192;

    [[nodiscard]] std::string file() const {
        std::string bytes = DicomBytes().file(cineClass) + between.bytes() + place.bytes() + samples.bytes();
        bytes += DicomBytes().text(0x0028, 0x0004, "CS", photometric).bytes() + planar.bytes() + frames.bytes();
        bytes += rows.bytes() + columns.bytes() + spacing.bytes() + allocated.bytes() + stored.bytes() + high.bytes();
        bytes += sign.bytes() + rescale.bytes() + grid.bytes();
        return bytes + DicomBytes().put(0x7fe0, 0x0010, "OW", std::string(pixelBytes, 'a')).bytes();
    }
};

/// The text as a part of a row's name.
std::string plain(const std::string& text) {
    std::string words;
    for (const char letter : text)
        words += letter == '\\'  ? "-and-"
                 : letter == '.' ? "-point-"
                 : letter == '-' ? "minus-"
                 : letter == ' ' ? "-blank-"
                                 : std::string(1, letter);
    return words;
}

HostileFile refusedValues(const std::string& name, const Described& file, std::vector<std::string> words) {
    return hostileFile(dicomStructureTopic + name, "a.dcm", file.file(), std::move(words));
}

HostileFile notedValues(const std::string& name, const Described& file, std::vector<std::string> words) {
    return hostileFile(dicomStructureTopic + name, "a.dcm", file.file(), std::move(words),
                       HostileOutcome::opensWithNote);
}

HostileFile good(const std::string& name, const Described& file) {
    return hostileFile(dicomStructureTopic + name, "a.dcm", file.file(), {"not stated", "left out"},
                       HostileOutcome::opens);
}

/// Numbers and texts kept as bytes are what the dictionary says; what is no such thing is named.
void addKinds(std::vector<HostileFile>& rows) {
    for (const char* vr : {"UN", "OB", "OW"}) {
        const std::string kind = std::string("-of-vr-") + vr;
        const auto word = [&](std::uint16_t element, std::uint16_t value) {
            return DicomBytes().put(0x0028, element, vr, little(value, 2));
        };
        Described all;
        all.samples = word(0x0002, 1);
        all.frames = DicomBytes().put(0x0028, 0x0008, vr, "2 ");
        all.rows = word(0x0010, 24);
        all.columns = word(0x0011, 4);
        all.spacing = DicomBytes().put(0x0028, 0x0030, vr, "0.5\\0.5 ");
        all.allocated = word(0x0100, 8);
        all.stored = word(0x0101, 8);
        all.high = word(0x0102, 7);
        all.sign = word(0x0103, 0);
        all.between = DicomBytes().put(0x0018, 0x0088, vr, "1 ");
        rows.push_back(good("everything" + kind, all));
        Described odd;
        odd.rows = DicomBytes().put(0x0028, 0x0010, vr, little(0x18, 2) + little(0x18, 2));
        rows.push_back(refusedValues("two-rows" + kind, odd, {"(0028,0010) Rows", "several values"}));
        Described spacing;
        spacing.spacing = DicomBytes().put(0x0028, 0x0030, vr, std::string(4, '\1'));
        rows.push_back(refusedValues("nonsense-spacing" + kind, spacing, {"(0028,0030) Pixel Spacing"}));
        Described frames;
        frames.frames = DicomBytes().put(0x0028, 0x0008, vr, "two ");
        rows.push_back(refusedValues("nonsense-frames" + kind, frames,
                                     {"(0028,0008) Number of Frames", "is not a number above 0"}));
        Described bits;
        bits.stored = DicomBytes().put(0x0028, 0x0101, vr, little(0x080808, 4));
        rows.push_back(refusedValues("nonsense-bits-stored" + kind, bits, {"(0028,0101) Bits Stored"}));
    }
}

void addDescriptions(std::vector<HostileFile>& rows) {
    const auto row = [&](const std::string& name, const auto& change, std::vector<std::string> words) {
        Described file;
        change(file);
        rows.push_back(refusedValues(name, file, std::move(words)));
    };
    const auto note = [&](const std::string& name, const auto& change, std::vector<std::string> words) {
        Described file;
        change(file);
        rows.push_back(notedValues(name, file, std::move(words)));
    };
    row("pixel-representation-7", [](Described& f) { f.sign = DicomBytes().word(0x0028, 0x0103, 7); },
        {"(0028,0103) Pixel Representation is 7"});
    row("pixel-representation-twice-in-one",
        [](Described& f) { f.sign = DicomBytes().put(0x0028, 0x0103, "US", std::string("\0\0\1\0", 4)); },
        {"(0028,0103) Pixel Representation holds several values"});
    row("pixel-representation-of-text",
        [](Described& f) { f.sign = DicomBytes().text(0x0028, 0x0103, "LO", "signed"); },
        {"(0028,0103) Pixel Representation is no whole number"});
    const auto colour = [](Described& f) {
        f.samples = DicomBytes().word(0x0028, 0x0002, 3);
        f.photometric = "RGB";
        f.pixelBytes = 576;
    };
    row("planar-configuration-9-of-colours",
        [&](Described& f) {
            colour(f);
            f.planar = DicomBytes().word(0x0028, 0x0006, 9);
        },
        {"(0028,0006) Planar Configuration is 9"});
    note("planar-configuration-9-of-grey", [](Described& f) { f.planar = DicomBytes().word(0x0028, 0x0006, 9); },
         {"(0028,0006) Planar Configuration is", "left out"});
    for (const std::string frames :
         {"8\\9", "2\\2", "-2", "2.5", "two", "1e400", "nan", "inf", "999999999999", "0x2", "2 2"})
        row("number-of-frames-" + plain(frames),
            [&](Described& f) { f.frames = DicomBytes().text(0x0028, 0x0008, "IS", frames); },
            {"(0028,0008) Number of Frames is not a number above 0"});
    // 0 is taken as 1, which these pixels are too many for.
    row("number-of-frames-0", [&](Described& f) { f.frames = DicomBytes().text(0x0028, 0x0008, "IS", "0"); },
        {"so that it cannot be told what the picture's size is"});
    for (const int samples : {0, 2, 4, 65535})
        row("samples-per-pixel-" + std::to_string(samples),
            [&](Described& f) { f.samples = DicomBytes().word(0x0028, 0x0002, static_cast<std::uint16_t>(samples)); },
            {"(0028,0002) Samples per Pixel is " + std::to_string(samples)});
    row("high-bit-below-bits-stored", [](Described& f) { f.high = DicomBytes().word(0x0028, 0x0102, 3); },
        {"(0028,0102) High Bit is 3 where 8 of 8 bits are stored"});
    row("high-bit-above-bits-allocated", [](Described& f) { f.high = DicomBytes().word(0x0028, 0x0102, 9); },
        {"(0028,0102) High Bit is 9"});
    note("high-bit-that-is-not-one-below-bits-stored",
         [](Described& f) { f.stored = DicomBytes().word(0x0028, 0x0101, 4); },
         {"(0028,0102) High Bit is 7, not one below the 4 bits stored"});
    row("bits-stored-above-bits-allocated", [](Described& f) { f.stored = DicomBytes().word(0x0028, 0x0101, 12); },
        {"(0028,0101) Bits Stored is 12 where 8 are allocated"});
    row("bits-stored-0", [](Described& f) { f.stored = DicomBytes().word(0x0028, 0x0101, 0); },
        {"(0028,0101) Bits Stored is 0"});
    for (const int bits : {0, 1, 7, 12, 24, 32, 64})
        row("bits-allocated-" + std::to_string(bits),
            [&](Described& f) { f.allocated = DicomBytes().word(0x0028, 0x0100, static_cast<std::uint16_t>(bits)); },
            {"(0028,0100) Bits Allocated is " + std::to_string(bits)});
    row("rows-0", [](Described& f) { f.rows = DicomBytes().word(0x0028, 0x0010, 0); },
        {"(0028,0010) Rows is missing or not above 0"});
    row("rows-of-nan", [](Described& f) { f.rows = DicomBytes().real(0x0028, 0x0010, std::nan("")); },
        {"(0028,0010) Rows is no whole number"});
    row("columns-of-a-half", [](Described& f) { f.columns = DicomBytes().real(0x0028, 0x0011, 4.5); },
        {"(0028,0011) Columns is no whole number"});
    row("columns-of-2000-values",
        [](Described& f) { f.columns = DicomBytes().put(0x0028, 0x0011, "US", std::string(4000, '\4')); },
        {"(0028,0011) Columns holds several values"});
    row("more-pixels-than-declared", [](Described& f) { f.pixelBytes = 256; },
        {"(7fe0,0010) Pixel Data holds 256 bytes where", "need 192", "cannot be told"});
    row("one-frame-more-than-declared", [](Described& f) { f.pixelBytes = 288; },
        {"(7fe0,0010) Pixel Data holds 288 bytes"});
    row("one-row-more-than-declared", [](Described& f) { f.pixelBytes = 196; },
        {"(7fe0,0010) Pixel Data holds 196 bytes"});
    note("two-bytes-more-than-declared", [](Described& f) { f.pixelBytes = 194; },
         {"The last 2 bytes of (7fe0,0010) Pixel Data belong to no pixel"});
    row("fewer-pixels-than-declared", [](Described& f) { f.pixelBytes = 190; },
        {"(7fe0,0010) Pixel Data holds 190 bytes where", "need 192"});
    for (const std::string slope : {"0", "nan", "inf", "1e999", "-1e999", "one", "1e308"})
        row("rescale-slope-" + plain(slope),
            [&](Described& f) {
                f.rescale = DicomBytes().text(0x0028, 0x1052, "DS", "0").text(0x0028, 0x1053, "DS", slope);
            },
            {"(0028,1053) Rescale Slope"});
    for (const std::string intercept : {"nan", "inf", "1e999", "none"})
        row("rescale-intercept-" + plain(intercept),
            [&](Described& f) {
                f.rescale = DicomBytes().text(0x0028, 0x1052, "DS", intercept).text(0x0028, 0x1053, "DS", "1");
            },
            {"(0028,1052) Rescale Intercept"});
}

std::string listOf(int count) {
    std::string text = "1";
    for (int i = 1; i < count; ++i) text += "\\1";
    return text;
}

void addPlaces(std::vector<HostileFile>& rows) {
    const auto row = [&](const std::string& name, const auto& change, std::vector<std::string> words) {
        Described file;
        change(file);
        rows.push_back(refusedValues(name, file, std::move(words)));
    };
    for (const std::string spacing :
         {"0\\0", "-1\\1", "nan\\nan", "inf\\inf", "1e999\\1", "1\\1\\1", "1", "half", "1\\"})
        row("pixel-spacing-" + plain(spacing),
            [&](Described& f) { f.spacing = DicomBytes().text(0x0028, 0x0030, "DS", spacing); },
            {"(0028,0030) Pixel Spacing is not two numbers above 0"});
    for (const std::string spacing : {"1e300\\1e300", "1e308\\1e-308", "1e-320\\1e-320", "5e-324\\5e-324"})
        row("pixel-spacing-" + plain(spacing),
            [&](Described& f) { f.spacing = DicomBytes().text(0x0028, 0x0030, "DS", spacing); },
            {"(0028,0030) Pixel Spacing"});
    for (const char* vr : {"UN", "UT", "OB"})
        row(std::string("pixel-spacing-of-200000-values-of-vr-") + vr,
            [&](Described& f) { f.spacing = DicomBytes().put(0x0028, 0x0030, vr, listOf(200000) + " "); },
            {"(0028,0030) Pixel Spacing is not two numbers above 0"});
    row("pixel-spacing-of-8000-doubles",
        [](Described& f) { f.spacing = DicomBytes().put(0x0028, 0x0030, "FD", std::string(64000, '\1')); },
        {"(0028,0030) Pixel Spacing is not two numbers above 0"});
    row("grid-frame-offset-vector-of-200000-values",
        [](Described& f) { f.grid = DicomBytes().put(0x3004, 0x000c, "UN", listOf(200000) + " "); },
        {"(3004,000c) Grid Frame Offset Vector is not one number for each of 2 frames"});
    row("grid-frame-offset-vector-of-one-value",
        [](Described& f) { f.grid = DicomBytes().text(0x3004, 0x000c, "DS", "1"); },
        {"(3004,000c) Grid Frame Offset Vector is not one number"});
    for (const std::string offsets : {"nan\\nan", "0\\inf", "0\\1e999", "0\\x"})
        row("grid-frame-offsets-" + plain(offsets),
            [&](Described& f) { f.grid = DicomBytes().text(0x3004, 0x000c, "DS", offsets); },
            {"(3004,000c) Grid Frame Offset Vector is not one number"});
    for (const std::string offsets : {"0\\1e308", "-1e308\\1e308", "1e300\\1e300"})
        row("grid-frame-offsets-" + plain(offsets),
            [&](Described& f) { f.grid = DicomBytes().text(0x3004, 0x000c, "DS", offsets); },
            {"(3004,000c) Grid Frame Offset Vector", "no scanner"});
    row("grid-frame-offsets-all-0", [](Described& f) { f.grid = DicomBytes().text(0x3004, 0x000c, "DS", "0\\0"); },
        {"(3004,000c) Grid Frame Offset Vector is the same for two slices"});
    for (const std::string between : {"nan", "inf", "1e999", "wide", "1\\2"})
        row("spacing-between-slices-" + plain(between),
            [&](Described& f) { f.between = DicomBytes().text(0x0018, 0x0088, "DS", between); },
            {"(0018,0088) Spacing Between Slices is no number"});
    for (const std::string between : {"1e300", "-1e308", "1e-320"})
        row("spacing-between-slices-" + plain(between),
            [&](Described& f) { f.between = DicomBytes().text(0x0018, 0x0088, "DS", between); },
            {"(0018,0088) Spacing Between Slices"});
    for (const std::string orientation :
         {"0\\0\\0\\0\\0\\0", "1\\0\\0\\1\\0\\0", "2\\0\\0\\0\\2\\0", "0.5\\0\\0\\0\\0.5\\0", "1\\0\\0\\0.3\\0.9\\0",
          "nan\\0\\0\\0\\1\\0", "1\\0\\0\\0\\inf\\0", "1e300\\0\\0\\0\\1\\0", "1\\0\\0\\0\\1", "1",
          "up\\0\\0\\0\\1\\0"})
        row("image-orientation-" + plain(orientation),
            [&](Described& f) { f.place = DicomBytes().text(0x0020, 0x0037, "DS", orientation); },
            {"(0020,0037) Image Orientation (Patient) is no pair of perpendicular directions"});
    for (const std::string position : {"nan\\0\\0", "0\\0", "0\\0\\0\\0", "here", "0\\0\\1e999"})
        row("image-position-" + plain(position),
            [&](Described& f) { f.place = DicomBytes().text(0x0020, 0x0032, "DS", position); },
            {"(0020,0032) Image Position (Patient) is no position"});
    row("image-position-1e300", [](Described& f) { f.place = DicomBytes().text(0x0020, 0x0032, "DS", "1e300\\0\\0"); },
        {"(0020,0032) Image Position", "no scanner"});
}

}  // namespace

std::vector<HostileFile> hostileDicomValues() {
    std::vector<HostileFile> rows;
    addKinds(rows);
    addDescriptions(rows);
    addPlaces(rows);
    return rows;
}

}  // namespace echolucent
