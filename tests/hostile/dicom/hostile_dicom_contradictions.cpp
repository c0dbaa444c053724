// DICOM files whose meta header contradicts what follows, and bytes behind the pixels that look like elements.
#include <cstdint>
#include <utility>

#include "dicom_bytes.h"
#include "hostile_file.h"
#include "temporary_folder.h"

namespace echolucent {

namespace {

const std::string topic = "dicom-contradictions/";

HostileFile refusedContradiction(const std::string& name, std::string bytes, std::vector<std::string> words) {
    return hostileFile(topic + name, "a.dcm", std::move(bytes), std::move(words));
}

HostileFile notedContradiction(const std::string& name, std::string bytes, std::vector<std::string> words) {
    return hostileFile(topic + name, "a.dcm", std::move(bytes), std::move(words), HostileOutcome::opensWithNote);
}

/// The file of two frames, with these four bytes as the length of its meta header.
std::string withMetaLength(std::uint32_t length) {
    std::string bytes = twoFrames().file(cineClass);
    return bytes.replace(140, 4, bytesFrom<std::uint32_t>({length}));
}

DicomBytes unpackedFrames() {
    DicomBytes file;
    return file.text(0x0018, 0x0088, "DS", "1").picture(4, 2, 2).text(0x0028, 0x0030, "DS", "1\\1");
}

/// The header of an RLE frame with these numbers in front, and some bytes.
std::string rleHeader(const std::vector<std::uint32_t>& numbers) {
    std::string header = bytesFrom(numbers);
    header.resize(64, '\0');
    return header + std::string(
                        "\x07"
                        "abcdefgh"
                        "\0",
                        10);
}

std::string inFragments(const std::vector<std::string>& fragments, const std::string& syntax) {
    return unpackedFrames().fragments("", fragments).file(cineClass, syntax);
}

void addFalseMetaLengths(std::vector<HostileFile>& rows) {
    for (const std::uint32_t length : {0U, 3U, 20U, 100000U, 0x7fffffffU, 0xffffffffU})
        rows.push_back(notedContradiction("a-meta-header-of-length-" + std::to_string(length), withMetaLength(length),
                                          {"(0002,0000) File Meta Information Group Length is false"}));
    rows.push_back(refusedContradiction("a-meta-header-that-ends-in-its-length",
                                        withMetaLength(0xffffffffU).substr(0, 142), {"a.dcm: ends after 142 bytes"}));
}

void addFalseSyntaxes(std::vector<HostileFile>& rows) {
    const std::string implicitLittle = "1.2.840.10008.1.2", bigSyntax = "1.2.840.10008.1.2.2";
    for (const auto& syntax : {implicitLittle, bigSyntax, deflatedSyntax})
        rows.push_back(notedContradiction("plain-elements-under-" + syntax, twoFrames().file(cineClass, syntax),
                                          {"(0002,0010) Transfer Syntax is", "they were read so"}));
    // Elements that fit into no writing are followed as the transfer syntax says.
    const std::string meta = DicomBytes().file(cineClass, implicitLittle);
    rows.push_back(refusedContradiction("a-first-element-of-2-gib-in-no-writing",
                                        meta + std::string("\x08\0\x05\0\xfe\xff\xff\x7f", 8) + std::string(40, 'a'),
                                        {"a.dcm: (0008,0005) declares 2147483646 bytes"}));
    rows.push_back(refusedContradiction("a-first-element-cut-in-no-writing", meta + std::string("\x08\0\x05\0UL", 6),
                                        {"a.dcm: ", "opy or export it again"}));
}

void addWrongFragments(std::vector<HostileFile>& rows) {
    const std::string plain = "1.2.840.10008.1.2.1";
    const std::string good = rleHeader({1, 64});
    rows.push_back(notedContradiction("rle-under-an-uncompressed-syntax", inFragments({good, good}, plain),
                                      {"begin like RLE Lossless"}));
    rows.push_back(refusedContradiction("fragments-of-no-coding", inFragments({"aaaaaaaa", "bbbbbbbb"}, plain),
                                        {"Pixel Data is split into fragments, which the transfer syntax"}));
    rows.push_back(refusedContradiction("no-fragments-under-an-uncompressed-syntax", inFragments({}, plain),
                                        {"Pixel Data is split into fragments"}));
    rows.push_back(refusedContradiction("a-jpeg-without-a-frame",
                                        inFragments({std::string("\xff\xd8\xff\xff\xff\xff", 6), "\xff\xd8"}, plain),
                                        {"(7fe0,0010) Pixel Data"}));
    rows.push_back(refusedContradiction("a-jpeg-whose-markers-have-no-length",
                                        inFragments({"\xff\xd8" + std::string(8000, '\xff'), "aa"}, plain),
                                        {"(7fe0,0010) Pixel Data"}));
    // Headers that are nearly those of RLE tell no frames apart.
    const std::vector<std::pair<std::string, std::vector<std::uint32_t>>> headers{
        {"no-segment", {0, 64}},
        {"16-segments", {16, 64}},
        {"4-billion-segments", {0xffffffffU, 64}},
        {"a-segment-in-the-header", {1, 60}},
        {"segments-that-fall", {2, 64, 64}},
        {"offsets-behind-the-last-segment", {1, 64, 70}}};
    for (const auto& [name, numbers] : headers) {
        const std::string bad = rleHeader(numbers);
        rows.push_back(refusedContradiction("rle-fragments-with-" + name,
                                            inFragments({good, "aa", bad, "aa"}, rleSyntax),
                                            {"holds 4 fragments for 2 frames"}));
    }
    rows.push_back(notedContradiction("empty-fragments", inFragments({"", good, "", "", good, ""}, rleSyntax),
                                      {"Empty fragments"}));
    rows.push_back(refusedContradiction("empty-fragments-only", inFragments({"", "", "", ""}, rleSyntax),
                                        {"(7fe0,0010) Pixel Data"}));
    // Nested items behind UN would be elements for a parser.
    std::string unknown = inFragments({good, good}, rleSyntax);
    unknown.replace(unknown.find("OB"), 2, "UN");
    rows.push_back(notedContradiction("fragments-of-unknown-representation", unknown, {"value representation UN"}));
    std::string nested = DicomBytes().file(cineClass) + unpackedFrames().bytes();
    nested += std::string("\xe0\x7f\x10\0UN\0\0\xff\xff\xff\xff", 12);
    for (int i = 0; i < 100000; ++i)
        nested += std::string("\xfe\xff\0\xe0\xff\xff\xff\xff\x40\0\x75\x02\xff\xff\xff\xff", 16);
    rows.push_back(refusedContradiction("sequences-nested-100000-deep-in-unknown-pixels", nested, {"a.dcm: "}));
}

void addBytesBehind(std::vector<HostileFile>& rows) {
    const std::string whole = twoFrames().file(cineClass);
    const auto behind = [&](const std::string& name, const std::string& bytes) {
        rows.push_back(notedContradiction("behind-the-pixels-" + name, whole + bytes,
                                          {"What stands behind the pixels is no DICOM; it is left out."}));
    };
    behind("an-element-of-4-gib", std::string("\x10\0\x20\0UN\0\0\xfe\xff\xff\xff", 12));
    behind("an-element-that-is-cut", std::string("\xfc\xff\xfc\xffOB\0\0\x40\0\0\0abc", 15));
    behind("zeros", std::string(8000000, '\0'));
    behind("letters", std::string(992, 'U'));
    behind("two-bytes", "UU");
    behind(
        "a-sequence-that-never-ends",
        std::string("\xfc\xff\xfc\xffSQ\0\0\xff\xff\xff\xff\xfe\xff\0\xe0\xff\xff\xff\xff", 20) + std::string(99, 'U'));
    // The same in front of the pixels is a file that lacks what it declares.
    DicomBytes lacking;
    lacking.put(0x0010, 0x0020, "UN", "", 0xfffffffe);
    rows.push_back(refusedContradiction("before-the-pixels-an-element-of-4-gib",
                                        lacking.file(cineClass) + twoFrames().bytes(),
                                        {"(0010,0020) declares 4294967294"}));
}

}  // namespace

std::vector<HostileFile> hostileDicomContradictions() {
    std::vector<HostileFile> rows;
    addFalseMetaLengths(rows);
    addFalseSyntaxes(rows);
    addWrongFragments(rows);
    addBytesBehind(rows);
    DicomBytes commas;
    commas.text(0x0018, 0x0088, "DS", ",").picture(4, 2, 2).text(0x0028, 0x0030, "DS", ",,,\\,");
    rows.push_back(refusedContradiction("numbers-of-commas-only",
                                        commas.put(0x7fe0, 0x0010, "OW", std::string(16, 'a')).file(cineClass),
                                        {"(0018,0088) Spacing Between Slices is no number"}));
    return rows;
}

}  // namespace echolucent
