// Hostile MetaImage and NRRD files and raw layouts: sizes, places of voxels, spacings, kinds, links, cuts.
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hostile_file.h"

namespace echolucent {

namespace {

using Words = std::vector<std::string>;
using Files = std::vector<std::pair<std::string, std::string>>;
using Outcome = HostileOutcome;

const std::string voxels(24, 'v');

/// A MetaImage of 2 x 3 x 4 bytes with one part of its header replaced.
std::string mha(const std::string& replaced, const std::string& with, const std::string& data = voxels) {
    std::string text =
        "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
        "ElementDataFile = LOCAL\n";
    const auto place = text.find(replaced);
    if (place == std::string::npos) throw std::logic_error("the row replaces nothing: " + replaced);
    return text.replace(place, replaced.size(), with) + data;
}
const std::string mhaData = "ElementDataFile = LOCAL";

/// The same as an NRRD.
std::string nrrd(const std::string& replaced, const std::string& with, const std::string& data = voxels) {
    std::string text = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\nencoding: raw\n";
    const auto place = text.find(replaced);
    if (place == std::string::npos) throw std::logic_error("the row replaces nothing: " + replaced);
    return text.replace(place, replaced.size(), with) + "\n" + data;
}
const std::string nrrdData = "encoding: raw";

HostileFile metaImage(const std::string& name, const std::string& bytes, const Words& words,
                      Outcome outcome = Outcome::refused) {
    return hostileFile("metaimage/" + name, "v.mha", bytes, words, outcome);
}
HostileFile nrrdFile(const std::string& name, const std::string& bytes, const Words& words,
                     Outcome outcome = Outcome::refused) {
    return hostileFile("nrrd/" + name, "v.nrrd", bytes, words, outcome);
}

/// A row of several files, of which the first is opened.
HostileFile several(const std::string& name, const Files& files, const Words& words,
                    Outcome outcome = Outcome::refused) {
    HostileFile row = hostileFile(name, files.front().first, "", words, outcome);
    row.write = [files](const std::filesystem::path& folder) {
        for (const auto& [file, bytes] : files) writeBytes(folder / file, bytes);
    };
    return row;
}

/// A row whose header names a link that leads out of its folder.
HostileFile linked(const std::string& name, const std::string& file, const std::string& bytes,
                   const std::string& link) {
    HostileFile row = hostileFile(name, "study/" + file, "", {"own folder"});
    row.write = [=](const std::filesystem::path& folder) {
        writeBytes(folder / "study" / file, bytes);
        writeBytes(folder / "elsewhere/secret.raw", voxels);
        std::filesystem::create_symlink(folder / "elsewhere/secret.raw", folder / "study" / link);
    };
    return row;
}

const std::string layoutBegin = R"({"format": "echolucent-raw-layout", "version": 1, )";

HostileFile rawLayout(const std::string& name, const std::string& json, const Words& words) {
    return several("raw/" + name, {{"v.raw", voxels}, {"v.raw.echolucent.json", json}}, words);
}

std::vector<HostileFile> placesOfVoxels() {
    return {
        metaImage("header-text-as-voxels", mha(mhaData, "HeaderSize = -1\n" + mhaData, "123456789012"),
                  {"DimSize declares 24 bytes", "holds only 12 after its header"}),
        metaImage("voxels-at-the-end-of-the-file", mha(mhaData, "HeaderSize = -1\n" + mhaData, "xx" + voxels),
                  {"header"}, Outcome::opens),
        metaImage("header-size-within-the-header", mha(mhaData, "HeaderSize = 20\n" + mhaData), {"HeaderSize is 20"}),
        several("metaimage/names-itself", {{"v.mhd", mha("LOCAL", "v.mhd")}}, {"is the header itself"}),
        several("metaimage/names-itself-with-a-dot", {{"v.mhd", mha("LOCAL", "./v.mhd")}}, {"is the header itself"}),
        several("metaimage/lists-itself", {{"v.mhd", mha("LOCAL", "LIST", "v.mhd\nv.mhd\nv.mhd\nv.mhd\n")}},
                {"is the header itself"}),
        metaImage("names-a-missing-file", mha("LOCAL", "gone.raw"), {"could not be opened: it does not exist"}),
        metaImage("names-nothing", mha("LOCAL", ""), {"names no file", "incomplete"}),
        metaImage("names-a-folder", mha("LOCAL", "."), {"own folder"}),
        linked("metaimage/a-link-out-of-the-folder", "v.mhd", mha("LOCAL", "link.raw"), "link.raw"),
        linked("metaimage/a-listed-link-out-of-the-folder", "v.mhd", mha("LOCAL", "LIST 3", "link.raw\n"), "link.raw"),
        linked("metaimage/a-pattern-of-links-out-of-the-folder", "v.mhd",
               mha("DimSize = 2 3 4", "DimSize = 2 12 1")
                   .replace(mha("2 3 4", "2 12 1").find("LOCAL"), 5, "link%d.raw 0 0"),
               "link0.raw"),
        nrrdFile("header-text-as-voxels", nrrd(nrrdData, "byte skip: -1\n" + nrrdData, "123456789012"),
                 {"sizes declares 24 bytes", "holds only 12 after its header"}),
        nrrdFile("voxels-at-the-end-of-the-file", nrrd(nrrdData, "byte skip: -1\n" + nrrdData, "xx" + voxels),
                 {"header"}, Outcome::opens),
        several("nrrd/names-itself", {{"v.nhdr", nrrd(nrrdData, nrrdData + "\ndata file: v.nhdr")}},
                {"is the header itself"}),
        several("nrrd/lists-itself", {{"v.nhdr", nrrd(nrrdData, nrrdData + "\ndata file: LIST\nv.nhdr\nv.nhdr", "")}},
                {"data file"}),
        linked("nrrd/a-link-out-of-the-folder", "v.nhdr", nrrd(nrrdData, nrrdData + "\ndata file: link.raw"),
               "link.raw"),
        linked("nrrd/a-pattern-of-links-out-of-the-folder", "v.nhdr",
               nrrd(nrrdData, nrrdData + "\ndata file: link%d.raw 0 0 1 3"), "link0.raw"),
        nrrdFile("a-skip-of-2-to-the-63", nrrd(nrrdData, "byte skip: 9223372036854775807\nencoding: gzip"),
                 {"byte skip is 9223372036854775807"}),
    };
}

std::vector<HostileFile> sizes() {
    const Words tooFew{"declares 27000000000 bytes", "incomplete"};
    std::vector<HostileFile> rows{
        metaImage("30-gb-raw", mha("2 3 4", "3000 3000 3000"), tooFew),
        metaImage("30-gb-text", mha("2 3 4\n", "3000 3000 3000\nBinaryData = False\n"), tooFew),
        metaImage("an-overflowing-size", mha("2 3 4", "3037000500 3037000500 2"), {"more voxels than any file"}),
        metaImage("one-row-of-2-to-the-63", mha("2 3 4", "1 1 9223372036854775807"), {"holds only 24"}),
        metaImage("doubles-of-2-to-the-60",
                  mha("2 3 4\nElementSpacing = 1 1 1\nElementType = MET_UCHAR",
                      "1 1 1152921504606846976\nElementType = MET_DOUBLE"),
                  {"more voxels than any file"}),
        metaImage("a-size-of-2-to-the-64", mha("2 3 4", "2 3 18446744073709551616"), {"DimSize must be 3"}),
        metaImage("20-million-phases",
                  mha("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1", "NDims = 4\nDimSize = 1 1 2 20000000"),
                  {"makes 20000000 phases", "no more than 4096"}),
        metaImage("4097-phases",
                  mha("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1", "NDims = 4\nDimSize = 1 1 2 4097",
                      std::string(8194, 'v')),
                  {"makes 4097 phases"}),
        metaImage("4096-phases-of-two-voxels",
                  mha("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1", "NDims = 4\nDimSize = 1 1 2 4096",
                      std::string(8192, 'v')),
                  {"phases"}, Outcome::opens),
        metaImage("a-million-voxels-in-a-row", mha("2 3 4", "1 1 1000000", std::string(1000000, 'v')),
                  {"1 x 1 x 1000000 voxels", "as long as its smallest spacing"}),
        nrrdFile("phases-fastest-of-20-million",
                 nrrd("dimension: 3\nsizes: 2 3 4\nspacings: 1 1 1",
                      "dimension: 4\nsizes: 20000000 2 2 2\nkinds: time space space space"),
                 {"makes 20000000 phases"}),
    };
    for (const char* encoding : {"raw", "gzip", "ascii", "hex"})
        rows.push_back(nrrdFile(std::string("30-gb-") + encoding,
                                nrrd("sizes: 2 3 4\nspacings: 1 1 1\nencoding: raw",
                                     "sizes: 3000 3000 3000\nencoding: " + std::string(encoding)),
                                tooFew));
    rows.push_back(nrrdFile(
        "30-gb-bzip2", nrrd("sizes: 2 3 4\nspacings: 1 1 1\nencoding: raw", "sizes: 3000 3000 3000\nencoding: bzip2"),
        {"MiB of memory"}));
    return rows;
}

std::vector<HostileFile> spacings() {
    std::vector<HostileFile> rows;
    const std::vector<std::pair<std::string, Words>> finite{
        {"nan", {"must be finite and not 0"}},  {"inf", {"must be finite and not 0"}},
        {"0", {"must be finite and not 0"}},    {"1e300", {"which no scanner makes"}},
        {"-1e300", {"which no scanner makes"}}, {"1e-310", {"which no scanner makes"}},
        {"1e999", {"must be 3 numbers"}},       {"1e3", {"more than 1000 times as long as wide"}}};
    for (const auto& [value, words] : finite) {
        const std::string all = value == "1e3" ? "1e3 0.1 1" : "1 " + value + " 1";
        rows.push_back(metaImage("spacing-of-" + value, mha("1 1 1", all), words));
        rows.push_back(nrrdFile("spacing-of-" + value, nrrd("1 1 1", all), words));
    }
    rows.push_back(metaImage("negative-spacing", mha("1 1 1", "1 -1 1"), {"ElementSpacing is negative along y"},
                             Outcome::opensWithNote));
    rows.push_back(nrrdFile("negative-spacing", nrrd("1 1 1", "1 -1 1"), {"spacings is negative along y"},
                            Outcome::opensWithNote));
    for (const char* step : {"(nan,0,0)", "(0,0,0)", "(1e300,1e300,0)", "(1e-310,0,0)"})
        rows.push_back(nrrdFile(std::string("a-step-of-") + step,
                                nrrd("spacings: 1 1 1", "space directions: " + std::string(step) + " (0,1,0) (0,0,1)"),
                                {"space directions"}));
    rows.push_back(
        metaImage("offset-of-1e300", mha(mhaData, "Offset = 1e300 0 0\n" + mhaData), {"farther than 10 km"}));
    rows.push_back(metaImage("matrix-of-1e300", mha(mhaData, "TransformMatrix = 1e300 1e300 0 0 1 0 0 0 1\n" + mhaData),
                             {"TransformMatrix does not hold three independent directions"}));
    rows.push_back(nrrdFile("origin-of-nan", nrrd(nrrdData, "space origin: (nan,0,0)\n" + nrrdData), {"space origin"}));
    rows.push_back(nrrdFile("two-spacings", nrrd(nrrdData, "space directions: (2,0,0) (0,1,0) (0,0,1)\n" + nrrdData),
                            {"spacings gives 1 mm along x", "space directions counts"}, Outcome::opensWithNote));
    return rows;
}

std::vector<HostileFile> contradictions() {
    const auto kinds = [](const std::string& sizes, const std::string& words) {
        return nrrd("dimension: 3\nsizes: 2 3 4\nspacings: 1 1 1",
                    "dimension: 4\nsizes: " + sizes + "\nkinds: " + words);
    };
    std::vector<HostileFile> rows{
        metaImage("two-byte-orders",
                  mha(mhaData, "BinaryDataByteOrderMSB = True\nElementByteOrderMSB = False\n" + mhaData),
                  {"ElementByteOrderMSB is \"False\" beside BinaryDataByteOrderMSB"}),
        metaImage("two-offsets", mha(mhaData, "Offset = 1 2 3\nOrigin = 3 2 1\n" + mhaData), {"Origin is", "Offset"}),
        metaImage("one-offset-twice", mha(mhaData, "Offset = 1 2 3\nOrigin = 1.0 2.0 3.0\n" + mhaData), {"Offset"},
                  Outcome::opens),
        metaImage("two-matrices",
                  mha(mhaData, "TransformMatrix = 1 0 0 0 1 0 0 0 1\nRotation = 0 1 0 1 0 0 0 0 1\n" + mhaData),
                  {"Rotation is", "TransformMatrix"}),
        metaImage("kind-vector", mha(mhaData, "Kinds = vector domain domain\n" + mhaData), {"Kinds", "\"vector\""}),
        metaImage("kind-of-the-fourth-axis",
                  mha("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\n",
                      "NDims = 4\nDimSize = 2 3 2 2\nKinds = domain domain domain 3-color\n"),
                  {"Kinds", "\"3-color\""}),
        metaImage("five-channels", mha(mhaData, "ElementNumberOfChannels = 5\n" + mhaData),
                  {"ElementNumberOfChannels"}),
        metaImage("text-that-is-compressed", mha(mhaData, "BinaryData = False\nCompressedData = True\n" + mhaData),
                  {"CompressedData is True beside"}),
        nrrdFile("two-white-levels", nrrd(nrrdData, "WhiteLevel:=200\nWhiteLevel:=100\n" + nrrdData),
                 {"WhiteLevel appears twice"}),
        nrrdFile("a-vector-of-one", kinds("2 3 4 1", "space space space vector"), {"axis 4 \"vector\""},
                 Outcome::opensWithNote),
        nrrdFile("a-scalar-axis", kinds("1 2 3 4", "scalar space space space"), {"scalar"}, Outcome::opens),
        nrrdFile("a-flat-vector-axis", nrrd("sizes: 2 3 4", "sizes: 2 12 1\nkinds: space space complex"),
                 {"axis 3 \"complex\""}, Outcome::opensWithNote),
        nrrdFile("time-in-the-middle", kinds("2 2 3 2", "space time space space"), {"time axis in the middle"}),
    };
    for (const char* kind : {"vector", "covariant-vector", "normal", "complex", "2-vector", "4-color", "quaternion",
                             "3D-symmetric-matrix", "point", "scalar", "tomato"}) {
        rows.push_back(nrrdFile(std::string("four-axes-of-kind-") + kind,
                                kinds("2 2 3 2", std::string("space space space ") + kind), {"kinds", "axis of kind"}));
        rows.push_back(nrrdFile(std::string("three-axes-of-kind-") + kind,
                                nrrd(nrrdData, "kinds: " + std::string(kind) + " space space\n" + nrrdData),
                                {"kinds", "2D picture of several values"}));
    }
    rows.push_back(nrrdFile("four-axes-of-hsv", kinds("3 2 2 2", "HSV-color space space space"), {"axis of kind"}));
    return rows;
}

std::vector<HostileFile> layouts() {
    std::vector<HostileFile> rows{
        rawLayout("side-car-of-version-99", R"({"format": "echolucent-raw-layout", "version": 99, "size": [2, 3, 4]})",
                  {"version must be 1, not 99"}),
        rawLayout("side-car-of-version-1.5",
                  R"({"format": "echolucent-raw-layout", "version": 1.5, "size": [2, 3, 4]})",
                  {"version must be 1, not 1.5"}),
        rawLayout("side-car-with-a-size-of-24.9", layoutBegin + R"("size": [1, 1, 24.9]})", {"three whole numbers"}),
        rawLayout("side-car-with-a-size-of-1e18", layoutBegin + R"("size": [1, 1, 1e18]})", {"three whole numbers"}),
        rawLayout("side-car-with-an-overflowing-size", layoutBegin + R"("size": [1e15, 1e15, 1]})",
                  {"more voxels than any"}),
        rawLayout("side-car-that-is-cut", layoutBegin.substr(0, 30), {"is not JSON", "line 1"}),
        rawLayout("side-car-with-a-spacing-of-1e300",
                  layoutBegin + R"("size": [2, 3, 4], "spacing_mm": [1, 1e300, 1], "spacing_known": true})",
                  {"which no scanner makes"}),
        rawLayout("side-car-of-more-voxels", layoutBegin + R"("size": [2, 3, 5]})",
                  {"declares 30 bytes", "holds only 24"}),
        rawLayout("side-car-with-a-huge-header",
                  layoutBegin + R"("size": [2, 3, 4], "header_bytes": 9223372036854775807})", {"holds only 0"}),
    };
    HostileFile link =
        hostileFile("raw/side-car-is-a-link-out-of-the-folder", "study/v.raw", "", {"link out of its folder"});
    link.write = [](const std::filesystem::path& folder) {
        writeBytes(folder / "study/v.raw", voxels);
        writeBytes(folder / "elsewhere/layout.json", layoutBegin + R"("size": [2, 3, 4]})");
        std::filesystem::create_symlink(folder / "elsewhere/layout.json", folder / "study/v.raw.echolucent.json");
    };
    rows.push_back(std::move(link));
    return rows;
}

/// Files that end early, each in another part.
std::vector<HostileFile> cuts() {
    const std::string text = mha("NDims", "NDims"), other = nrrd("type", "type");
    const auto cut = [](const std::string& whole, const std::string& before, std::size_t more = 0) {
        return whole.substr(0, whole.find(before) + more);
    };
    return {
        metaImage("cut-in-its-first-word", text.substr(0, 6), {"MetaImage", "damaged"}),
        metaImage("cut-in-a-key", cut(text, "DimSize", 3), {"ends within line 3 of its header", "incomplete"}),
        metaImage("cut-in-a-value", cut(text, "2 3 4", 3), {"ElementDataFile is missing", "incomplete"}),
        metaImage("cut-in-LOCAL", cut(text, "LOCAL", 3), {"is cut off after \"LOC\"", "incomplete"}),
        metaImage("cut-in-its-voxels", text.substr(0, text.size() - 1), {"holds only 23", "incomplete"}),
        hostileFile("metaimage/cut-under-another-name", "v.dat", text.substr(0, 6), {"MetaImage", "incomplete"}),
        nrrdFile("cut-in-its-first-word", other.substr(0, 5), {"ends after 5 bytes", "incomplete"}),
        nrrdFile("cut-in-a-field", cut(other, "sizes", 3), {"ends within line 4 of its header", "incomplete"}),
        nrrdFile("cut-in-a-value", cut(other, "2 3 4", 3), {"empty line that ends it", "incomplete"}),
        nrrdFile("cut-before-the-empty-line", cut(other, "\n\n", 1), {"empty line that ends it", "incomplete"}),
        nrrdFile("cut-in-its-voxels", other.substr(0, other.size() - 1), {"holds only 23", "incomplete"}),
        hostileFile("nrrd/cut-under-another-name", "v.dat", other.substr(0, 5), {"NRRD", "incomplete"}),
    };
}

}  // namespace

std::vector<HostileFile> hostileTextHeaders() {
    std::vector<HostileFile> rows;
    for (const auto part : {placesOfVoxels, sizes, spacings, contradictions, layouts, cuts})
        for (HostileFile& row : part()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace echolucent
