// NRRD files whose header is wrong, each with the words that its sentence must hold.
#include <stdexcept>

#include "hostile_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

std::string nrrd(const std::string& replaced, const std::string& with,
                 const std::string& voxels = std::string(24, 'v')) {
    std::string text = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\nencoding: raw\n";
    const auto place = text.find(replaced);
    if (place == std::string::npos) throw std::logic_error("the row replaces nothing: " + replaced);
    return text.replace(place, replaced.size(), with) + "\n" + voxels;
}

}  // namespace

std::vector<HostileFile> hostileMalformedNrrd() {
    const std::string encoding = "encoding: raw";
    const auto four = [](const std::string& more) {
        return "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 3 2 2\nencoding: raw\n" + more + "\n" +
               std::string(24, 'v');
    };
    return {
        hostileFile("malformed-nrrd/empty", "a.nrrd", "", {"ends after 0 bytes"}),
        hostileFile("malformed-nrrd/no-nrrd", "a.nrrd", "garbage", {"does not begin with NRRD"}),
        hostileFile("malformed-nrrd/version-9", "a.nrrd", nrrd("NRRD0004", "NRRD0009"), {"version", "0009"}),
        hostileFile("malformed-nrrd/a-line-without-a-colon", "a.nrrd", nrrd("dimension: 3", "dimension 3"),
                    {"line 3", "dimension 3"}),
        hostileFile("malformed-nrrd/without-the-empty-line", "a.nrrd",
                    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nencoding: raw\n", {"empty line"}),
        hostileFile("malformed-nrrd/without-a-type", "a.nrrd", nrrd("type: uchar\n", ""), {"type is missing"}),
        hostileFile("malformed-nrrd/an-unknown-type", "a.nrrd", nrrd("uchar", "block"), {"type", "\"block\""}),
        hostileFile("malformed-nrrd/without-a-dimension", "a.nrrd", nrrd("dimension: 3\n", ""),
                    {"dimension is missing"}),
        hostileFile("malformed-nrrd/of-two-dimensions", "a.nrrd", nrrd("dimension: 3", "dimension: 2"),
                    {"dimension is 2", "2D picture"}),
        hostileFile("malformed-nrrd/of-seven-dimensions", "a.nrrd", nrrd("dimension: 3", "dimension: 7"),
                    {"dimension must be 3 or 4"}),
        hostileFile("malformed-nrrd/without-sizes", "a.nrrd", nrrd("sizes: 2 3 4\n", ""), {"sizes is missing"}),
        hostileFile("malformed-nrrd/sizes-of-two-numbers", "a.nrrd", nrrd("2 3 4", "2 3"),
                    {"sizes must be 3 whole numbers above 0"}),
        hostileFile("malformed-nrrd/a-size-below-0", "a.nrrd", nrrd("2 3 4", "2 -3 4"),
                    {"sizes must be 3 whole numbers above 0"}),
        hostileFile("malformed-nrrd/a-size-of-0", "a.nrrd", nrrd("2 3 4", "2 0 4"),
                    {"sizes must be 3 whole numbers above 0"}),
        hostileFile("malformed-nrrd/sizes-that-overflow", "a.nrrd", nrrd("2 3 4", "9223372036854775807 2 2"),
                    {"sizes declares more voxels"}),
        hostileFile("malformed-nrrd/sizes-beyond-the-file", "a.nrrd", nrrd("2 3 4", "2 3 5"),
                    {"sizes declares 30 bytes", "holds only 24"}),
        hostileFile("malformed-nrrd/a-spacing-of-nan", "a.nrrd", nrrd("1 1 1", "1 nan 1"),
                    {"spacings must be finite and not 0"}),
        hostileFile("malformed-nrrd/a-spacing-of-0", "a.nrrd", nrrd("1 1 1", "1 0 1"),
                    {"spacings must be finite and not 0"}),
        hostileFile("malformed-nrrd/spacings-of-two-numbers", "a.nrrd", nrrd("1 1 1", "1 1"),
                    {"spacings must be 3 numbers"}),
        hostileFile("malformed-nrrd/text-voxels-that-are-too-few", "a.nrrd", nrrd(encoding, "encoding: ascii"),
                    {"sizes declares 24 bytes", "only 24 characters"}),
        hostileFile("malformed-nrrd/voxels-that-are-no-bzip2", "a.nrrd", nrrd(encoding, "encoding: bzip2"),
                    {"damaged compressed data", "do not begin like bzip2"}),
        hostileFile("malformed-nrrd/hexadecimal-voxels-that-are-too-few", "a.nrrd", nrrd(encoding, "encoding: hex"),
                    {"sizes declares 24 bytes", "only 24 characters"}),
        hostileFile("malformed-nrrd/an-unknown-encoding", "a.nrrd", nrrd(encoding, "encoding: zstd"),
                    {"encoding is \"zstd\", which is not known"}),
        hostileFile("malformed-nrrd/without-an-encoding", "a.nrrd", nrrd(encoding + "\n", ""), {"encoding is missing"}),
        hostileFile("malformed-nrrd/without-an-endian", "a.nrrd", nrrd("uchar", "short"), {"endian is missing"}),
        hostileFile("malformed-nrrd/an-unknown-endian", "a.nrrd", nrrd(encoding, "endian: middle\n" + encoding),
                    {"endian must be little or big"}),
        hostileFile("malformed-nrrd/two-kinds-for-three-axes", "a.nrrd",
                    nrrd(encoding, "kinds: domain domain\n" + encoding), {"kinds must be 3 words"}),
        hostileFile("malformed-nrrd/two-directions-for-three-axes", "a.nrrd",
                    nrrd(encoding, "space directions: (1,0,0) (0,1,0)\n" + encoding),
                    {"space directions must be 3 vectors"}),
        hostileFile("malformed-nrrd/a-direction-without-its-bracket", "a.nrrd",
                    nrrd(encoding, "space directions: (1,0,0 (0,1,0) (0,0,1)\n" + encoding), {"space directions"}),
        hostileFile("malformed-nrrd/a-direction-of-none", "a.nrrd",
                    nrrd(encoding, "space directions: (1,0,0) (0,1,0) none\n" + encoding),
                    {"space directions must hold a vector"}),
        hostileFile("malformed-nrrd/a-direction-of-0", "a.nrrd",
                    nrrd(encoding, "space directions: (1,0,0) (0,1,0) (0,0,0)\n" + encoding),
                    {"space directions", "not 0"}),
        hostileFile("malformed-nrrd/a-direction-of-nan", "a.nrrd",
                    nrrd(encoding, "space directions: (1,0,0) (0,1,0) (0,0,nan)\n" + encoding),
                    {"space directions", "finite"}),
        hostileFile("malformed-nrrd/two-parallel-directions", "a.nrrd",
                    nrrd(encoding, "space directions: (1,0,0) (2,0,0) (0,0,1)\n" + encoding),
                    {"independent directions"}),
        hostileFile("malformed-nrrd/an-origin-of-two-numbers", "a.nrrd",
                    nrrd(encoding, "space origin: (1,2)\n" + encoding), {"space origin must be one vector"}),
        hostileFile("malformed-nrrd/an-unknown-space", "a.nrrd", nrrd(encoding, "space: upside-down\n" + encoding),
                    {"space is \"upside-down\""}),
        hostileFile("malformed-nrrd/a-byte-skip-below-minus-1", "a.nrrd", nrrd(encoding, "byte skip: -2\n" + encoding),
                    {"byte skip must be -1 or above"}),
        hostileFile("malformed-nrrd/a-byte-skip-beyond-the-file", "a.nrrd",
                    nrrd(encoding, "byte skip: 9223372036854775807\n" + encoding),
                    {"sizes declares 24 bytes", "holds only 0"}),
        hostileFile("malformed-nrrd/a-line-skip-beyond-the-file", "a.nrrd", nrrd(encoding, "line skip: 2\n" + encoding),
                    {"line skip is 2", "only 0 lines"}),
        hostileFile("malformed-nrrd/a-byte-skip-from-the-end-of-gzip", "a.nrrd",
                    nrrd(encoding, "byte skip: -1\nencoding: gzip"), {"byte skip must be 0 or above"}),
        hostileFile("malformed-nrrd/a-white-level-below-0", "a.nrrd", nrrd(encoding, "WhiteLevel:=-1\n" + encoding),
                    {"WhiteLevel must be a number above 0"}),
        hostileFile("malformed-nrrd/a-field-twice", "a.nrrd", nrrd(encoding, "sizes: 2 3 4\n" + encoding),
                    {"\"sizes\" appears twice"}),
        hostileFile("malformed-nrrd/a-data-file-above", "a.nhdr", nrrd(encoding, encoding + "\ndata file: ../x.raw"),
                    {"data file", "own folder"}),
        hostileFile("malformed-nrrd/a-data-file-anywhere", "a.nhdr",
                    nrrd(encoding, encoding + "\ndata file: /etc/passwd"), {"data file", "own folder"}),
        hostileFile("malformed-nrrd/a-list-without-files", "a.nhdr", nrrd(encoding, encoding + "\ndata file: LIST"),
                    {"data file names 1 data files where the volume has 4 parts"}),
        hostileFile("malformed-nrrd/a-pattern-without-files", "a.nhdr",
                    nrrd(encoding, encoding + "\ndata file: s%d.raw 0 3 1"), {"s0.raw", "could not be opened"}),
        hostileFile("malformed-nrrd/a-data-file-that-is-missing", "a.nhdr",
                    nrrd(encoding, encoding + "\ndata file: missing.raw"), {"missing.raw", "could not be opened"}),
        hostileFile("malformed-nrrd/voxels-that-are-no-gzip", "a.nrrd",
                    nrrd(encoding, "encoding: gzip", "this is not gzip, though long"), {"damaged compressed data"}),
        hostileFile("malformed-nrrd/gzip-with-too-few-voxels", "a.nrrd",
                    nrrd(encoding, "encoding: gzip", deflated(std::string(20, 'v'), 31)), {"holds only 20 bytes"}),
        hostileFile("malformed-nrrd/two-time-axes", "a.nrrd", four("kinds: time domain domain time\n"),
                    {"kinds names more than one axis"}),
        hostileFile("malformed-nrrd/a-time-axis-in-the-middle", "a.nrrd", four("kinds: domain time domain domain\n"),
                    {"kinds has its time axis in the middle"}),
        hostileFile("malformed-nrrd/four-axes-of-vectors", "a.nrrd", four("kinds: vector domain domain domain\n"),
                    {"kinds has an axis of kind \"vector\""}),
        hostileFile("malformed-nrrd/four-axes-of-colours", "a.nrrd", four("kinds: rgb-color domain domain domain\n"),
                    {"colour axis"}),
        hostileFile("malformed-nrrd/three-axes-of-colours", "a.nrrd",
                    nrrd(encoding, "kinds: RGB-color domain domain\n" + encoding), {"2D colour picture"}),
        hostileFile("malformed-nrrd/three-axes-of-vectors", "a.nrrd",
                    nrrd(encoding, "kinds: vector domain domain\n" + encoding), {"2D picture of several values"}),
        hostileFile("malformed-nrrd/an-origin-farther-than-any-scanner", "v.nrrd",
                    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nspace: left-posterior-superior\n"
                    "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,-1e308)\nencoding: raw\n\nvv",
                    {"space origin lies farther than 10 km"}),
    };
}

}  // namespace echolucent
