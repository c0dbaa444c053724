#include "dicom_bytes.h"
#include "hostile_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

const std::string sixteenPixels = "ABCDEFGHIJKLMNOP";

HostileFile foundMetaImage(const std::string& name, const std::string& lastKeys, std::vector<std::string> words) {
    return hostileFile("found-by-fuzzing/" + name, "v.mha",
                       "NDims = 3\nDimSize = 4 2 2\nElementType = MET_UCHAR\n" + lastKeys, std::move(words));
}

/// What is wrong with these shows in the report, which tests/fuzz looks at; the words are in no warning.
HostileFile foundCine(const std::string& name, DicomBytes file, std::vector<std::string> words) {
    file.text(0x0018, 0x0088, "DS", "1").text(0x0028, 0x0030, "DS", "1\\1").put(0x7fe0, 0x0010, "OW", sixteenPixels);
    return hostileFile("found-by-fuzzing/" + name, "v.dcm", file.file(cineClass), std::move(words),
                       HostileOutcome::opens);
}

/// A cine of 4 x 2 pixels without a Photometric Interpretation.
DicomBytes withoutPhotometric() {
    DicomBytes file;
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0008, "IS", "2").word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 4);
    return file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
}

/// Two frames of a tracked sweep, whose keys have names of 2,000 letters.
std::string longSweepKeys() {
    std::string keys;
    for (const char* frame : {"0000", "0001"})
        keys +=
            "Seq_Frame" + std::string(frame) + "_" + std::string(2000, 'k') + "Transform = 1 0 0 0 1 0 0 0 1 0 0 0\n";
    return keys + "ElementDataFile = LOCAL\n" + sixteenPixels;
}

/// Behind whole pixels, an element that declares 4 GB: the library takes memory for it before it looks.
HostileFile hugeLastElement() {
    DicomBytes file = DicomBytes().text(0x0018, 0x0088, "DS", "1").picture(4, 2, 2);
    file.put(0x7fe0, 0x0010, "OW", sixteenPixels).put(0xfffc, 0xfffc, "OB", "rest", 0xf0000000);
    return hostileFile("found-by-fuzzing/4-gigabytes-declared-behind-the-pixels", "v.dcm", file.file(cineClass),
                       {"is a 2D cine of 2 frames"});
}

/// Two slices, each of the raw elements as a deflated data set, in a folder, which is opened: so their headers are
/// listed.
HostileFile deflatedSlices(const std::string& name, const std::string& elements, const std::string& words) {
    const std::string bytes = DicomBytes().file(pictureClass, deflatedSyntax) + deflated(elements, -15);
    return {"found-by-fuzzing/" + name,
            ".",
            [bytes](const std::filesystem::path& folder) {
                for (const char* slice : {"1.dcm", "2.dcm"}) writeBytes(folder / slice, bytes);
            },
            HostileOutcome::refused,
            {"1.dcm", words}};
}

/// A Patient ID that declares 3.8 GB, for which the library takes memory before it looks what there is.
HostileFile hugePatient() {
    const std::string patient = DicomBytes().put(0x0010, 0x0020, "UN", "SECRET", 0xe0000000).bytes();
    return deflatedSlices("a-patient-id-of-4-gigabytes", patient,
                          "declares 3758096384 bytes where the file holds only 6");
}

/// A file in an unknown coding, in which the walk is lost where the library finds a Photometric Interpretation that
/// declares 32 MB: looking at its header takes no memory for them.
HostileFile hugeText() {
    std::string bytes = std::string(128, '\0') + "DICM" + std::string("\2\0\0\0UL\4\0@\0\0\0", 12);
    bytes += DicomBytes().put(0x0002, 0x0002, "UI", "65536\\").bytes();
    bytes += DicomBytes().put(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.4.5").bytes();
    bytes +=
        std::string(" \0007\0\0\2\0\0\0 \0\23\0\2\b\0\xff\177\0\0\0\0\0\0", 24) + std::string("(\0\4\0\0\0\1\2\0", 9);
    HostileFile row = hostileFile("found-by-fuzzing/a-text-of-32-megabytes", "folder/1.dcm", bytes,
                                  {"(0002,0010)", "not known here"});
    row.opened = "folder";
    row.mostBytesAtOnce = std::size_t{1} << 24;
    return row;
}

/// A value that looks like an item, and a few letters: the walk ends among these, where the library takes four of them
/// for a length of 1.3 GB.
std::string lettersAsALength() {
    const std::string item = std::string("\xfe\xff\0\xe0\xff\xff", 6) + "MMMMMMMM" + std::string("\0\0\xc4\x03", 4);
    const std::string elements = DicomBytes().put(0x4d4d, 0x0100, "UN", item + std::string(14, 'M')).bytes();
    return elements + std::string(13, 'M');
}

/// The same letters where an element may end in the middle: in the list of a DICOMDIR, and behind whole pixels.
HostileFile deflatedLetters(const std::string& name, const std::string& sopClass, const DicomBytes& before) {
    return hostileFile("found-by-fuzzing/" + name, "v.dcm",
                       DicomBytes().file(sopClass, deflatedSyntax) + deflated(before.bytes() + lettersAsALength(), -15),
                       {"in the middle of an element"});
}

DicomBytes wholePixels() {
    DicomBytes cine = DicomBytes().text(0x0018, 0x0088, "DS", "1").picture(4, 2, 2);
    return cine.put(0x7fe0, 0x0010, "OW", sixteenPixels);
}

/// Rows that are a sequence of undefined length: as its text the library takes 4 GiB.
HostileFile rowsThatAreASequence() {
    DicomBytes file = DicomBytes().text(0x0018, 0x0088, "DS", "1").word(0x0028, 0x0002, 1);
    file.sequence(0x0028, 0x0010, {DicomBytes().text(0x0008, 0x0060, "CS", "US")}, 0xffffffff)
        .put(0xfffe, 0xe0dd, "", std::string(2, '\0'), 0)
        .word(0x0028, 0x0011, 4);
    file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    file.put(0x7fe0, 0x0010, "OW", sixteenPixels);
    return hostileFile("found-by-fuzzing/rows-that-are-a-sequence", "v.dcm", file.file(cineClass), {"Rows", "missing"});
}

}  // namespace

std::vector<HostileFile> hostileFoundByFuzzing() {
    const std::string longName(2000, 'v');
    return {
        foundMetaImage("a-data-file-with-a-name-of-2000-letters", "ElementDataFile = " + longName + "\n",
                       {"2000 letters long"}),
        foundMetaImage("a-key-of-2000-letters", longSweepKeys(), {"tracked 2D sweep"}),
        foundMetaImage("a-pattern-that-counts-from-the-largest-number",
                       "ElementDataFile = v%d.raw 9223372036854775807\n", {"counts with 9223372036854775807"}),
        hugeLastElement(),
        hugePatient(),
        hugeText(),
        deflatedSlices("letters-behind-what-looks-like-an-item", lettersAsALength(), "in the middle of an element"),
        deflatedLetters("letters-as-a-deflated-dicomdir", "1.2.840.10008.1.3.10", DicomBytes()),
        deflatedLetters("letters-behind-deflated-pixels", cineClass, wholePixels()),
        rowsThatAreASequence(),
        foundCine("a-manufacturer-of-two-lines", DicomBytes().text(0x0008, 0x0070, "LO", "a\nb").picture(4, 2, 2),
                  {"a\nb"}),
        foundCine("a-manufacturer-of-20000-letters",
                  DicomBytes().text(0x0008, 0x0070, "LO", std::string(20000, 'm')).picture(4, 2, 2), {"mmmm"}),
        foundCine("no-photometric-interpretation", withoutPhotometric(), {"Photometric"}),
    };
}

}  // namespace echolucent
