// Pixels that are not as many as declared, RLE and fragments that lie, palettes that do not fit.
#include <array>

#include "temporary_folder.h"
#include "written_codestreams.h"

namespace echolucent {

namespace {

constexpr std::size_t framePixels = std::size_t{pictureEdge} * pictureEdge;

std::string offsets(std::vector<std::uint32_t> values) { return bytesFrom<std::uint32_t>(values); }

void addRle(std::vector<HostileFile>& rows) {
    const std::string good = writtenCodestream(rleSyntax);
    const auto add = [&](const std::string& what, const std::vector<std::string>& frames,
                         const std::vector<std::string>& words, CineShape shape = {},
                         HostileOutcome outcome = HostileOutcome::refused, const std::string& table = "") {
        rows.push_back(hostileCine("rle-" + what, rleSyntax, frames, words, shape, outcome, table));
    };
    add("whole", {good, good}, {"damaged"}, {}, HostileOutcome::opens);
    add("first-frame-real-and-500-empty",
        [&] {
            std::vector<std::string> frames(501);
            frames[0] = good;
            return frames;
        }(),
        {"holds no bytes for a frame (frame 2)"}, {.frames = 501});
    add("first-frame-real-and-500-of-a-header",
        [&] {
            std::vector<std::string> frames(501, std::string(1, '\1') + std::string(63, '\0'));
            frames[0] = good;
            return frames;
        }(),
        {"RLE frame of 64 bytes for 4096 pixels, which cannot be (frame 2)"}, {.frames = 501});
    add("500-large-frames", std::vector<std::string>(500, good), {"which no picture packs into so few"},
        {.columns = 4000, .rows = 4000, .frames = 500});
    add("cut-to-half", {good, good.substr(0, good.size() / 4 * 2)}, {"RLE frame that ends after", "(frame 2)"});
    add("of-10-bytes", {good, std::string(10, 'a')}, {"RLE frame of 10 bytes, shorter than its header (frame 2)"});
    add("of-two-segments-but-one", {good, "\2" + good.substr(1)}, {"RLE frame with wrong segment offsets"});
    add("of-three-segments", {good, "\3" + good.substr(1)}, {"RLE frame of 3 segments where 1"});
    add("segment-beyond-its-end", {good, good.substr(0, 4) + "\xff\xff\xff\x7f" + good.substr(8)},
        {"wrong segment offsets"});
    add("segment-in-its-header", {good, good.substr(0, 4) + std::string("\1\0\0\0", 4) + good.substr(8)},
        {"wrong segment offsets"});
    add("of-8-bits-in-16", {good, good}, {"RLE frames hold 8 bits"}, {.bitsAllocated = 16, .bitsStored = 16},
        HostileOutcome::opensWithNote);
    add("of-8-bits-in-16-cut", {good, good.substr(0, good.size() / 4 * 2)}, {"RLE frame that ends after", "(frame 2)"},
        {.bitsAllocated = 16, .bitsStored = 16});
    add("a-frame-missing", {good}, {"holds 1 fragments where 2 frames need"});
    add("more-frames-than-declared", {good, good, good}, {"3 fragments for 2 frames"});
    add("no-fragment-at-all", {}, {"holds 0 fragments where 2"});
    add("offsets-of-other-fragments", {good, good, good}, {"offset table that does not match"}, {},
        HostileOutcome::refused, offsets({0, 4}));
    add("more-columns-than-there-are", {good, good}, {"RLE frame", "(frame 1)"}, {.columns = 20000});
}

void addFragments(std::vector<HostileFile>& rows) {
    const std::string good = writtenCodestream(jpegLsSyntax);
    const std::string head = good.substr(0, 40), tail = good.substr(40);
    const auto add = [&](const std::string& what, const std::vector<std::string>& frames,
                         const std::vector<std::string>& words, CineShape shape = {},
                         HostileOutcome outcome = HostileOutcome::refused, const std::string& table = "") {
        rows.push_back(hostileCine("fragments-" + what, jpegLsSyntax, frames, words, shape, outcome, table));
    };
    add("split-in-front", {head, tail, good}, {"offset table"}, {}, HostileOutcome::opens);
    add("both-offsets-the-same", {head, tail, good}, {"offset table of the pixels does not match"}, {},
        HostileOutcome::opensWithNote, offsets({0, 0}));
    add("offsets-in-descending-order", {head, tail, good}, {"offset table of the pixels does not match"}, {},
        HostileOutcome::opensWithNote, offsets({100, 0}));
    add("offsets-beyond-the-end", {head, tail, good}, {"offset table of the pixels does not match"}, {},
        HostileOutcome::opensWithNote, offsets({0, 0xfffffff0}));
    add("too-many-offsets", {head, tail, good}, {"offset table of the pixels does not match"}, {},
        HostileOutcome::opensWithNote, offsets({0, 4, 8, 12}));
    add("more-pictures-than-declared", {good, good, good}, {"3 of them begin a picture"});
    add("empty-ones-between", {good, "", good}, {"JPEG-LS frame", "(7fe0,0010)"});
    const std::string jpeg = writtenCodestream(jpegLosslessSyntax);
    rows.push_back(hostileCine("fragments-empty-ones-between-jpeg", jpegLosslessSyntax, {jpeg, "", jpeg}, {"damaged"},
                               {}, HostileOutcome::opens));
    add("halves-of-one-frame-for-two", {head, tail}, {"JPEG", "(frame 1)"});
    add("in-the-wrong-order", {tail, head, good}, {"(7fe0,0010)"});
    add("second-frame-empty", {good, ""}, {"holds no bytes for a frame (frame 2)"});
    add("all-empty", {"", ""}, {"holds no bytes for a frame (frame 1)"}, {.columns = 5000, .rows = 5000});
}

void addNative(std::vector<HostileFile>& rows) {
    const std::string two(2 * framePixels, 'a');
    const auto note = HostileOutcome::opensWithNote;
    rows.push_back(hostileNativeCine("native-whole", two, {"left out"}, {}, HostileOutcome::opens));
    rows.push_back(hostileNativeCine("native-too-short", two.substr(2), {"holds 8190 bytes where 64 x 64 pixels"}, {}));
    rows.push_back(hostileNativeCine("native-of-no-bytes", "", {"(7fe0,0010)"}, {}));
    rows.push_back(hostileNativeCine("native-of-odd-length", two.substr(1), {"(7fe0,0010)"}, {}));
    rows.push_back(hostileNativeCine("native-a-frame-more", two + two.substr(framePixels),
                                     {"holds 12288 bytes where 64 x 64 pixels in 2 frame(s) need 8192"}, {}));
    rows.push_back(hostileNativeCine("native-two-bytes-more", two + "bb",
                                     {"The last 2 bytes of (7fe0,0010) Pixel Data belong to no pixel"}, {}, note));
    std::string filled = two + std::string(1000, '\0');
    rows.push_back(hostileNativeCine("native-filled-with-zeros", filled, {"The last 1000 bytes"}, {}, note));
    filled[filled.size() - 1] = 'b';
    rows.push_back(hostileNativeCine("native-filled-with-zeros-but-one", filled, {"holds 9192 bytes"}, {}));
    rows.push_back(hostileNativeCine("native-two-rows-of-zeros-more-in-each-frame", two + std::string(256, '\0'),
                                     {"holds 8448 bytes"}, {}));
    rows.push_back(hostileNativeCine("native-65535-pixels-and-zeros", filled, {"need 8589672450"},
                                     {.columns = 65535, .rows = 65535}));
    rows.push_back(hostileNativeCine("native-padded-to-even", std::string(18 + 0, 'a'), {"left out"},
                                     {.columns = 3, .rows = 3}, HostileOutcome::opens));
    rows.push_back(hostileNativeCine("native-pixel-representation-7", two, {"(0028,0103) Pixel Representation is 7"},
                                     {.sign = 7}));
    rows.push_back(hostileNativeCine("native-no-rows", two, {"(0028,0010) Rows"}, {.rows = 0}));
    rows.push_back(hostileNativeCine("native-no-columns", two, {"(0028,0011) Columns"}, {.columns = 0}));
    rows.push_back(
        hostileNativeCine("native-65535-pixels", two, {"need 8589672450"}, {.columns = 65535, .rows = 65535}));
    rows.push_back(hostileNativeCine("native-12-bits-in-8", two, {"Bits Stored is 12 where 8"}, {.bitsStored = 12}));
    rows.push_back(hostileNativeCine("native-no-bits", two, {"(0028,0101) Bits Stored"}, {.bitsStored = 0}));
    rows.push_back(hostileNativeCine("native-32-bits", two, {"Bits Allocated is 32"}, {.bitsAllocated = 32}));
    rows.push_back(
        hostileNativeCine("native-1-bit-signed", two, {"Bits Stored is 1 for signed"}, {.bitsStored = 1, .sign = 1}));
    rows.push_back(hostileNativeCine("native-minus-5-frames", two, {"(0028,0008) Number of Frames"}, {.frames = -5}));
    for (const std::string frames : {"8\\9", "2.5", "two", "1e99"}) {
        DicomBytes file = DicomBytes().word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
        file.text(0x0028, 0x0008, "IS", frames).word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 2);
        file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
        file.put(0x7fe0, 0x0010, "OB", std::string(64, 'a'));
        rows.push_back(asSlices(hostileFile("dicom-pixels/native-frames-" + frames, "a.dcm", file.file(cineClass),
                                            {"(0028,0008) Number of Frames is not a number above 0"})));
    }
}

/// Two frames of 2 x 2 pixels in colour.
DicomBytes colour(std::uint16_t samples, const std::string& model, int planar) {
    DicomBytes file = DicomBytes().word(0x0028, 0x0002, samples).text(0x0028, 0x0004, "CS", model);
    if (planar >= 0) file.word(0x0028, 0x0006, static_cast<std::uint16_t>(planar));
    file.text(0x0028, 0x0008, "IS", "2").word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 2);
    return file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
}

void addColours(std::vector<HostileFile>& rows) {
    const auto add = [&](const std::string& name, DicomBytes file, const std::vector<std::string>& words,
                         HostileOutcome outcome = HostileOutcome::refused) {
        // Two frames of four pixels, of three bytes each but for a palette's.
        file.put(0x7fe0, 0x0010, "OB", std::string(name.starts_with("palette") ? 8 : 24, 'a'));
        rows.push_back(asSlices(hostileFile("dicom-pixels/" + name, "a.dcm", file.file(cineClass), words, outcome)));
    };
    add("planar-9", colour(3, "RGB", 9), {"(0028,0006) Planar Configuration is 9"});
    add("samples-2", colour(2, "RGB", 0), {"(0028,0002) Samples per Pixel is 2"});
    add("samples-65535", colour(65535, "RGB", 0), {"(0028,0002) Samples per Pixel is 65535"});
    // 4:4:4 of two frames has 24 bytes, 4:2:2 has 16.
    add("ybr-422-of-444", colour(3, "YBR_FULL_422", 0), {"has the length of 4:4:4"}, HostileOutcome::opensWithNote);
    add("ybr-422-of-planes", colour(3, "YBR_FULL_422", 1), {"has the length of 4:4:4"}, HostileOutcome::opensWithNote);
    DicomBytes wide = DicomBytes().word(0x0028, 0x0002, 3).text(0x0028, 0x0004, "CS", "YBR_FULL_422");
    wide.word(0x0028, 0x0006, 0)
        .text(0x0028, 0x0008, "IS", "2")
        .word(0x0028, 0x0010, 65535)
        .word(0x0028, 0x0011, 65535);
    wide.word(0x0028, 0x0100, 16).word(0x0028, 0x0101, 16).word(0x0028, 0x0102, 15).word(0x0028, 0x0103, 0);
    add("ybr-422-of-65535-odd-rows", wide, {"need 343586"});
    add("grey-of-3-samples", colour(3, "MONOCHROME2", 0), {"Samples per Pixel is 3 where MONOCHROME2 needs 1"});
    add("unknown-colours", colour(3, "CMYK", 0), {"(0028,0004) Photometric Interpretation is \"CMYK\""});
    const auto palette = [](const std::vector<std::uint16_t>& descriptor, std::size_t bytes) {
        DicomBytes file = colour(1, "PALETTE COLOR", -1);
        for (const std::uint16_t i : {1, 2, 3})
            file.put(0x0028, 0x1100 + i, "US", bytesFrom<std::uint16_t>(descriptor));
        for (const std::uint16_t i : {1, 2, 3}) file.put(0x0028, 0x1200 + i, "OW", std::string(bytes, '\x20'));
        return file;
    };
    const std::vector<std::string> tooShort{"Palette Color Lookup Table is missing or too short"};
    add("palette-too-short", palette({256, 0, 16}, 100), tooShort);
    add("palette-of-65536-entries-and-4-bytes", palette({0, 0, 16}, 4), tooShort);
    add("palette-without-entries", palette({256, 0, 16}, 0), tooShort);
    add("palette-of-two-numbers", palette({256, 0}, 512), tooShort);
    add("palette-without-a-descriptor", palette({}, 512), tooShort);
    add("palette-of-minus-1-entries", palette({65535, 0, 16}, 512), tooShort);
    add("palette-of-999-bits", palette({4, 0, 999}, 8), {"damaged"}, HostileOutcome::opens);
    add("palette-longer-than-it-says", palette({4, 0, 16}, 512), {"damaged"}, HostileOutcome::opens);
    add("palette-that-begins-at-65535", palette({4, 65535, 16}, 8), {"damaged"}, HostileOutcome::opens);
}

void addRescales(std::vector<HostileFile>& rows) {
    for (const auto& [name, slope, intercept, words] : std::vector<std::array<std::string, 4>>{
             {"slope-0", "0", "0", "Rescale Slope is 0"},
             {"slope-of-text", "one", "0", "Rescale Slope is no number"},
             {"slope-nan", "nan", "0", "Rescale Slope is no number"},
             {"slope-infinite", "1e400", "0", "Rescale Slope"},
             {"slope-1e300", "1e300", "0", "Rescale Slope"},
             {"intercept-1e300", "1", "1e300", "(0028,105"},
             {"intercept-of-text", "1", "zero", "Rescale Intercept is no number"}}) {
        DicomBytes file = describedCine({});
        file.text(0x0028, 0x1052, "DS", intercept).text(0x0028, 0x1053, "DS", slope);
        file.put(0x7fe0, 0x0010, "OB", std::string(2 * framePixels, 'a'));
        rows.push_back(asSlices(hostileFile("dicom-pixels/rescale-" + name, "a.dcm", file.file(cineClass), {words})));
    }
}

/// Values of padding that no pixel can hold, that all hold, or that are no number.
void addPadding(std::vector<HostileFile>& rows) {
    const auto add = [&](const std::string& name, const std::string& vr, const std::string& value,
                         const std::string& limit, const std::vector<std::string>& words, HostileOutcome outcome) {
        DicomBytes file = describedCine({});
        file.put(0x0028, 0x0120, vr, value).put(0x0028, 0x0121, vr, limit);
        file.put(0x7fe0, 0x0010, "OB", std::string(2 * framePixels, 'a'));
        rows.push_back(
            asSlices(hostileFile("dicom-pixels/padding-" + name, "a.dcm", file.file(cineClass), words, outcome)));
    };
    const auto note = HostileOutcome::opensWithNote;
    const auto word = [](std::uint16_t value) { return bytesFrom<std::uint16_t>({value}); };
    add("that-all-hold", "US", word('a'), "", {"Pixel Padding Value 97 are no data"}, note);
    add("of-all-values", "US", word(0), word(255), {"would leave no value"}, note);
    add("of-values-beyond-the-bits", "US", word(1000), word(255), {"which no pixel can hold"}, note);
    add("of-a-limit-beyond-the-bits", "US", word(7), word(1000), {"which no pixel can hold"}, note);
    add("of-two-values", "US", word(1) + word(2), "", {"which no pixel can hold"}, note);
    add("of-text", "LO", "seven ", "", {"which no pixel can hold"}, note);
    add("as-unknown", "UN", word('a'), "", {"Pixel Padding Value 97 are no data"}, note);
    add("of-30000-values", "US", std::string(60000, 'a'), "", {"which no pixel can hold"}, note);
    add("empty", "US", "", word(255), {"Padding"}, HostileOutcome::opens);
}

/// Frames of one pixel with locations along the normal.
void addLocations(std::vector<HostileFile>& rows) {
    const auto add = [&](const std::string& name, const std::string& locations, const std::vector<std::string>& words,
                         HostileOutcome outcome = HostileOutcome::refused) {
        DicomBytes file = DicomBytes().text(0x0018, 0x2005, "DS", locations);
        file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2").text(0x0028, 0x0008, "IS", "4");
        file.put(0x0028, 0x0009, "AT", bytesFrom<std::uint16_t>({0x0018, 0x2005}));
        file.word(0x0028, 0x0010, 1).word(0x0028, 0x0011, 1).text(0x0028, 0x0030, "DS", "1\\1");
        file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
        file.put(0x7fe0, 0x0010, "OB", "abcd");
        rows.push_back(hostileFile("dicom-pixels/locations-" + name, "a.dcm", file.file(cineClass), words, outcome));
    };
    add("1-mm-apart", "1\\2\\3\\4", {"damaged"}, HostileOutcome::opens);
    add("of-too-few-numbers", "1\\2\\3", {"Slice Location Vector is not one number for each of 4 frames"});
    add("of-60000-numbers",
        [] {
            std::string many = "1";
            for (int i = 0; i < 29999; ++i) many += "\\2";
            return many;
        }(),
        {"Slice Location Vector is not one number for each of 4 frames"});
    add("not-finite", "1\\nan\\3\\4", {"Slice Location Vector is not one number"});
    add("far-apart", "-1e300\\1e300\\1\\2", {"(0018,2005) Slice Location Vector"});
    add("beyond-doubles", "-1.7e308\\1.7e308\\1\\2", {"(0018,2005) Slice Location Vector"});
    add("twice", "1\\2\\1\\2", {"(0018,2005) Slice Location Vector"});
    add("all-in-one-plane", "1\\1\\1\\1", {"is a 2D cine of 4 frames"});
}

/// Frames of one pixel with vectors of nuclear medicine of these numbers.
void addVectors(std::vector<HostileFile>& rows) {
    const auto add = [&](const std::string& name, std::uint16_t frames, const std::vector<std::uint16_t>& slots,
                         const std::vector<std::uint16_t>& slices, const std::vector<std::string>& words,
                         HostileOutcome outcome = HostileOutcome::refused) {
        DicomBytes file = DicomBytes().text(0x0018, 0x0088, "DS", "1").picture(1, 1, frames);
        file.text(0x0028, 0x0030, "DS", "1\\1").put(0x0054, 0x0070, "US", bytesFrom(slots));
        file.put(0x0054, 0x0080, "US", bytesFrom(slices)).put(0x7fe0, 0x0010, "OB", std::string(frames, 'a'));
        rows.push_back(hostileFile("dicom-pixels/vectors-" + name, "a.dcm", file.file(cineClass), words, outcome));
    };
    add("of-two-times", 4, {1, 65535, 1, 65535}, {7, 7, 8, 8}, {"damaged"}, HostileOutcome::opens);
    add("of-too-few-numbers", 4, {1, 2, 1}, {1, 1, 2, 2}, {"puts frames 1 and 2 at one place and time"});
    add("of-no-numbers", 4, {}, {}, {"damaged"}, HostileOutcome::opens);
    add("with-a-slice-twice", 4, {1, 2, 1, 2}, {1, 1, 1, 2}, {"puts frames 1 and 3 at one place and time"});
    add("far-apart", 4, {1, 2, 1, 2}, {0, 0, 65535, 65535}, {"counts 2 slices from 0 to 65535"});
    std::vector<std::uint16_t> slots, slices;
    for (std::uint16_t i = 0; i < 10000; ++i) {
        slots.push_back(i / 2);
        slices.push_back(i % 2);
    }
    add("of-5000-phases", 10000, slots, slices, {"makes 5000 phases, and no more than 4096"});
}

}  // namespace

std::vector<HostileFile> hostileDicomPixels() {
    std::vector<HostileFile> rows;
    addRle(rows);
    addFragments(rows);
    addNative(rows);
    addColours(rows);
    addRescales(rows);
    addPadding(rows);
    addLocations(rows);
    addVectors(rows);
    return rows;
}

}  // namespace echolucent
