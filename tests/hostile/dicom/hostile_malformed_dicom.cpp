// DICOM objects with numbers that no scanner writes, in codings that cannot be read, or that are no picture.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dicom_bytes.h"
#include "dicom_images.h"
#include "hostile_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

/// A folder of images.
HostileFile folderOf(const std::string& name, std::vector<TestImage> images, std::vector<std::string> words) {
    HostileFile row;
    row.name = "malformed-dicom/" + name;
    row.opened = ".";
    row.write = [images = std::move(images)](const std::filesystem::path& folder) {
        for (std::size_t i = 0; i < images.size(); ++i) writeDicom(folder / fmt::format("s{}", i), images[i]);
    };
    row.words = std::move(words);
    return row;
}

HostileFile fileOf(const std::string& name, const std::string& file, const TestImage& image,
                   std::vector<std::string> words, TestSyntax syntax = TestSyntax::explicitLittle) {
    HostileFile row;
    row.name = "malformed-dicom/" + name;
    row.opened = file;
    row.write = [=](const std::filesystem::path& folder) { writeDicom(folder / file, image, syntax); };
    row.words = std::move(words);
    return row;
}

std::vector<HostileFile> overflowingPlaces() {
    // Along a tilted normal both slices of the first pair are infinitely far, and their distance is no number.
    const std::vector<std::pair<std::string, std::array<Vec3, 2>>> pairs{
        {"both-far-away", {Vec3(-1.5e308, 0, 1.5e308), Vec3(-1.6e308, 0, 1.6e308)}},
        {"on-either-side", {Vec3(0, 0, -1e308), Vec3(0, 0, 1e308)}},
        {"far-along-all-axes", {Vec3(1e308, 1e308, 1e308), Vec3(1e308, 1e308, -1e308)}},
        {"of-which-one-is-far-away", {Vec3(0, 0, 0), Vec3(0, 0, 1e308)}},
        {"far-beside-the-normal", {Vec3(1e300, 0, 0), Vec3(1e300, 0, 1)}}};
    std::vector<HostileFile> rows;
    for (const auto& [name, pair] : pairs)
        for (const double tilt : {0.0, 0.6}) {
            std::vector<TestImage> images{sliceAt(pair[0]), sliceAt(pair[1])};
            for (TestImage& image : images) image.orientation = {std::sqrt(1 - tilt * tilt), 0, tilt, 0, 1, 0};
            rows.push_back(folderOf("slices-" + name + (tilt > 0 ? "-tilted" : ""), images,
                                    {"/s", ": (0020,0032) Image Position", "no scanner"}));
        }
    for (const double huge : {1e200, 1e308, -1e308}) {
        std::vector<TestImage> images{sliceAt({0, 0, 0}), sliceAt({0, 0, 1})};
        for (TestImage& image : images) image.orientation = {huge, 0, huge, 0, huge, 0};
        rows.push_back(
            folderOf(fmt::format("an-orientation-of-{}", huge), images, {"without position and orientation"}));
    }
    TestImage offsets = cineOf(3);
    offsets.gridOffsets = {0, 1e308, -1e308};
    rows.push_back(fileOf("frame-offsets-that-overflow", "offsets", offsets, {"offsets: (3004,000c)", "no scanner"}));
    TestImage between = cineOf(3);
    between.spacingBetweenSlices = 1.5e308;  // twice that is infinite
    rows.push_back(
        fileOf("a-distance-of-slices-that-overflows", "between", between, {"between: (0018,0088)", "no scanner"}));
    TestImage groups = cineOf(2);
    groups.functionalGroups = {{.position = {0, 0, -1.5e308}}, {.position = {0, 0, 1.5e308}}};
    rows.push_back(fileOf("frames-whose-distance-overflows", "groups", groups, {"groups: (0020,9301)", "no scanner"}));
    TestImage many = cineOf(2);
    many.spacingBetweenSlices = 1;
    many.pixelSpacing.reset();
    many.pixelSpacingText = "0.5";
    for (int i = 1; i < 200000; ++i) many.pixelSpacingText += "\\ 0.5";
    // Lengths of 32 bits hold it.
    rows.push_back(fileOf("a-pixel-spacing-of-200000-values", "v", many,
                          {"(0028,0030) Pixel Spacing is not two numbers above 0"}, TestSyntax::implicitLittle));
    return rows;
}

HostileFile bytesRow(const std::string& name, const std::string& bytes, std::vector<std::string> words,
                     HostileOutcome outcome = HostileOutcome::refused) {
    HostileFile row = hostileFile("malformed-dicom/" + name, "a.dcm", bytes, std::move(words), outcome);
    row.options.guessNoData = false;
    return row;
}

HostileFile itemsOutsideSequences(int count, const std::string& words, HostileOutcome outcome) {
    std::string bytes = DicomBytes().text(0x0008, 0x0060, "CS", "US").file(cineClass);
    for (int i = 0; i < count; ++i) bytes += dicomItem("");
    return bytesRow(fmt::format("{}-items-outside-sequences", count), bytes + twoFrames().bytes(), {words}, outcome);
}

std::vector<HostileFile> wrongElements() {
    DicomBytes more;
    more.text(0x0018, 0x0088, "DS", "1").picture(4, 2, 2).text(0x0028, 0x0030, "DS", "1\\1");
    more.put(0x7fe0, 0x0010, "OW", std::string(10, 'a'), 16);
    DicomBytes rows;
    rows.text(0x0018, 0x0088, "DS", "1").word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
    rows.text(0x0028, 0x0008, "IS", "2").text(0x0028, 0x0010, "IS", "99999999999").word(0x0028, 0x0011, 4);
    rows.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    rows.put(0x7fe0, 0x0010, "OW", std::string(16, 'a'));
    return {
        itemsOutsideSequences(500, "no sequence", HostileOutcome::opensWithNote),
        itemsOutsideSequences(400000, "holds more than 1000 items outside sequences", HostileOutcome::refused),
        bytesRow("deflated-pixels-that-end-early",
                 DicomBytes().file(cineClass, deflatedSyntax) + deflated(more.bytes(), -15),
                 {"declares 16 bytes where the file holds only 10"}),
        bytesRow("rows-that-dicom-cannot-count", rows.file(cineClass),
                 {"(0028,0010) Rows is 99999999999, more than DICOM has"}),
    };
}

/// Frames of 16 x 8 pixels that are taken as slices.
HostileFile frames(const std::string& name, const std::string& bytes, std::vector<std::string> words) {
    HostileFile row = bytesRow(name, bytes, std::move(words));
    row.options.framesAsSlices = true;
    return row;
}

DicomBytes framesOf16x8() { return DicomBytes().picture(16, 8, 2); }

std::vector<HostileFile> noPictures() {
    DicomBytes text;
    text.text(0x0008, 0x0060, "CS", "SR");
    return {
        frames("a-structured-report", text.file("1.2.840.10008.5.1.4.1.1.88.11"),
               {"is a basic text structured report, and (7fe0,0010) Pixel Data is absent"}),
        frames("a-pdf", text.file("1.2.840.10008.5.1.4.1.1.104.1"), {"is an encapsulated PDF document, and"}),
        frames("a-presentation-state", text.file("1.2.840.10008.5.1.4.1.1.11.1"),
               {"is a grayscale softcopy presentation state, and"}),
        frames("an-unknown-object", text.file("1.2.3.4"), {"is an object of a kind that is not known here"}),
        frames("empty-pixel-data", framesOf16x8().put(0x7fe0, 0x0010, "OW", "").file(cineClass),
               {"(7fe0,0010) Pixel Data is there but empty"}),
        frames("floating-point-pixels", framesOf16x8().put(0x7fe0, 0x0008, "OF", std::string(512, 'a')).file(cineClass),
               {"floating-point numbers"}),
        frames("a-compressed-syntax-of-plain-pixels",
               framesOf16x8().put(0x7fe0, 0x0010, "OW", std::string(256, 'a')).file(cineClass, jpegLsSyntax),
               {"is not split into fragments, as the transfer syntax (JPEG-LS Lossless) needs"}),
    };
}

std::vector<HostileFile> unknownCodings() {
    std::vector<HostileFile> rows;
    for (const auto& [name, syntax, words] : std::vector<std::array<std::string, 3>>{
             {"jpeg-xl-lossless", "1.2.840.10008.1.2.4.110", "is JPEG XL, lossless, which cannot be read"},
             {"jpeg-xl", "1.2.840.10008.1.2.4.112", "is JPEG XL, which cannot be read"},
             {"mpeg-2", "1.2.840.10008.1.2.4.100", "is MPEG2 Main Profile @ Main Level (video), which"},
             {"h264", "1.2.840.10008.1.2.4.102", "is MPEG-4 AVC/H.264 High Profile / Level 4.1 (video), which"},
             {"h264-in-fragments", "1.2.840.10008.1.2.4.102.1",
              "is MPEG-4 AVC/H.264 High Profile / Level 4.1 (video), which"},
             {"h265", "1.2.840.10008.1.2.4.107", "is HEVC/H.265 Main Profile / Level 5.1 (video), which"},
             {"high-throughput-jpeg-2000", "1.2.840.10008.1.2.4.201", "is High-Throughput JPEG 2000, lossless, which"},
             {"frames-deflated-one-by-one", "1.2.840.10008.1.2.8.1", "is deflated frame by frame, which"},
             {"an-unknown-coding", "1.2.3.4.5", "is a coding that is not known here, which"}})
        rows.push_back(frames("coded-as-" + name,
                              framesOf16x8().fragments("", {"abcd", "efgh"}).file(cineClass, syntax),
                              {"(0002,0010) Transfer Syntax " + words}));
    return rows;
}

}  // namespace

std::vector<HostileFile> hostileMalformedDicom() {
    std::vector<HostileFile> all;
    for (const auto rows : {overflowingPlaces, wrongElements, noPictures, unknownCodings})
        for (HostileFile& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace echolucent
