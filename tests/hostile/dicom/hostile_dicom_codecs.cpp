// JPEG, JPEG-LS and JPEG 2000 frames that are cut, contradict the data set, or are made to cost memory and time.
#include "written_codestreams.h"

namespace echolucent {

namespace {

const std::string endMarker("\xff\xd9", 2);
const std::string missingWords = "of which a part is missing or damaged";

std::string padded(std::string bytes) { return bytes.size() % 2 == 1 ? bytes + '\0' : bytes; }

/// The first `percent` of a codestream with an end marker put back.
std::string cutTo(const std::string& stream, std::size_t percent) {
    return padded(stream.substr(0, stream.size() * percent / 100) + endMarker);
}

/// Where the frame header of a JPEG or JPEG-LS stream begins.
std::size_t frameHeader(const std::string& stream) {
    for (const char marker : {'\xc0', '\xc1', '\xc3', '\xf7'}) {
        const auto place = stream.find(std::string{'\xff', marker});
        if (place != std::string::npos) return place;
    }
    return 0;
}

std::string changed(std::string bytes, std::size_t place, const std::string& with) {
    return bytes.replace(place, with.size(), with);
}

std::string big(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i));
    return text;
}

void addJpeg(std::vector<HostileFile>& rows, const std::string& name, const std::string& syntax) {
    const std::string good = writtenCodestream(syntax);
    const std::size_t header = frameHeader(good);
    const auto add = [&](const std::string& what, const std::vector<std::string>& frames,
                         const std::vector<std::string>& words, CineShape shape = {},
                         HostileOutcome outcome = HostileOutcome::refused) {
        rows.push_back(hostileCine(name + "-" + what, syntax, frames, words, shape, outcome));
    };
    add("whole", {good, good}, {"damaged"}, {}, HostileOutcome::opens);
    for (const std::size_t percent : {20, 50, 90}) {
        const std::string share = "cut-to-" + std::to_string(percent) + "-percent";
        add(share + "-with-its-end-put-back", {good, cutTo(good, percent)}, {"(7fe0,0010)", "JPEG", "(frame 2)"});
        add(share, {padded(good.substr(0, good.size() * percent / 100)), good},
            {"(7fe0,0010)", "ends before its picture does", "(frame 1)"});
    }
    add("of-zeros", {good, std::string(good.size(), '\0')}, {"is not JPEG", "(frame 2)"});
    add("without-bytes", {good, ""}, {"holds no bytes", "(frame 2)"});
    add("of-its-header-alone", {good, padded(good.substr(0, header) + endMarker)},
        {"without a frame header", "(frame 2)"});
    add("of-5000-rows", {good, changed(good, header + 5, big(5000, 2) + big(5000, 2))},
        {"JPEG frame of 5000 x 5000 pixels", "64 x 64", "(frame 2)"});
    add("of-no-rows", {changed(good, header + 5, big(0, 2)), good}, {"64 x 0 pixels", "(frame 1)"});
    add("of-3-samples", {changed(good, header + 9, "\x03"), good}, {"3 sample(s)", "64 x 64, 1 are declared"});
    add("of-12-bits-in-8", {changed(good, header + 4, "\x0c"), good}, {"JPEG frame of 12 bits where 8 are allocated"});
    add("with-two-frame-headers", {good.substr(0, header) + good.substr(header, 2 + 11) + good.substr(header), good},
        {"two frame headers", "(frame 1)"});
    CineShape wide;
    wide.bitsAllocated = wide.bitsStored = 16;
    add("of-8-bits-in-16", {good, good}, {"frames hold 8 bits where (0028,0101) Bits Stored says"}, wide,
        HostileOutcome::opensWithNote);
    wide.bitsStored = 12;
    add("of-8-bits-in-12-of-16", {good, good}, {"frames hold 8 bits where (0028,0101) Bits Stored says"}, wide,
        HostileOutcome::opensWithNote);
    CineShape large;
    large.columns = large.rows = 65535;
    const std::string edges = big(65535, 2) + big(65535, 2);
    add("of-65535-columns", {changed(good, header + 5, edges), changed(good, header + 5, edges)},
        {"65535 x 65535 pixels, more than any scanner makes"}, large);
    CineShape many;
    many.columns = many.rows = 5000;
    many.frames = 500;
    add("of-500-large-frames", std::vector<std::string>(500, changed(good, header + 5, big(5000, 2) + big(5000, 2))),
        {"for 500 frames of 5000 x 5000 pixels, which no picture packs into so few"}, many);
    CineShape few;
    few.bitsStored = 4;
    add("of-8-bits-in-4", {good, good}, {"do not fit into the 4 unsigned bits", "(frame 1)"}, few);
}

/// A JPEG stream whose scan is repeated.
std::string repeatedScan(const std::string& good, int times) {
    const auto scan = good.find(std::string("\xff\xda", 2));
    std::string stream = good.substr(0, scan);
    for (int i = 0; i < times; ++i) stream += good.substr(scan, good.size() - scan - 2);
    return padded(stream + endMarker);
}

void addJpeg2000(std::vector<HostileFile>& rows) {
    const std::string good = writtenCodestream(jpeg2000Syntax);
    const auto tile = good.find(std::string("\xff\x90\x00\x0a", 4));
    const auto add = [&](const std::string& what, const std::vector<std::string>& frames,
                         const std::vector<std::string>& words, CineShape shape = {},
                         HostileOutcome outcome = HostileOutcome::refused) {
        rows.push_back(hostileCine("jpeg-2000-" + what, jpeg2000Syntax, frames, words, shape, outcome));
    };
    // A tile whose own length says that what was cut out never was there.
    const auto shortTile = [&](std::size_t percent) {
        const std::string part = good.substr(tile, (good.size() - tile) * percent / 100);
        return padded(good.substr(0, tile) + changed(part, 6, big(static_cast<std::uint32_t>(part.size()), 4)) +
                      endMarker);
    };
    add("whole", {good, good}, {"damaged"}, {}, HostileOutcome::opens);
    for (const std::size_t percent : {5, 20, 50, 90}) {
        const std::string share = std::to_string(percent) + "-percent";
        add("tile-of-" + share, {good, shortTile(percent)}, {missingWords, "(frame 2)"});
        add("cut-to-" + share, {good, cutTo(good, percent)}, {"(7fe0,0010)", "JPEG 2000 frame", "(frame 2)"});
    }
    add("of-zeros", {std::string(64, '\0'), good}, {"is not JPEG 2000", "(frame 1)"});
    add("without-bytes", {good, ""}, {"holds no bytes", "(frame 2)"});
    add("header-alone", {good, padded(good.substr(0, tile) + endMarker)}, {"JPEG 2000 frame", "(frame 2)"});
    add("of-5000-columns", {good, changed(good, 8, big(5000, 4))},
        {"JPEG 2000 frame of 5000 x 64 pixels where 64 x 64", "(frame 2)"});
    add("one-of-four-tiles", {good, changed(good, 24, big(32, 4) + big(32, 4))}, {"holds 1 of its 4 tiles"});
    add("of-too-many-tiles", {good, changed(good, 24, big(0, 4))}, {"damaged header", "(frame 2)"});
    add("of-12-bits-in-8", {good, changed(good, 42, "\x0b")}, {"JPEG 2000 frame of 12 bits where 8 are allocated"});
    add("signed-in-unsigned", {good, changed(good, 42, "\x87")}, {"do not fit into the 8 unsigned bits", "(frame 2)"});
    CineShape isSigned;
    isSigned.sign = 1;
    add("unsigned-in-signed", {good, good}, {"unsigned values where (0028,0103)"}, isSigned,
        HostileOutcome::opensWithNote);
    add("subsampled", {good, changed(good, 43, "\x02")}, {"subsampled", "(frame 2)"});
    add("of-3-samples", {good, changed(good, 40, big(3, 2))}, {"JPEG 2000 frame of 3 samples where 1"});
    add("of-another-tile", {good, changed(good, tile + 4, big(7, 2))}, {"damaged tile", "(frame 2)"});
    add("tile-beyond-its-end", {good, changed(good, tile + 6, big(1 << 30, 4))}, {"ends in the middle of tile 1 of 1"});
    add("tile-of-no-length", {good, changed(good, tile + 6, big(5, 4))}, {"damaged tile"});
    const auto style = good.find(std::string("\xff\x52", 2));
    add("of-65535-layers-and-more-levels", {good, changed(good, style + 6, big(65535, 2))},
        {"JPEG 2000 frame", "(frame 2)"});
    add("of-200-levels", {good, changed(good, style + 9, "\xc8")}, {"damaged header"});
    add("packed-headers", {good, changed(good, style, "\xff\x60")}, {"headers of its packets apart"});
    CineShape large;
    large.columns = large.rows = 4000;
    const std::string huge = changed(good, 8, big(4000, 4) + big(4000, 4));
    add("4000-pixels-and-one-tile-of-24", std::vector<std::string>(2, changed(huge, 24, big(24, 4) + big(24, 4))),
        {"167 x 167 tiles, more than any encoder writes", "(frame 1)"}, large);
    add("4000-pixels-and-one-tile-of-400", std::vector<std::string>(2, changed(huge, 24, big(400, 4) + big(400, 4))),
        {"holds 1 of its 100 tiles", "(frame 1)"}, large);
    add("4000-pixels-in-blocks-of-4",
        std::vector<std::string>(
            2, changed(changed(huge, 24, big(4000, 4) + big(4000, 4)), style + 10, std::string(2, '\0'))),
        {"pieces, more than any encoder makes", "(frame 1)"}, large);
    large.columns = large.rows = 16000;
    add("16000-pixels", {good, good}, {"16000 x 16000 pixels, more than any scanner makes"}, large);
}

}  // namespace

std::vector<HostileFile> hostileDicomCodecs() {
    std::vector<HostileFile> rows;
    addJpeg(rows, "jpeg", jpegSyntax);
    addJpeg(rows, "jpeg-lossless", jpegLosslessSyntax);
    addJpeg(rows, "jpeg-ls", jpegLsSyntax);
    const std::string good = writtenCodestream(jpegSyntax);
    rows.push_back(hostileCine("jpeg-of-5000-scans", jpegSyntax, {good, repeatedScan(good, 5000)},
                               {"more than 100 scans", "(frame 2)"}));
    addJpeg2000(rows);
    return rows;
}

}  // namespace echolucent
