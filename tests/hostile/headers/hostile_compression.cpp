// Hostile gzip, zlib and bzip2: flipped bits, cut streams, bombs, in every format that may be compressed.
#include <string>
#include <utility>
#include <vector>

#include "bzip2_bytes.h"
#include "hostile_file.h"
#include "kretz_files.h"
#include "nifti_files.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

/// The largest blocks that bzip2 knows.
constexpr int largestBlock = 9;
constexpr int zlibFormat = 15, gzipFormat = 31;

/// Voxels that are hard to compress, so that a flipped bit in them leaves a stream of the same length.
std::string speckledVoxels() {
    std::string bytes;
    std::uint32_t state = 1;
    for (int i = 0; i < 16 * 16 * 16; ++i) {
        state = state * 1664525U + 1013904223U;
        bytes += static_cast<char>(40 + (state >> 24) % 60);
    }
    return bytes;
}

std::string packedMha(const std::string& keys, const std::string& size = "16 16 16") {
    return "ObjectType = Image\nNDims = 3\nDimSize = " + size +
           "\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nCompressedData = True\n" + keys +
           "ElementDataFile = LOCAL\n";
}
std::string packedNrrd(const std::string& encoding, const std::string& size = "16 16 16") {
    return "NRRD0004\ntype: uchar\ndimension: 3\nsizes: " + size + "\nspacings: 1 1 1\nencoding: " + encoding + "\n\n";
}

std::string flipped(std::string bytes, std::size_t place, int bit = 0) {
    bytes.at(place) = static_cast<char>(bytes.at(place) ^ (1 << bit));
    return bytes;
}

HostileFile row(const std::string& name, const std::string& file, const std::string& bytes,
                const std::vector<std::string>& words, HostileOutcome outcome = HostileOutcome::refused) {
    return hostileFile("compression/" + name, file, bytes, words, outcome);
}

/// A stream inside a file, by the name of its checksum.
struct Stream {
    std::string name, file, header, packed, checksum;
    std::size_t tail;  ///< bytes at its end that are checksum and length
};

std::vector<Stream> streams() {
    return {{"mha-zlib", "v.mha", packedMha(""), deflated(speckledVoxels(), zlibFormat), "Adler-32", 4},
            {"mha-gzip", "v.mha", packedMha(""), deflated(speckledVoxels(), gzipFormat), "CRC-32", 8},
            {"nrrd-gzip", "v.nrrd", packedNrrd("gzip"), deflated(speckledVoxels(), gzipFormat), "CRC-32", 8},
            {"nrrd-bzip2", "v.nrrd", packedNrrd("bzip2"), bzipped(speckledVoxels(), largestBlock), "CRC", 4}};
}

/// Each stream with one flipped bit at several places, and cut within its data and its checksum.
std::vector<HostileFile> damagedStreams() {
    std::vector<HostileFile> rows;
    for (const Stream& stream : streams()) {
        const std::size_t size = stream.packed.size();
        for (const std::size_t eighth : {2U, 3U, 4U, 5U, 6U, 7U})
            rows.push_back(row(stream.name + "-bit-flipped-at-" + std::to_string(eighth) + "-eighths", stream.file,
                               stream.header + flipped(stream.packed, size * eighth / 8, static_cast<int>(eighth) % 8),
                               {"damaged"}));
        const bool gzip = stream.tail == 8;
        rows.push_back(row(stream.name + "-checksum-flipped", stream.file,
                           stream.header + flipped(stream.packed, size - stream.tail + 1),
                           {"has damaged compressed data near byte", stream.checksum}));
        if (gzip)
            rows.push_back(row(stream.name + "-length-flipped", stream.file,
                               stream.header + flipped(stream.packed, size - 2), {"the length beside their checksum"}));
        for (const std::size_t missing : {std::size_t{1}, stream.tail - 1, stream.tail})
            rows.push_back(row(stream.name + "-cut-by-" + std::to_string(missing), stream.file,
                               stream.header + stream.packed.substr(0, size - missing),
                               {stream.name == "nrrd-bzip2" ? "damaged" : "ends within its compressed data"}));
        rows.push_back(row(stream.name + "-cut-in-half", stream.file, stream.header + stream.packed.substr(0, size / 2),
                           {"where", "incomplete"}));
        rows.push_back(row(stream.name + "-of-nothing", stream.file, stream.header, {"holds none", "incomplete"}));
        rows.push_back(row(stream.name + "-followed-by-rubbish", stream.file, stream.header + stream.packed + "rubbish",
                           {"damaged"}, HostileOutcome::opens));
    }
    return rows;
}

/// Files that were packed as a whole.
std::vector<HostileFile> packedFiles() {
    const std::string meta =
        "ObjectType = Image\nNDims = 3\nDimSize = 16 16 16\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
        "ElementDataFile = LOCAL\n" +
        speckledVoxels();
    NiftiFields fields;
    fields.dim = {3, 16, 16, 16};
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.mha.gz", meta}, {"v.nii.gz", niftiHeader(fields) + speckledVoxels()}, {"v.vol.gz", KretzParts{}.bytes()}};
    std::vector<HostileFile> rows;
    for (const auto& [file, bytes] : files) {
        const std::string packed = deflated(bytes, gzipFormat);
        rows.push_back(row("a-flipped-bit-in-" + file, file, flipped(packed, packed.size() * 2 / 3, 3), {"damaged"}));
        rows.push_back(row("a-flipped-checksum-of-" + file, file, flipped(packed, packed.size() - 6), {"CRC-32"}));
        rows.push_back(row("a-flipped-length-of-" + file, file, flipped(packed, packed.size() - 1, 6), {"length"}));
        for (const std::size_t kept : {std::size_t{1}, std::size_t{2}, std::size_t{9}, packed.size() / 2,
                                       packed.size() - 8, packed.size() - 4, packed.size() - 1})
            rows.push_back(row("cut-to-" + std::to_string(kept) + "-bytes-of-" + file, file, packed.substr(0, kept),
                               {kept < 3 ? "ends after" : "is gzip that ends too early", "incomplete"}));
        rows.push_back(row("packed-twice-" + file, file, deflated(packed, gzipFormat), {"compressed with gzip twice"}));
    }
    rows.push_back(row("a-method-that-is-not-known", "v.mha.gz", flipped(deflated(meta, gzipFormat), 3, 7),
                       {"they begin like neither zlib nor gzip"}));
    return rows;
}

/// Streams that are far longer than what they claim to hold, and claims that are far larger than the streams.
std::vector<HostileFile> bombs() {
    constexpr std::size_t mebibyte = std::size_t{1} << 20;
    const auto repeated = [](const std::string& bytes, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += bytes;
        return all;
    };
    const std::string zeros = deflated(std::string(32 * mebibyte, '\0'), gzipFormat);
    const std::string bzippedZeros = bzipped(std::string(16 * mebibyte, '\0'), largestBlock);
    const std::vector<std::string> memory{"MiB of memory"}, goesOn{"go on for more than 268435456 bytes"};
    const std::string phases =
        "ObjectType = Image\nNDims = 4\nDimSize = 1 1 2 10000000\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
    return {
        row("gzip-of-512-mib-behind-the-voxels", "v.nrrd", packedNrrd("gzip", "2 3 4") + repeated(zeros, 16), goesOn),
        row("bzip2-of-512-mib-behind-the-voxels", "v.nrrd", packedNrrd("bzip2", "2 3 4") + repeated(bzippedZeros, 32),
            goesOn),
        row("gzip-of-512-mib-of-voxels", "v.nrrd", packedNrrd("gzip", "1024 1024 512") + repeated(zeros, 16), memory),
        row("zlib-of-512-mib-called-raw", "v.nrrd",
            packedNrrd("raw", "1024 128 1") + deflated(std::string(512 * mebibyte, '\0')),
            {"bytes more than the declared voxels"}, HostileOutcome::opensWithNote),
        row("gzip-of-512-mib-called-raw", "v.nrrd", packedNrrd("raw", "1024 1024 512") + repeated(zeros, 16), memory),
        row("zlib-claiming-1-gib", "v.mha",
            packedMha("", "1024 1024 1024") + deflated(std::string(32 * mebibyte, '\0'), zlibFormat),
            {"declares 1073741824 bytes of voxels"}),
        row("bzip2-claiming-30-gb", "v.nrrd", packedNrrd("bzip2", "3000 3000 3000") + bzippedZeros, memory),
        row("bzip2-claiming-2-to-the-62", "v.nrrd", packedNrrd("bzip2", "1 1 4611686018427387904") + bzippedZeros,
            memory),
        row("gzip-claiming-64-mib-of-24-bytes", "v.nrrd",
            packedNrrd("gzip", "64 1024 1024") + deflated(std::string(24, 'v'), gzipFormat) + std::string(70000, 'x'),
            {"the compressed data hold only 24"}),
        row("a-file-of-512-mib", "v.nii.gz", repeated(zeros, 16), {"unpacks to more than 268435456 bytes"}),
        row("20-kb-with-10-million-phases", "v.mha.gz", deflated(phases + std::string(2 * 10000000, '\0'), gzipFormat),
            {"makes 10000000 phases"}),
        row("a-size-beyond-the-file", "v.mha", packedMha("CompressedDataSize = 90000\n") + deflated(speckledVoxels()),
            {"CompressedDataSize declares 90000 bytes", "incomplete"}),
        row("a-size-within-the-stream", "v.mha", packedMha("CompressedDataSize = 100\n") + deflated(speckledVoxels()),
            {"the compressed data hold only", "incomplete"}),
        row("no-compressed-data", "v.mha", packedMha("") + speckledVoxels(), {"they begin like neither zlib nor gzip"}),
        row("no-bzip2", "v.nrrd", packedNrrd("bzip2") + speckledVoxels(), {"they do not begin like bzip2"}),
        row("more-voxels-than-declared", "v.nrrd", packedNrrd("gzip") + deflated(speckledVoxels() + "more", gzipFormat),
            {"holds more than the declared voxels"}, HostileOutcome::opensWithNote),
        row("damage-behind-the-voxels", "v.nrrd",
            packedNrrd("gzip", "2 3 4") + flipped(deflated(speckledVoxels(), gzipFormat), 2000, 2), {"damaged"}),
    };
}

}  // namespace

std::vector<HostileFile> hostileCompression() {
    std::vector<HostileFile> rows = damagedStreams();
    for (const auto part : {packedFiles, bombs})
        for (HostileFile& one : part()) rows.push_back(std::move(one));
    return rows;
}

}  // namespace echolucent
