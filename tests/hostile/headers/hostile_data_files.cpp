// Volumes whose voxels lie in several data files that do not fit, are written as text or compressed wrongly.
#include <fmt/format.h>

#include "bzip2_bytes.h"
#include "hostile_file.h"
#include "nifti_files.h"
#include "split_volume.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

/// A header beside four good slices s0.raw to s3.raw of the volume, of which `third` is in place of the third.
HostileFile header(const std::string& name, const std::string& text, std::vector<std::string> words,
                   const std::string& third = splitVoxels().substr(24, 12)) {
    HostileFile row = hostileFile("data-files/" + name, "v.nhdr", text, std::move(words));
    row.write = [text, third](const std::filesystem::path& folder) {
        for (std::size_t z = 0; z < 4; ++z)
            writeBytes(folder / fmt::format("s{}.raw", z), z == 2 ? third : splitVoxels().substr(z * 12, 12));
        writeBytes(folder / "sub" / "n.raw", splitVoxels());
        writeBytes(folder / "v.nhdr", text);
    };
    return row;
}

HostileFile list(const std::string& name, const std::string& data, const std::string& words) {
    return header(name, splitNrrd("encoding: raw\ndata file: " + data), {words});
}

std::vector<HostileFile> wrongLists() {
    return {
        list("an-empty-list", "LIST\n", "data file names 0 data files where the volume has 4 parts"),
        list("a-list-that-is-too-short", "LIST\ns0.raw\ns1.raw\ns2.raw\n",
             "names 3 data files where the volume has 4 parts"),
        list("a-list-that-cannot-share-the-slices", "LIST 3\ns0.raw\ns1.raw\ns2.raw\n",
             "names 3 data files, which cannot share 4 slices"),
        list("a-list-of-files-of-7-dimensions", "LIST 7\ns0.raw\n", "gives each file 7 dimensions; it must be 2 to 3"),
        list("a-list-of-files-of-x-dimensions", "LIST x\ns0.raw\n", "must be LIST and the dimensions of each file"),
        list("a-list-with-a-file-that-is-missing", "LIST\ns0.raw\ns1.raw\ns2.raw\nmissing.raw\n",
             "missing.raw: could not be opened"),
        list("a-list-with-a-file-above", "LIST\ns0.raw\ns1.raw\ns2.raw\n../s3.raw\n", "own folder"),
        list("a-list-with-a-file-anywhere", "LIST\ns0.raw\ns1.raw\ns2.raw\n/etc/passwd\n", "own folder"),
        list("a-list-with-a-file-above-behind-a-backslash", "LIST\ns0.raw\ns1.raw\ns2.raw\n..\\s3.raw\n", "own folder"),
        list("a-list-with-a-file-above-over-a-folder-before-a-backslash",
             "LIST\ns0.raw\ns1.raw\ns2.raw\nsub\\../..\\s3.raw\n", "own folder"),
        list("a-list-with-a-file-on-a-drive", "LIST\ns0.raw\ns1.raw\ns2.raw\nC:\\s3.raw\n", "own folder"),
        list("a-list-with-a-file-of-another-machine", "LIST\ns0.raw\ns1.raw\ns2.raw\n\\\\host\\s3.raw\n", "own folder"),
        list("a-list-with-a-file-above-over-a-folder-below", "LIST\ns0.raw\ns1.raw\ns2.raw\nsub/../../s3.raw\n",
             "own folder"),
        header("a-list-of-metaimage-of-files-of-1-dimension", splitMetaImage("ElementDataFile = LIST 1\ns0.raw\n"),
               {"2 to 3"}),
        header("a-list-of-metaimage-that-is-too-short", splitMetaImage("ElementDataFile = LIST\ns0.raw\n"),
               {"names 1 data files"}),
        header("a-compressed-size-beside-a-list",
               splitMetaImage("CompressedData = True\nCompressedDataSize = 9\nElementDataFile = LIST\ns0.raw\n"),
               {"CompressedDataSize is one number beside several data files"}),
        header("a-list-without-end",
               splitNrrd("encoding: raw\ndata file: LIST\n") + std::string(std::size_t{2} << 20, 'x'),
               {"begins a list that is longer than 1048576 bytes"}),
        header("a-list-of-metaimage-without-end",
               splitMetaImage("ElementDataFile = LIST\n") + std::string(std::size_t{2} << 20, 'x'),
               {"begins a list that is longer than 1048576 bytes"}),
    };
}

HostileFile listOf20000() {
    std::string many = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1 1 20000\nencoding: raw\ndata file: LIST\n";
    for (int i = 0; i < 20000; ++i) many += "s0.raw\n";
    return header("a-list-of-20000-files", many, {"names 20000 data files, more than the 10000 that are read"});
}

std::vector<HostileFile> wrongPatterns() {
    std::vector<HostileFile> rows{
        list("a-pattern-without-a-step", "s%d.raw 0 3\n",
             "must be a pattern with the first number, the last and the step"),
        list("a-pattern-of-step-0", "s%d.raw 0 3 0\n", "in steps of 0, which never ends"),
        list("a-pattern-that-counts-away", "s%d.raw 0 3 -1\n", "in steps of -1, which never ends"),
        list("a-pattern-of-a-billion-files", "s%d.raw 0 1000000000 1\n",
             "names 1000000001 data files, more than the 10000"),
        list("a-pattern-up-to-the-largest-number", "s%d.raw 0 9223372036854775807 1\n",
             "counts with 9223372036854775807"),
        list("a-pattern-that-is-too-short", "s%d.raw 0 2 1\n", "names 3 data files where the volume has 4 parts"),
        list("a-pattern-with-a-number-in-the-folder", "%d/../../s%d.raw 0 3 1\n", "no pattern with one number"),
        list("a-pattern-above", "../s%d.raw 0 3 1\n", "own folder"),
        header("a-pattern-with-a-short-file", splitNrrd("encoding: raw\ndata file: s%d.raw 0 3 1\n"),
               {"sizes declares 48 bytes", "12 in each of 4 files", "s2.raw holds only 5"}, "short"),
        header("a-pattern-of-metaimage-that-writes", splitMetaImage("ElementDataFile = s%n.raw 0 3 1\n"),
               {"no pattern"}),
        header("a-pattern-of-metaimage-of-step-x", splitMetaImage("ElementDataFile = s%d.raw 0 3 x\n"),
               {"neither that file nor the first of that pattern, \"s1.raw 0 3 x\""}),
        header("a-name-with-a-percent-sign", splitNrrd("encoding: raw\ndata file: 50%.raw\n"),
               {"\"50%.raw\", which is no pattern", "no file of that name lies beside"}),
        header("a-name-of-metaimage-with-a-percent-sign", splitMetaImage("ElementDataFile = 50%.raw\n"),
               {"\"50%.raw\", which is no pattern", "no file of that name lies beside"}),
    };
    const std::vector<std::pair<std::string, std::string>> patterns{
        {"that-writes", "s%n.raw"},        {"of-a-text", "s%s.raw"},           {"of-two-numbers", "s%d%d.raw"},
        {"of-999-digits", "s%999d.raw"},   {"of-digits-below-0", "s%-3d.raw"}, {"without-a-conversion", "s%.raw"},
        {"that-ends-with-its-sign", "s%"}, {"of-a-long-number", "s%ld.raw"}};
    for (const auto& [name, pattern] : patterns)
        rows.push_back(list("a-pattern-" + name, pattern + " 0 3 1\n", "which is no pattern with one number"));
    return rows;
}

HostileFile linkOut(const std::string& name, const std::string& data) {
    HostileFile row = hostileFile("data-files/" + name, "study/v.nhdr", "", {"own folder"});
    row.write = [data](const std::filesystem::path& folder) {
        writeBytes(folder / "elsewhere" / "secret.raw", splitVoxels());
        writeBytes(folder / "study" / "v.nhdr", splitNrrd("encoding: raw\ndata file: " + data + "\n"));
        std::filesystem::create_symlink("../elsewhere/secret.raw", folder / "study" / "link.raw");
        std::filesystem::create_symlink("../elsewhere/secret.raw", folder / "study" / "100%.raw");
        std::filesystem::create_directory_symlink("../elsewhere", folder / "study" / "out");
    };
    row.words = {"does not lie in or below the header's own folder"};
    return row;
}

/// A header over a data file that begins with another header.
HostileFile over(const std::string& name, const std::string& fields, const std::string& bytes,
                 std::vector<std::string> words, HostileOutcome outcome = HostileOutcome::refused) {
    HostileFile row = header("over-" + name, splitNrrd(fields + "data file: s2.raw\n"), std::move(words), bytes);
    row.outcome = outcome;
    return row;
}

std::vector<HostileFile> wrappedHeaders() {
    const std::string raw = "encoding: raw\n", gzip = "encoding: gzip\n";
    const auto nifti = [](double offset) {
        NiftiFields fields;
        fields.voxOffset = offset;
        return niftiHeader(fields) + splitVoxels();
    };
    const auto packed = [](const std::string& bytes) { return deflated(bytes, 31); };
    const std::vector<std::string> stands{"takes \"s2.raw\" for voxels, where a NIfTI header stands"};
    std::vector<HostileFile> rows{
        over("a-nifti", raw, nifti(352), {"A NIfTI header stands where the voxels of s2.raw should begin"},
             HostileOutcome::opensWithNote),
        over("a-packed-nifti", gzip, packed(nifti(352)), {"A NIfTI header stands"}, HostileOutcome::opensWithNote),
        over("a-nifti-packed-in-secret", raw, packed(nifti(352)), {"holds gzip", "A NIfTI header stands"},
             HostileOutcome::opensWithNote),
        over("a-nifti-and-more", raw, nifti(352) + "more", stands),
        over("a-packed-nifti-and-more", gzip, packed(nifti(352) + "more"), stands),
        over("a-cut-nifti", raw, nifti(352).substr(0, 380), stands),
        over("text-without-end", raw, "NRRD0004\n" + std::string(std::size_t{2} << 20, 'x'),
             {"where an NRRD file stands"}),
        over("packed-text-without-end", gzip, packed("NDims = 3\n" + std::string(std::size_t{2} << 20, 'x')),
             {"where a MetaImage stands"}),
        over("gzip-at-the-end-of-which-voxels-are-missing", "byte skip: -1\n" + gzip, packed("few"), {"only 3"}),
        header("over-gzip-with-3-gb-declared-at-its-end",
               "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1500 1500 1400\nbyte skip: -1\nencoding: gzip\n"
               "data file: s2.raw\n",
               {"sizes"}, packed(std::string(std::size_t{4} << 20, '\0'))),
        over("gzip-of-which-half-is-missing", "byte skip: -1\n" + gzip,
             packed(splitVoxels() + splitVoxels()).substr(0, 20), {"s2.raw"}),
        over("gzip-that-begins-like-it", raw, "\x1f\x8b\x08" + std::string(60, 'v'), {"holds gzip"},
             HostileOutcome::opens)};
    for (const double offset : {-5.0, 1e30, 100.0})
        rows.push_back(over(fmt::format("a-nifti-of-offset-{}", offset), raw, nifti(offset), stands));
    return rows;
}

HostileFile attached(const std::string& name, const std::string& encoding, const std::string& bytes,
                     std::vector<std::string> words) {
    return header(name, splitNrrd("encoding: " + encoding + "\n\n") + bytes, std::move(words));
}

std::vector<HostileFile> wrongText() {
    const std::vector<std::string> cut{"ends directly after its last number, which may have been cut"};
    const std::string allButADigit = splitVoxelsAsText.substr(0, splitVoxelsAsText.size() - 1);
    return {
        attached("text-of-three-numbers", "ascii", "1 2 3", {"sizes declares 48 bytes", "only 5 characters"}),
        attached("text-of-three-numbers-and-spaces", "ascii", "1 2 3" + std::string(200, ' '),
                 {"holds only 6 bytes of voxels where 48"}),
        hostileFile("data-files/nrrd-text-cut-within-its-last-number", "v.nrrd",
                    splitNrrd("encoding: ascii\n\n") + allButADigit, cut, HostileOutcome::opensWithNote),
        hostileFile("data-files/metaimage-text-cut-within-its-last-number", "v.mha",
                    splitMetaImage("BinaryData = False\nElementDataFile = LOCAL\n") + allButADigit, cut,
                    HostileOutcome::opensWithNote),
        hostileFile("data-files/text-that-ends-with-its-line", "v.nrrd",
                    splitNrrd("encoding: ascii\n\n") + splitVoxelsAsText + "\n", cut, HostileOutcome::opens),
        attached("text-with-a-word", "ascii", "1 2 three " + splitVoxelsAsText,
                 {"has text that is no voxel of its type near byte"}),
        attached("text-with-a-number-below-its-type", "ascii", "1 2 -3 " + splitVoxelsAsText, {"no voxel of its type"}),
        attached("text-with-a-number-above-its-type", "ascii", "1 2 65536 " + splitVoxelsAsText, {"\"65536\""}),
        attached("text-with-a-fraction", "ascii", "1 2 1.5 " + splitVoxelsAsText, {"\"1.5\""}),
        attached("text-with-three-million-digits", "ascii",
                 "1 2 " + std::string(3 << 20, '7') + " " + splitVoxelsAsText, {"no voxel of its type"}),
        attached("too-few-hexadecimal-digits", "hex", std::string(40, '0'), {"characters for them"}),
        attached("letters-that-are-no-hexadecimal-digits", "hex", "xy" + std::string(96, '1'),
                 {"no hexadecimal digit"}),
        header(
            "text-that-is-compressed",
            splitMetaImage("BinaryData = False\nCompressedData = True\nElementDataFile = LOCAL\n") + splitVoxelsAsText,
            {"CompressedData is True beside BinaryData = False"}),
    };
}

std::string flippedAt(std::string bytes, std::size_t place) {
    bytes[place] = static_cast<char>(bytes[place] ^ 1);
    return bytes;
}

std::vector<HostileFile> wrongCompression() {
    const std::string zlib = deflated(splitVoxels()), gzip = deflated(splitVoxels(), 31),
                      bzip2 = bzipped(splitVoxels());
    const std::string local = splitMetaImage("CompressedData = True\nElementDataFile = LOCAL\n");
    const std::string members = deflated(splitVoxels().substr(0, 7), 31) + deflated("", 31) +
                                deflated(splitVoxels().substr(7, 20), 31) + deflated(splitVoxels().substr(27), 31);
    const std::string whole = deflated(local + zlib, 31);
    std::vector<HostileFile> rows{
        attached("bzip2-that-is-none", "bzip2", "no bzip2 at all, though long enough",
                 {"has damaged compressed data near byte"}),
        attached("bzip2-that-is-cut", "bzip2", bzip2.substr(0, 30), {"where"}),
        attached("bzip2-one-voxel-too-short", "bzip2", bzipped(splitVoxels().substr(2)), {"only 46"}),
        attached("bzip2-with-a-false-sum", "bzip2", flippedAt(bzip2, 12), {"its checksum (CRC) does not match"}),
        header("zlib-with-a-false-sum", local + flippedAt(zlib, zlib.size() - 1),
               {"has damaged compressed data near byte"}),
        header("gzip-in-metaimage-with-a-false-sum", local + flippedAt(gzip, gzip.size() - 7),
               {"has damaged compressed data near byte"}),
        attached("gzip-of-four-members-of-which-the-last-is-false", "gzip", flippedAt(members, members.size() - 5),
                 {"has damaged compressed data"}),
        attached("gzip-of-four-members-that-is-cut", "gzip", members.substr(0, 70), {"where"}),
        hostileFile("data-files/a-gzip-file-with-a-false-sum", "v.mha.gz", flippedAt(whole, whole.size() - 7),
                    {"has damaged compressed data near byte"}),
        hostileFile("data-files/a-gzip-file-with-a-false-length", "v.mha.gz", flippedAt(whole, whole.size() - 2),
                    {"has damaged compressed data near byte"}),
        hostileFile("data-files/a-gzip-file-packed-twice", "v.mha.gz", deflated(whole, 31),
                    {"compressed with gzip twice"}),
        hostileFile("data-files/a-gzip-file-of-something-else", "v.dat.gz", deflated("nothing known", 31),
                    {"is no MetaImage, NRRD, NIfTI, DICOM or GE Voluson (Kretz) file"}),
    };
    for (const std::size_t length :
         {std::size_t{3}, std::size_t{10}, std::size_t{11}, whole.size() / 2, whole.size() - 8, whole.size() - 1})
        rows.push_back(hostileFile(fmt::format("data-files/a-gzip-file-cut-to-{}-bytes", length), "v.mha.gz",
                                   whole.substr(0, length), {"is gzip that ends too early"}));
    return rows;
}

}  // namespace

std::vector<HostileFile> hostileDataFiles() {
    std::vector<HostileFile> all{listOf20000(), linkOut("a-link-out-of-the-folder", "link.raw"),
                                 linkOut("a-link-with-a-percent-sign-out-of-the-folder", "100%.raw"),
                                 linkOut("a-linked-folder-out-of-the-folder", "out/secret.raw")};
    for (const auto rows : {wrongLists, wrongPatterns, wrappedHeaders, wrongText, wrongCompression})
        for (HostileFile& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace echolucent
