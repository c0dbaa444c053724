// DICOM elements that no parser should follow blindly: nesting, lengths, kinds of values, numbers of elements.
#include <array>
#include <cstdint>
#include <functional>
#include <utility>

#include "dicom_bytes.h"
#include "hostile_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

const std::string qlabClass = "1.2.840.113543.6.6.1.3.10002";
const std::string explicitLittle = "1.2.840.10008.1.2.1";
const std::string implicitLittle = "1.2.840.10008.1.2";
const std::string explicitBig = "1.2.840.10008.1.2.2";
const std::string openItem("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8);
const std::string openBigItem("\xff\xfe\xe0\x00\xff\xff\xff\xff", 8);
const std::string openSequence("\x40\0\x75\x02SQ\0\0\xff\xff\xff\xff", 12);
const std::string openImplicit("\x40\0\x75\x02\xff\xff\xff\xff", 8);
const std::string openBig("\0\x40\x02\x75SQ\0\0\xff\xff\xff\xff", 12);
const std::string openImplicitBig("\0\x40\x02\x75\xff\xff\xff\xff", 8);

std::string repeated(const std::string& bytes, int count) {
    std::string all;
    all.reserve(bytes.size() * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) all += bytes;
    return all;
}

/// Bytes that open 200,000 sequences in each other, as a data set of this kind holds them.
std::string nested() { return repeated(openSequence + openItem, 200000); }
std::string nestedImplicit() { return repeated(openImplicit + openItem, 200000); }
std::string nestedBig() { return repeated(openBig + openBigItem, 200000); }

std::string meta(const std::string& syntax, const std::string& sopClass = cineClass) {
    return DicomBytes().file(sopClass, syntax);
}

/// A private element with these two letters for a value representation and this behind them.
std::string privateElement(const std::string& letters, const std::string& behind) {
    return std::string("\x09\0\x01\x10", 4) + letters + behind;
}

HostileFile refusedBytes(const std::string& name, std::string bytes, std::vector<std::string> words) {
    return hostileFile(dicomStructureTopic + name, "a.dcm", std::move(bytes), std::move(words));
}

HostileFile tooDeep(const std::string& name, std::string bytes) {
    return refusedBytes("nested-200000-deep-" + name, std::move(bytes), {"holds sequences nested more than 64 deep"});
}

/// Whatever it takes the bytes for, it says that they are no whole file.
HostileFile noWhole(const std::string& name, std::string bytes) {
    return refusedBytes("nested-200000-deep-" + name, std::move(bytes), {"a.dcm: ", "opy or export it again."});
}

void addNested(std::vector<HostileFile>& rows) {
    const std::string length4("\4\0\0\0", 4), length8("\x08\0\0\0", 4), two("\0\0", 2);
    // Read with a length of 16 bits, the value would lead out of the file.
    const std::string trap = std::string("OB\0\0\xf0\xff\xff\x7f", 8);
    const std::string undefined("\xff\xff\xff\xff", 4);
    rows.push_back(tooDeep("behind-letters-zz-of-32-bits",
                           meta(explicitLittle) + privateElement("ZZ", two + length4 + "abcd") + nested()));
    rows.push_back(tooDeep("behind-letters-zz-with-a-trap",
                           meta(explicitLittle) + privateElement("ZZ", two + length8 + trap) + nested()));
    rows.push_back(tooDeep("behind-letters-aa-with-a-trap",
                           meta(explicitLittle) + privateElement("AA", two + length8 + trap) + nested()));
    rows.push_back(tooDeep("in-letters-zz-of-undefined-length",
                           meta(explicitLittle) + privateElement("ZZ", two + undefined) + openItem + nested()));
    for (const auto& [name, letters] :
         std::array{std::pair{"small", "zz"}, std::pair{"question-marks", "??"}, std::pair{"blank", "  "},
                    std::pair{"digits", "1A"}, std::pair{"mixed", "Ob"}})
        rows.push_back(
            tooDeep(std::string("behind-letters-") + name,
                    meta(explicitLittle) + privateElement(letters, std::string("\4\0", 2) + "abcd") + nested()));
    rows.push_back(tooDeep("in-ge-private-syntax", meta("1.2.840.113619.5.2") + nestedImplicit()));
    rows.push_back(tooDeep("in-qlab-of-unknown-syntax", meta("1.2.3.4.5", qlabClass) + nestedImplicit()));
    rows.push_back(tooDeep("in-unknown-syntax", meta("1.2.3.4.5") + nested()));
    rows.push_back(tooDeep("in-jpeg-syntax", meta(jpegSyntax) + nested()));
    rows.push_back(tooDeep("in-deflated", meta(deflatedSyntax) + deflated(nested(), -15)));
    rows.push_back(tooDeep("in-deflated-jpip", meta("1.2.840.10008.1.2.4.95") + deflated(nested(), -15)));
    rows.push_back(
        tooDeep("in-deflated-behind-zz",
                meta(deflatedSyntax) + deflated(privateElement("ZZ", two + length8 + trap) + nested(), -15)));
    rows.push_back(tooDeep("in-big-endian", meta(explicitBig) + nestedBig()));
    rows.push_back(tooDeep(
        "in-un-of-a-big-endian-file",
        meta(explicitBig) + std::string("\0\x09\x10\x01UN\0\0\xff\xff\xff\xff", 12) + openItem + nestedImplicit()));
    rows.push_back(
        tooDeep("in-un", meta(explicitLittle) + privateElement("UN", two + undefined) + openItem + nestedImplicit()));
    rows.push_back(
        tooDeep("in-un-of-known-length",
                meta(explicitLittle) + DicomBytes().put(0x0009, 0x1001, "UN", openItem + nestedImplicit()).bytes()));
    rows.push_back(
        tooDeep("in-un-of-a-known-sequence",
                meta(explicitLittle) + DicomBytes().put(0x0008, 0x1140, "UN", openItem + nestedImplicit()).bytes()));
    rows.push_back(tooDeep("behind-a-foreign-delimiter",
                           meta(explicitLittle) + std::string("\xfe\xff\x34\x12LO\4\0abcd", 12) + nested()));
    rows.push_back(tooDeep("behind-a-foreign-delimiter-of-bytes",
                           meta(explicitLittle) + std::string("\xfe\xff\x34\x12OB\0\0\4\0\0\0abcd", 16) + nested()));
    rows.push_back(tooDeep("in-implicit", meta(implicitLittle) + nestedImplicit()));
    rows.push_back(
        tooDeep("in-an-implicit-sequence-of-4-bytes",
                meta(implicitLittle) + std::string("\x40\0\x75\x02\4\0\0\0", 8) + openItem + nestedImplicit()));
    rows.push_back(
        tooDeep("in-a-sequence-of-4-bytes",
                meta(explicitLittle) + std::string("\x40\0\x75\x02SQ\0\0\4\0\0\0", 12) + openItem + nested()));
    rows.push_back(tooDeep("in-an-item-of-4-bytes",
                           meta(explicitLittle) + openSequence + std::string("\xfe\xff\0\xe0\4\0\0\0", 8) + nested()));
    rows.push_back(tooDeep(
        "in-pixels-of-vr-sq",
        meta(explicitLittle) + DicomBytes().put(0x7fe0, 0x0010, "SQ", openItem + nested(), 0xffffffff).bytes()));
    rows.push_back(tooDeep("without-a-syntax-implicit",
                           DicomBytes().text(0x0002, 0x0002, "UI", "1.2").bytes() + nestedImplicit()));
    const std::string preamble = std::string(128, '\0') + "DICM";
    const std::string onlyClass = preamble + DicomBytes().text(0x0002, 0x0002, "UI", "1.2").bytes();
    rows.push_back(
        tooDeep("without-a-syntax-implicit-big", onlyClass + repeated(openImplicitBig + openBigItem, 200000)));
    rows.push_back(tooDeep("without-a-syntax-big", onlyClass + nestedBig()));
    // The meta header has no sequences.
    const std::string metaSequence("\2\0\3\1SQ\0\0\xff\xff\xff\xff", 12);
    const std::vector<std::string> words{"(0002,0103)", "in the meta header with a sequence"};
    rows.push_back(refusedBytes("nested-200000-deep-in-the-meta-header",
                                preamble + repeated(metaSequence + openItem, 200000), words));
    rows.push_back(refusedBytes(
        "un-of-undefined-length-in-the-meta-header",
        preamble + std::string("\2\0\3\1UN\0\0\xff\xff\xff\xff", 12) + openItem + nestedImplicit(), words));
    // An element where GE names its private elements, but a sequence.
    const auto creator = [](const std::string& inItem) {
        return DicomBytes().put(0x7fe1, 0x0010, "SQ", dicomItem(inItem)).bytes();
    };
    const std::string huge = creator(privateElement("ZZ", two + std::string("\xf0\xff\xff\x7f", 4)));
    const std::vector<std::string> declared{"declares 2147483632 bytes"};
    rows.push_back(refusedBytes("2-gib-in-a-creator-of-vr-sq", meta(explicitLittle) + huge, declared));
    rows.push_back(
        refusedBytes("2-gib-in-a-creator-of-vr-sq-deflated", meta(deflatedSyntax) + deflated(huge, -15), declared));
    rows.push_back(
        tooDeep("in-a-creator-of-vr-sq", meta(explicitLittle) + creator(openSequence + openItem) + nested()));
    // What is no sequence to anybody.
    rows.push_back(noWhole("in-bytes-of-undefined-length",
                           meta(explicitLittle) + privateElement("OB", two + undefined) + openItem + nested()));
    rows.push_back(noWhole("behind-a-lone-item-end",
                           meta(explicitLittle) + std::string("\xfe\xff\x0d\xe0\0\0\0\0", 8) + nested()));
    rows.push_back(noWhole("behind-a-lone-sequence-end",
                           meta(explicitLittle) + std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8) + nested()));
    rows.push_back(tooDeep("explicit-in-an-implicit-file", meta(implicitLittle) + nested()));
    rows.push_back(tooDeep("implicit-in-an-explicit-file", meta(explicitLittle) + nestedImplicit()));
    rows.push_back(noWhole(
        "behind-the-offset-table",
        meta(explicitLittle) + DicomBytes().put(0x7fe0, 0x0010, "OB", openItem + nested(), 0xffffffff).bytes()));
}

std::string ascending(std::uint16_t group, int count) {
    DicomBytes file;
    for (int i = 0; i < count; ++i) file.put(group, static_cast<std::uint16_t>(i), "LO", "");
    return file.bytes();
}

std::string descending(std::uint16_t group, int count) {
    DicomBytes file;
    for (int i = 0; i < count; ++i) file.put(group, static_cast<std::uint16_t>(0xffff - i), "LO", "");
    return file.bytes();
}

std::string itemsIn(int count) {
    return DicomBytes().put(0x0008, 0x1140, "SQ", repeated(dicomItem(""), count)).bytes();
}

/// `head`, `block` `times` times, and `tail` as one raw deflate stream, for which each part is deflated once.
std::string deflatedRepeats(const std::string& head, const std::string& block, int times, const std::string& tail) {
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
    const auto part = [&](const std::string& bytes, int flush) {
        std::string out(deflateBound(&stream, bytes.size()) + 64, '\0');
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream.avail_in = static_cast<uInt>(bytes.size());
        stream.next_out = reinterpret_cast<Bytef*>(out.data());
        stream.avail_out = static_cast<uInt>(out.size());
        deflate(&stream, flush);
        return out.substr(0, out.size() - stream.avail_out);
    };
    // What is flushed in full refers to nothing before it.
    std::string all = part(head, Z_FULL_FLUSH);
    all += repeated(part(block, Z_FULL_FLUSH), times);
    all += part(tail, Z_FINISH);
    deflateEnd(&stream);
    return all;
}

/// Zeros of `megabytes` MB as the value of one element of a deflated data set.
std::string deflatedZeros(const std::string& syntax, std::uint16_t group, std::uint16_t element, int megabytes) {
    DicomBytes head;
    head.text(0x0018, 0x0088, "DS", "1").picture(4, 2, 2);
    head.put(group, element, "OW", "", std::int64_t{megabytes} << 20);
    return meta(syntax) + deflatedRepeats(head.bytes(), std::string(std::size_t{1} << 20, '\0'), megabytes, "");
}

/// A row whose bytes take time or memory to make: they are made when they are written.
HostileFile large(const std::string& name, std::function<std::string()> bytes, std::vector<std::string> words) {
    HostileFile row = hostileFile(dicomStructureTopic + name, "a.dcm", "", std::move(words));
    row.write = [bytes = std::move(bytes)](const std::filesystem::path& folder) {
        writeBytes(folder / "a.dcm", bytes());
    };
    return row;
}

void addCounts(std::vector<HostileFile>& rows) {
    const std::string after = twoFrames().bytes();
    const std::string many = "holds more than 20000 elements in one data set or item";
    const std::string order = "holds too many elements that are out of order";
    const std::string total = "holds more than 500000 elements";
    rows.push_back(
        refusedBytes("elements-in-one-data-set", meta(explicitLittle) + ascending(0x0009, 60000) + after, {many}));
    rows.push_back(
        refusedBytes("elements-in-one-item",
                     meta(explicitLittle) +
                         DicomBytes().put(0x0008, 0x1140, "SQ", dicomItem(ascending(0x0009, 60000))).bytes() + after,
                     {many}));
    rows.push_back(refusedBytes("elements-in-descending-order",
                                meta(explicitLittle) + descending(0x0009, 19000) + after, {order}));
    rows.push_back(refusedBytes(
        "elements-that-are-one-and-the-same",
        meta(explicitLittle) + repeated(DicomBytes().put(0x0009, 0x1000, "LO", "").bytes(), 600000) + after, {total}));
    rows.push_back(refusedBytes(
        "elements-in-descending-order-in-items",
        meta(explicitLittle) +
            DicomBytes().put(0x0008, 0x1140, "SQ", repeated(dicomItem(descending(0x0009, 4000)), 4)).bytes() + after,
        {order}));
    rows.push_back(refusedBytes("a-million-empty-items", meta(explicitLittle) + itemsIn(1000000) + after, {total}));
    rows.push_back(refusedBytes(
        "a-million-empty-fragments",
        meta(rleSyntax) + DicomBytes().put(0x7fe0, 0x0010, "OB", repeated(dicomItem(""), 1000000), 0xffffffff).bytes(),
        {total}));
    const std::string tiny = repeated(DicomBytes().put(0x0009, 0x1000, "LO", "").bytes(), 30000);
    const auto makeTiny = [=] { return meta(deflatedSyntax) + deflatedRepeats("", tiny, 100, after); };
    rows.push_back(large("three-million-small-elements-deflated", makeTiny, {total}));
    const std::string sequence = DicomBytes().put(0x0008, 0x1140, "SQ", "", 24000000).bytes();
    const std::string items = repeated(dicomItem(""), 30000);
    const auto makeItems = [=] { return meta(deflatedSyntax) + deflatedRepeats(sequence, items, 100, after); };
    rows.push_back(large("three-million-items-deflated", makeItems, {total}));
    const auto makePixels = [] { return deflatedZeros(deflatedSyntax, 0x7fe0, 0x0010, 2047); };
    rows.push_back(large("two-gigabytes-of-zeros-deflated", makePixels, {"unpacks to more than", "no volume does"}));
    const auto makePrivate = [] { return deflatedZeros("1.2.840.10008.1.2.4.95", 0x0029, 0x1001, 300); };
    rows.push_back(large("zeros-deflated-in-the-jpip-syntax", makePrivate, {"unpacks to more than"}));
    HostileFile good = hostileFile(dicomStructureTopic + "elements-in-a-large-but-true-number", "a.dcm",
                                   meta(explicitLittle) + itemsIn(100000) + ascending(0x0009, 10000) + after,
                                   {"elements"}, HostileOutcome::opens);
    rows.push_back(std::move(good));
}

void addTwice(std::vector<HostileFile>& rows) {
    const auto twice = [](DicomBytes first, DicomBytes second) {
        DicomBytes all;
        const std::string pixels = DicomBytes().put(0x7fe0, 0x0010, "OW", std::string(16, 'a')).bytes();
        return all.text(0x0018, 0x0088, "DS", "1").file(cineClass) + first.picture(4, 2, 2).bytes() + second.bytes() +
               pixels;
    };
    const std::string words = "stands twice, with different values";
    const DicomBytes spacing = DicomBytes().text(0x0028, 0x0030, "DS", "1\\1");
    rows.push_back(refusedBytes("rows-twice", twice({}, DicomBytes(spacing).word(0x0028, 0x0010, 3)),
                                {"(0028,0010) Rows", words}));
    rows.push_back(refusedBytes("spacing-twice", twice({}, DicomBytes(spacing).text(0x0028, 0x0030, "DS", "2\\2")),
                                {"(0028,0030) Pixel Spacing", words}));
    rows.push_back(refusedBytes("frames-twice",
                                twice(DicomBytes(spacing), DicomBytes().text(0x0028, 0x0008, "IS", "1")),
                                {"(0028,0008)", words}));
    rows.push_back(refusedBytes("rows-twice-in-other-kinds",
                                twice({}, DicomBytes(spacing).put(0x0028, 0x0010, "UL", std::string("\2\0\0\0", 4))),
                                {"(0028,0010) Rows", words}));
    rows.push_back(refusedBytes("pixels-twice",
                                twoFrames().put(0x7fe0, 0x0010, "OW", std::string(16, 'b')).file(cineClass),
                                {"(7fe0,0010) Pixel Data", words}));
    rows.push_back(hostileFile(dicomStructureTopic + "rows-twice-the-same", "a.dcm",
                               twice({}, DicomBytes(spacing).word(0x0028, 0x0010, 2)),
                               {"(0028,0010) Rows stands twice, with the same value"}, HostileOutcome::opensWithNote));
}

}  // namespace

std::vector<HostileFile> hostileDicomStructure() {
    std::vector<HostileFile> rows;
    addNested(rows);
    addCounts(rows);
    addTwice(rows);
    return rows;
}

}  // namespace echolucent
