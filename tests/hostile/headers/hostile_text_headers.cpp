// Hostile MetaImage and NRRD files and raw layouts: sizes, places of voxels, spacings, kinds, links, cuts.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "hostile_file.h"
#include "hostile_text_parts.h"

namespace echolucent {

namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

const std::string mhaData = "ElementDataFile = LOCAL";
const std::string nrrdData = "encoding: raw";

HostileFile metaImageRow(const std::string& name, const std::string& bytes, const std::vector<std::string>& words,
                         HostileOutcome outcome = HostileOutcome::refused) {
    return hostileFile("metaimage/" + name, "v.mha", bytes, words, outcome);
}
HostileFile nrrdRow(const std::string& name, const std::string& bytes, const std::vector<std::string>& words,
                    HostileOutcome outcome = HostileOutcome::refused) {
    return hostileFile("nrrd/" + name, "v.nrrd", bytes, words, outcome);
}

/// A row of several files, of which the first is opened.
HostileFile several(const std::string& name, const Files& files, const std::vector<std::string>& words,
                    HostileOutcome outcome = HostileOutcome::refused) {
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
        writeBytes(folder / "elsewhere/secret.raw", textHeaderVoxels);
        std::filesystem::create_symlink(folder / "elsewhere/secret.raw", folder / "study" / link);
    };
    return row;
}

const std::string layoutBegin = R"({"format": "echolucent-raw-layout", "version": 1, )";

HostileFile rawLayout(const std::string& name, const std::string& json, const std::vector<std::string>& words) {
    return several("raw/" + name, {{"v.raw", textHeaderVoxels}, {"v.raw.echolucent.json", json}}, words);
}

std::vector<HostileFile> wrongPlacesOfVoxels() {
    return {
        metaImageRow("header-text-as-voxels", mhaWith(mhaData, "HeaderSize = -1\n" + mhaData, "123456789012"),
                     {"DimSize declares 24 bytes", "holds only 12 after its header"}),
        metaImageRow("voxels-at-the-end-of-the-file",
                     mhaWith(mhaData, "HeaderSize = -1\n" + mhaData, "xx" + textHeaderVoxels), {"header"},
                     HostileOutcome::opens),
        metaImageRow("header-size-within-the-header", mhaWith(mhaData, "HeaderSize = 20\n" + mhaData),
                     {"HeaderSize is 20"}),
        several("metaimage/names-itself", {{"v.mhd", mhaWith("LOCAL", "v.mhd")}}, {"is the header itself"}),
        several("metaimage/names-itself-with-a-dot", {{"v.mhd", mhaWith("LOCAL", "./v.mhd")}},
                {"is the header itself"}),
        several("metaimage/lists-itself", {{"v.mhd", mhaWith("LOCAL", "LIST", "v.mhd\nv.mhd\nv.mhd\nv.mhd\n")}},
                {"is the header itself"}),
        metaImageRow("names-a-missing-file", mhaWith("LOCAL", "gone.raw"), {"could not be opened: it does not exist"}),
        metaImageRow("names-nothing", mhaWith("LOCAL", ""), {"names no file", "incomplete"}),
        metaImageRow("names-a-folder", mhaWith("LOCAL", "."), {"own folder"}),
        linked("metaimage/a-link-out-of-the-folder", "v.mhd", mhaWith("LOCAL", "link.raw"), "link.raw"),
        linked("metaimage/a-listed-link-out-of-the-folder", "v.mhd", mhaWith("LOCAL", "LIST 3", "link.raw\n"),
               "link.raw"),
        linked("metaimage/a-pattern-of-links-out-of-the-folder", "v.mhd",
               mhaWith("DimSize = 2 3 4", "DimSize = 2 12 1")
                   .replace(mhaWith("2 3 4", "2 12 1").find("LOCAL"), 5, "link%d.raw 0 0"),
               "link0.raw"),
        nrrdRow("header-text-as-voxels", nrrdWith(nrrdData, "byte skip: -1\n" + nrrdData, "123456789012"),
                {"sizes declares 24 bytes", "holds only 12 after its header"}),
        nrrdRow("voxels-at-the-end-of-the-file",
                nrrdWith(nrrdData, "byte skip: -1\n" + nrrdData, "xx" + textHeaderVoxels), {"header"},
                HostileOutcome::opens),
        several("nrrd/names-itself", {{"v.nhdr", nrrdWith(nrrdData, nrrdData + "\ndata file: v.nhdr")}},
                {"is the header itself"}),
        several("nrrd/lists-itself",
                {{"v.nhdr", nrrdWith(nrrdData, nrrdData + "\ndata file: LIST\nv.nhdr\nv.nhdr", "")}}, {"data file"}),
        linked("nrrd/a-link-out-of-the-folder", "v.nhdr", nrrdWith(nrrdData, nrrdData + "\ndata file: link.raw"),
               "link.raw"),
        linked("nrrd/a-pattern-of-links-out-of-the-folder", "v.nhdr",
               nrrdWith(nrrdData, nrrdData + "\ndata file: link%d.raw 0 0 1 3"), "link0.raw"),
        nrrdRow("a-skip-of-2-to-the-63", nrrdWith(nrrdData, "byte skip: 9223372036854775807\nencoding: gzip"),
                {"byte skip is 9223372036854775807"}),
    };
}

std::vector<HostileFile> textHeaderSizes() {
    const std::vector<std::string> tooFew{"declares 27000000000 bytes", "incomplete"};
    std::vector<HostileFile> rows{
        metaImageRow("30-gb-raw", mhaWith("2 3 4", "3000 3000 3000"), tooFew),
        metaImageRow("30-gb-text", mhaWith("2 3 4\n", "3000 3000 3000\nBinaryData = False\n"), tooFew),
        metaImageRow("an-overflowing-size", mhaWith("2 3 4", "3037000500 3037000500 2"), {"more voxels than any file"}),
        metaImageRow("one-row-of-2-to-the-63", mhaWith("2 3 4", "1 1 9223372036854775807"), {"holds only 24"}),
        metaImageRow("doubles-of-2-to-the-60",
                     mhaWith("2 3 4\nElementSpacing = 1 1 1\nElementType = MET_UCHAR",
                             "1 1 1152921504606846976\nElementType = MET_DOUBLE"),
                     {"more voxels than any file"}),
        metaImageRow("a-size-of-2-to-the-64", mhaWith("2 3 4", "2 3 18446744073709551616"), {"DimSize must be 3"}),
        metaImageRow(
            "20-million-phases",
            mhaWith("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1", "NDims = 4\nDimSize = 1 1 2 20000000"),
            {"makes 20000000 phases", "no more than 4096"}),
        metaImageRow("4097-phases",
                     mhaWith("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1", "NDims = 4\nDimSize = 1 1 2 4097",
                             std::string(8194, 'v')),
                     {"makes 4097 phases"}),
        metaImageRow("4096-phases-of-two-voxels",
                     mhaWith("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1", "NDims = 4\nDimSize = 1 1 2 4096",
                             std::string(8192, 'v')),
                     {"phases"}, HostileOutcome::opens),
        metaImageRow("a-million-voxels-in-a-row", mhaWith("2 3 4", "1 1 1000000", std::string(1000000, 'v')),
                     {"1 x 1 x 1000000 voxels", "as long as its smallest spacing"}),
        nrrdRow("phases-fastest-of-20-million",
                nrrdWith("dimension: 3\nsizes: 2 3 4\nspacings: 1 1 1",
                         "dimension: 4\nsizes: 20000000 2 2 2\nkinds: time space space space"),
                {"makes 20000000 phases"}),
    };
    for (const char* encoding : {"raw", "gzip", "ascii", "hex"})
        rows.push_back(nrrdRow(std::string("30-gb-") + encoding,
                               nrrdWith("sizes: 2 3 4\nspacings: 1 1 1\nencoding: raw",
                                        "sizes: 3000 3000 3000\nencoding: " + std::string(encoding)),
                               tooFew));
    rows.push_back(
        nrrdRow("30-gb-bzip2",
                nrrdWith("sizes: 2 3 4\nspacings: 1 1 1\nencoding: raw", "sizes: 3000 3000 3000\nencoding: bzip2"),
                {"MiB of memory"}));
    return rows;
}

std::vector<HostileFile> textHeaderSpacings() {
    std::vector<HostileFile> rows;
    const std::vector<std::pair<std::string, std::vector<std::string>>> finite{
        {"nan", {"must be finite and not 0"}},  {"inf", {"must be finite and not 0"}},
        {"0", {"must be finite and not 0"}},    {"1e300", {"which no scanner makes"}},
        {"-1e300", {"which no scanner makes"}}, {"1e-310", {"which no scanner makes"}},
        {"1e999", {"must be 3 numbers"}},       {"1e3", {"more than 1000 times as long as wide"}}};
    for (const auto& [value, words] : finite) {
        const std::string all = value == "1e3" ? "1e3 0.1 1" : "1 " + value + " 1";
        rows.push_back(metaImageRow("spacing-of-" + value, mhaWith("1 1 1", all), words));
        rows.push_back(nrrdRow("spacing-of-" + value, nrrdWith("1 1 1", all), words));
    }
    rows.push_back(metaImageRow("negative-spacing", mhaWith("1 1 1", "1 -1 1"), {"ElementSpacing is negative along y"},
                                HostileOutcome::opensWithNote));
    rows.push_back(nrrdRow("negative-spacing", nrrdWith("1 1 1", "1 -1 1"), {"spacings is negative along y"},
                           HostileOutcome::opensWithNote));
    for (const char* step : {"(nan,0,0)", "(0,0,0)", "(1e300,1e300,0)", "(1e-310,0,0)"})
        rows.push_back(
            nrrdRow(std::string("a-step-of-") + step,
                    nrrdWith("spacings: 1 1 1", "space directions: " + std::string(step) + " (0,1,0) (0,0,1)"),
                    {"space directions"}));
    rows.push_back(
        metaImageRow("offset-of-1e300", mhaWith(mhaData, "Offset = 1e300 0 0\n" + mhaData), {"farther than 10 km"}));
    rows.push_back(metaImageRow("matrix-of-1e300",
                                mhaWith(mhaData, "TransformMatrix = 1e300 1e300 0 0 1 0 0 0 1\n" + mhaData),
                                {"TransformMatrix does not hold three independent directions"}));
    rows.push_back(
        nrrdRow("origin-of-nan", nrrdWith(nrrdData, "space origin: (nan,0,0)\n" + nrrdData), {"space origin"}));
    rows.push_back(nrrdRow("two-spacings", nrrdWith(nrrdData, "space directions: (2,0,0) (0,1,0) (0,0,1)\n" + nrrdData),
                           {"spacings gives 1 mm along x", "space directions counts"}, HostileOutcome::opensWithNote));
    return rows;
}

std::vector<HostileFile> contradictions() {
    const auto kinds = [](const std::string& sizes, const std::string& words) {
        return nrrdWith("dimension: 3\nsizes: 2 3 4\nspacings: 1 1 1",
                        "dimension: 4\nsizes: " + sizes + "\nkinds: " + words);
    };
    std::vector<HostileFile> rows{
        metaImageRow("two-byte-orders",
                     mhaWith(mhaData, "BinaryDataByteOrderMSB = True\nElementByteOrderMSB = False\n" + mhaData),
                     {"ElementByteOrderMSB is \"False\" beside BinaryDataByteOrderMSB"}),
        metaImageRow("two-offsets", mhaWith(mhaData, "Offset = 1 2 3\nOrigin = 3 2 1\n" + mhaData),
                     {"Origin is", "Offset"}),
        metaImageRow("one-offset-twice", mhaWith(mhaData, "Offset = 1 2 3\nOrigin = 1.0 2.0 3.0\n" + mhaData),
                     {"Offset"}, HostileOutcome::opens),
        metaImageRow("two-matrices",
                     mhaWith(mhaData, "TransformMatrix = 1 0 0 0 1 0 0 0 1\nRotation = 0 1 0 1 0 0 0 0 1\n" + mhaData),
                     {"Rotation is", "TransformMatrix"}),
        metaImageRow("kind-vector", mhaWith(mhaData, "Kinds = vector domain domain\n" + mhaData),
                     {"Kinds", "\"vector\""}),
        metaImageRow("kind-of-the-fourth-axis",
                     mhaWith("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\n",
                             "NDims = 4\nDimSize = 2 3 2 2\nKinds = domain domain domain 3-color\n"),
                     {"Kinds", "\"3-color\""}),
        metaImageRow("five-channels", mhaWith(mhaData, "ElementNumberOfChannels = 5\n" + mhaData),
                     {"ElementNumberOfChannels"}),
        metaImageRow("text-that-is-compressed",
                     mhaWith(mhaData, "BinaryData = False\nCompressedData = True\n" + mhaData),
                     {"CompressedData is True beside"}),
        nrrdRow("two-black-levels", nrrdWith(nrrdData, "BlackLevel:=-2\nBlackLevel:=-1\n" + nrrdData),
                {"BlackLevel appears twice"}),
        nrrdRow("two-white-levels", nrrdWith(nrrdData, "WhiteLevel:=200\nWhiteLevel:=100\n" + nrrdData),
                {"WhiteLevel appears twice"}),
        nrrdRow("a-vector-of-one", kinds("2 3 4 1", "space space space vector"), {"axis 4 \"vector\""},
                HostileOutcome::opensWithNote),
        nrrdRow("a-scalar-axis", kinds("1 2 3 4", "scalar space space space"), {"scalar"}, HostileOutcome::opens),
        nrrdRow("a-flat-vector-axis", nrrdWith("sizes: 2 3 4", "sizes: 2 12 1\nkinds: space space complex"),
                {"axis 3 \"complex\""}, HostileOutcome::opensWithNote),
        nrrdRow("time-in-the-middle", kinds("2 2 3 2", "space time space space"), {"time axis in the middle"}),
    };
    for (const char* kind : {"vector", "covariant-vector", "normal", "complex", "2-vector", "4-color", "quaternion",
                             "3D-symmetric-matrix", "point", "scalar", "tomato"}) {
        rows.push_back(nrrdRow(std::string("four-axes-of-kind-") + kind,
                               kinds("2 2 3 2", std::string("space space space ") + kind), {"kinds", "axis of kind"}));
        rows.push_back(nrrdRow(std::string("three-axes-of-kind-") + kind,
                               nrrdWith(nrrdData, "kinds: " + std::string(kind) + " space space\n" + nrrdData),
                               {"kinds", "2D picture of several values"}));
    }
    rows.push_back(nrrdRow("four-axes-of-hsv", kinds("3 2 2 2", "HSV-color space space space"), {"axis of kind"}));
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
        writeBytes(folder / "study/v.raw", textHeaderVoxels);
        writeBytes(folder / "elsewhere/layout.json", layoutBegin + R"("size": [2, 3, 4]})");
        std::filesystem::create_symlink(folder / "elsewhere/layout.json", folder / "study/v.raw.echolucent.json");
    };
    rows.push_back(std::move(link));
    return rows;
}

/// Files that end early, each in another part.
std::vector<HostileFile> textHeaderCuts() {
    const std::string text = mhaWith("NDims", "NDims"), other = nrrdWith("type", "type");
    const auto cut = [](const std::string& whole, const std::string& before, std::size_t more = 0) {
        return whole.substr(0, whole.find(before) + more);
    };
    return {
        metaImageRow("cut-in-its-first-word", text.substr(0, 6), {"MetaImage", "damaged"}),
        metaImageRow("cut-in-a-key", cut(text, "DimSize", 3), {"ends within line 3 of its header", "incomplete"}),
        metaImageRow("cut-in-a-value", cut(text, "2 3 4", 3), {"ElementDataFile is missing", "incomplete"}),
        metaImageRow("cut-in-LOCAL", cut(text, "LOCAL", 3), {"is cut off after \"LOC\"", "incomplete"}),
        metaImageRow("cut-in-its-voxels", text.substr(0, text.size() - 1), {"holds only 23", "incomplete"}),
        hostileFile("metaimage/cut-under-another-name", "v.dat", text.substr(0, 6), {"MetaImage", "incomplete"}),
        nrrdRow("cut-in-its-first-word", other.substr(0, 5), {"ends after 5 bytes", "incomplete"}),
        nrrdRow("cut-in-a-field", cut(other, "sizes", 3), {"ends within line 4 of its header", "incomplete"}),
        nrrdRow("cut-in-a-value", cut(other, "2 3 4", 3), {"empty line that ends it", "incomplete"}),
        nrrdRow("cut-before-the-empty-line", cut(other, "\n\n", 1), {"empty line that ends it", "incomplete"}),
        nrrdRow("cut-in-its-voxels", other.substr(0, other.size() - 1), {"holds only 23", "incomplete"}),
        hostileFile("nrrd/cut-under-another-name", "v.dat", other.substr(0, 5), {"NRRD", "incomplete"}),
    };
}

}  // namespace

std::vector<HostileFile> hostileTextHeaders() {
    std::vector<HostileFile> rows;
    for (const auto part :
         {wrongPlacesOfVoxels, textHeaderSizes, textHeaderSpacings, contradictions, layouts, textHeaderCuts})
        for (HostileFile& row : part()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace echolucent
