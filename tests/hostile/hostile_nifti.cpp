// Hostile NIfTI files and pairs: sizes, places of voxels, scales, spacings, links, cuts.
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hostile_file.h"
#include "hostile_numbers.h"
#include "nifti_files.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

/// A NIfTI with some of its fields changed.
HostileFile nifti(const std::string& name, const std::function<void(NiftiFields&)>& change,
                  const std::vector<std::string>& words, HostileOutcome outcome = HostileOutcome::refused,
                  const std::string& voxels = countedVoxels) {
    NiftiFields fields;
    change(fields);
    return hostileFile("nifti/" + name, "v.nii", niftiHeader(fields) + voxels, words, outcome);
}

std::string floats() { return bytesFrom(twentyFour<float>()); }
std::string doubles(double factor) {
    std::vector<double> values = twentyFour<double>();
    for (double& value : values) value *= factor;
    return bytesFrom(values);
}

std::vector<HostileFile> niftiSizes() {
    const auto two = [](const std::vector<std::int64_t>& dim) {
        return [dim](NiftiFields& fields) {
            fields.version = 2;
            fields.dim = dim;
        };
    };
    return {
        nifti("30-gb",
              [](NiftiFields& f) {
                  f.dim = {3, 3000, 3000, 3000};
              },
              {"dim declares 27000000000 bytes", "incomplete"}),
        nifti("an-overflowing-size", two({3, 3037000500, 3037000500, 2}), {"more voxels than any file"}),
        nifti("a-row-of-2-to-the-62", two({3, 1, 1, std::int64_t{1} << 62}), {"holds only 24"}),
        nifti("a-negative-size", two({3, -1, 1, 1}), {"dim[1] must be above 0"}),
        nifti("the-least-size", two({3, std::numeric_limits<std::int64_t>::min(), 1, 1}), {"dim[1] must be above 0"}),
        nifti("20-million-phases", two({4, 1, 1, 2, 20000000}), {"makes 20000000 phases"}),
        nifti(
            "4097-phases",
            [](NiftiFields& f) {
                f.dim = {4, 1, 1, 2, 4097};
            },
            {"makes 4097 phases"}, HostileOutcome::refused, std::string(8194, 'v')),
        nifti(
            "4096-phases-of-two-voxels",
            [](NiftiFields& f) {
                f.dim = {4, 1, 1, 2, 4096};
            },
            {"phases"}, HostileOutcome::opens, std::string(8192, 'v')),
        nifti("eight-dimensions", [](NiftiFields& f) { f.dim = {8, 2, 3, 4, 1, 1, 1, 1}; }, {"dim[0] must be 1 to 7"}),
        nifti("five-dimensions", [](NiftiFields& f) { f.dim = {5, 2, 3, 2, 1, 2}; }, {"dim[5]", "several values"}),
        nifti("a-type-that-is-not-known", [](NiftiFields& f) { f.datatype = 77; }, {"datatype is 77"}),
        nifti("complex-numbers", [](NiftiFields& f) { f.datatype = 32; }, {"complex numbers"}),
        nifti(
            "wrong-bits", [](NiftiFields& f) { f.bitpix = 16; }, {"bitpix says 16 bits"},
            HostileOutcome::opensWithNote),
    };
}

std::vector<HostileFile> places() {
    std::vector<HostileFile> rows;
    for (const double offset : {0.0, 348.0, 351.0})
        rows.push_back(nifti(
            fmt::format("voxels-at-{}", offset), [&](NiftiFields& f) { f.voxOffset = offset; },
            {"which the file's length proves"}, HostileOutcome::opensWithNote));
    for (const double offset : {352.5, -352.0, noNumber, infinite, 1e30})
        rows.push_back(nifti(fmt::format("voxels-at-{}", offset), [&](NiftiFields& f) { f.voxOffset = offset; },
                             {"vox_offset must be a whole number of 352 or more"}));
    rows.push_back(nifti("voxels-behind-the-file", [](NiftiFields& f) { f.voxOffset = 4e9; }, {"holds only 0"}));
    return rows;
}

std::vector<HostileFile> scales() {
    // Voxels of 16 bits that are all black suit every white. NIfTI-2 states it in doubles.
    const auto blackTo = [](double white) {
        return [white](NiftiFields& f) {
            f.version = 2;
            f.datatype = 512;
            f.bitpix = 16;
            f.calMax = white;
        };
    };
    const auto scaled = [](int type, int bits, double slope, double inter = 0) {
        return [=](NiftiFields& f) {
            f.datatype = type;
            f.bitpix = bits;
            f.slope = slope;
            f.inter = inter;
            f.version = 2;
        };
    };
    const auto note = HostileOutcome::opensWithNote;
    return {
        nifti("floats-times-1e37", scaled(16, 32, 1e37), {"float32 can"}, HostileOutcome::opens, floats()),
        nifti("floats-beyond-float32", scaled(16, 32, 3e37), {"black is 0, white 7.2e+38"}, note, floats()),
        nifti("floats-far-beyond-float32", scaled(16, 32, 1e300), {"black is 0, white 2.4e+301"}, note, floats()),
        nifti("floats-beyond-float64", scaled(16, 32, 1.5e307), {"larger than float64"}, HostileOutcome::refused,
              floats()),
        nifti("floats-shifted-beyond-float32", scaled(16, 32, 1, 1e39), {"scl_slope is 1"}, HostileOutcome::refused,
              floats()),
        nifti("floats-made-one-value", scaled(16, 32, 1, 1e30), {"scl_slope"}, HostileOutcome::refused, floats()),
        nifti("small-floats-made-smaller", scaled(16, 32, 1e-20), {"black is 0, white 2.4e-44"}, note, bytesFrom([] {
                  std::vector<float> values = twentyFour<float>();
                  for (float& value : values) value *= 1e-25F;
                  return values;
              }())),
        nifti("doubles-beyond-float32", scaled(64, 64, 0), {"black is 0, white 2.4e+39"}, note, doubles(1e38)),
        nifti("doubles-of-1e308", scaled(64, 64, 0), {"black is 0, white 1.68e+308"}, note, doubles(7e306)),
        nifti("doubles-times-1e37", scaled(64, 64, 2e37), {"black is 0, white 4.8e+38"}, note, doubles(1)),
        nifti("doubles-that-the-scale-brings-back", scaled(64, 64, 1e-30), {"larger"}, HostileOutcome::opens,
              doubles(1e38)),
        nifti("bytes-beyond-float32", scaled(2, 8, 1e37), {"scl_slope"}, HostileOutcome::opens),
        nifti("bytes-below-float64", scaled(2, 8, -1e300, -1e307), {"black is -1.0000024e+307, white -1.0000001e+307"},
              note),
        nifti("bytes-times-inf", scaled(2, 8, infinite), {"scl_slope is no number"}, HostileOutcome::opensWithNote),
        nifti("bytes-plus-nan", scaled(2, 8, 2, noNumber), {"scl_inter is no number"}),
        nifti("bytes-times-1e-300", scaled(2, 8, 1e-300), {"black is 0, white 2.55e-298"}, note),
        nifti("a-window-beyond-float32-of-black-voxels", blackTo(3.5e38), {"no voxel can show it"},
              HostileOutcome::opensWithNote, std::string(48, '\0')),
        nifti("a-window-below-float32-of-black-voxels", blackTo(1e-300), {"no voxel can show it"},
              HostileOutcome::opensWithNote, std::string(48, '\0')),
        nifti("bytes-made-one-value", scaled(2, 8, 1, 1e30), {"scl_slope is 1 with intercept 1e+30"}),
        nifti("floats-of-one-value-in-a-slope", scaled(16, 32, 1e-30, 1), {"scl_slope"}, HostileOutcome::refused,
              floats()),
    };
}

std::vector<HostileFile> niftiSpacings() {
    std::vector<HostileFile> rows;
    const std::vector<std::pair<double, std::vector<std::string>>> values{
        {noNumber, {"pixdim must be finite and not 0"}},
        {infinite, {"pixdim must be finite and not 0"}},
        {0.0, {"pixdim must be finite and not 0"}},
        {1e300, {"which no scanner makes"}},
        {1e-310, {"which no scanner makes"}},
        {5000.0, {"more than 1000 times as long as wide"}}};
    for (const auto& [value, words] : values) {
        rows.push_back(nifti(
            fmt::format("spacing-of-{}", value),
            [&value = value](NiftiFields& f) {
                f.version = 2;
                f.pixdim = {1, 0.5, value, 2};
            },
            words));
        if (value != 5000.0)
            rows.push_back(nifti(
                fmt::format("sform-of-{}", value),
                [&value = value](NiftiFields& f) {
                    f.version = 2;
                    f.sformCode = 1;
                    f.srow = {{{value, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
                },
                {"sform is ignored: srow_x, srow_y, srow_z"}, HostileOutcome::opensWithNote));
    }
    rows.push_back(nifti(
        "negative-spacing",
        [](NiftiFields& f) {
            f.pixdim = {1, 0.5, -0.25, 2};
        },
        {"pixdim is negative"}, HostileOutcome::opensWithNote));
    rows.push_back(nifti(
        "quaternion-of-nan",
        [](NiftiFields& f) {
            f.qformCode = 1;
            f.quatern = {noNumber, 0, 0};
        },
        {"are no rotation"}, HostileOutcome::opensWithNote));
    rows.push_back(nifti(
        "quaternion-of-1e300",
        [](NiftiFields& f) {
            f.version = 2;
            f.qformCode = 1;
            f.quatern = {1e300, 0, 0};
        },
        {"are no rotation"}, HostileOutcome::opensWithNote));
    rows.push_back(nifti(
        "position-of-inf",
        [](NiftiFields& f) {
            f.qformCode = 1;
            f.qoffset = {infinite, 0, 0};
        },
        {"are no position"}, HostileOutcome::opensWithNote));
    return rows;
}

/// Pairs whose other file is a link, itself, or cut.
std::vector<HostileFile> pairs() {
    NiftiFields apart;
    apart.apart = true;
    const std::string header = niftiHeader(apart);
    const auto linked = [&](const std::string& name, const std::string& opened, const std::string& file,
                            const std::string& bytes, const std::string& link, const std::string& secret,
                            const std::vector<std::string>& words) {
        HostileFile row = hostileFile("nifti/" + name, "study/" + opened, "", words);
        row.write = [=](const std::filesystem::path& folder) {
            writeBytes(folder / "study" / file, bytes);
            writeBytes(folder / "elsewhere/secret", secret);
            std::filesystem::create_symlink(folder / "elsewhere/secret", folder / "study" / link);
        };
        return row;
    };
    HostileFile itself = hostileFile("nifti/voxels-that-are-the-header", "a.hdr", "", {"is the header itself"});
    itself.write = [=](const std::filesystem::path& folder) {
        writeBytes(folder / "a.hdr", header);
        std::filesystem::create_symlink(folder / "a.hdr", folder / "a.img");
    };
    const auto pair = [](const std::string& name, const std::string& opened, const std::string& hdr,
                         const std::string& img, const std::vector<std::string>& words) {
        HostileFile row = hostileFile("nifti/" + name, opened, "", words);
        row.write = [=](const std::filesystem::path& folder) {
            writeBytes(folder / "a.hdr", hdr);
            writeBytes(folder / "a.img", img);
        };
        return row;
    };
    return {
        linked("voxels-over-a-link", "a.hdr", "a.hdr", header, "a.img", countedVoxels, {"own folder"}),
        linked("packed-voxels-over-a-link", "a.hdr", "a.hdr", header, "a.img.gz", deflated(countedVoxels, 31),
               {"own folder"}),
        linked("packed-header-and-voxels-over-a-link", "a.hdr.gz", "a.hdr.gz", deflated(header, 31), "a.img.gz",
               deflated(countedVoxels, 31), {"own folder"}),
        linked("a-header-over-a-link", "a.img", "a.img", countedVoxels, "a.hdr", header, {"link out of its folder"}),
        itself,
        hostileFile("nifti/a-header-named-as-voxels", "a.img", header, {"is the header itself"}),
        hostileFile("nifti/one-file-with-the-magic-of-a-pair-and-more-bytes", "a.nii",
                    header + std::string(4, '\0') + countedVoxels + "more", {"there is no \"a.img\" beside it"}),
        pair("voxels-of-a-pair-behind-a-header", "a.hdr", header, niftiHeader({}) + countedVoxels + "more",
             {"where a NIfTI header stands"}),
        hostileFile("nifti/voxels-are-missing", "a.hdr", header, {"there is no \"a.img\" beside it"}),
        pair("cut-voxels-of-a-pair", "a.hdr", header, countedVoxels.substr(0, 9), {"holds only 9", "incomplete"}),
        pair("no-voxels-of-a-pair", "a.hdr", header, "", {"holds only 0", "incomplete"}),
        pair("a-cut-header-of-a-pair", "a.hdr", header.substr(0, 200), countedVoxels, {"NIfTI header", "incomplete"}),
        pair("a-cut-header-by-its-voxels", "a.img", header.substr(0, 200), countedVoxels,
             {"NIfTI header", "incomplete"}),
    };
}

std::vector<HostileFile> niftiCuts() {
    std::vector<HostileFile> rows;
    const std::string whole = niftiHeader({}) + countedVoxels;
    for (const std::size_t kept : {0U, 3U, 4U, 100U, 347U})
        rows.push_back(hostileFile(fmt::format("nifti/cut-to-{}-bytes", kept), "v.nii", whole.substr(0, kept),
                                   {fmt::format("ends after {} bytes", kept), "incomplete"}));
    for (const std::size_t kept : {348U, 352U, 360U, 375U})
        rows.push_back(hostileFile(fmt::format("nifti/cut-to-{}-bytes", kept), "v.nii", whole.substr(0, kept),
                                   {"dim declares 24 bytes", "incomplete"}));
    rows.push_back(
        hostileFile("nifti/cut-under-another-name", "v.dat", whole.substr(0, 200), {"NIfTI header", "incomplete"}));
    return rows;
}

}  // namespace

std::vector<HostileFile> hostileNifti() {
    std::vector<HostileFile> rows;
    for (const auto part : {niftiSizes, places, scales, niftiSpacings, pairs, niftiCuts})
        for (HostileFile& one : part()) rows.push_back(std::move(one));
    return rows;
}

}  // namespace echolucent
