// NIfTI files that are damaged or no volume: each ends in a sentence of its own.
#include <functional>

#include "hostile_file.h"
#include "hostile_numbers.h"
#include "nifti_files.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

HostileFile malformedNifti(const std::string& name, const std::function<void(NiftiFields&)>& change,
                           std::vector<std::string> words, const std::string& voxels = countedVoxels,
                           HostileOutcome outcome = HostileOutcome::refused) {
    NiftiFields fields;
    change(fields);
    return hostileFile("malformed-nifti/" + name, "v.nii", niftiHeader(fields) + voxels, std::move(words), outcome);
}

/// Files that only their name calls NIfTI.
std::vector<HostileFile> namedNifti() {
    std::vector<HostileFile> rows;
    for (const auto& [name, bytes] :
         {std::pair<std::string, std::string>{"words", "whatever"}, {"zeros", std::string(400, '\0')}})
        for (const bool packed : {false, true})
            rows.push_back(hostileFile("malformed-nifti/only-the-name-" + name + (packed ? "-packed" : ""),
                                       packed ? "v.nii.gz" : "v.nii", packed ? deflated(bytes, 31) : bytes,
                                       {"does not begin with a NIfTI header"}));
    rows.push_back(hostileFile("malformed-nifti/empty", "v.nii", "", {"ends after 0 bytes, within its NIfTI header"}));
    rows.push_back(hostileFile("malformed-nifti/empty-packed", "v.nii.gz", deflated("", 31),
                               {"ends after 0 bytes, within its NIfTI header"}));
    return rows;
}

}  // namespace

std::vector<HostileFile> hostileMalformedNifti() {
    std::vector<HostileFile> rows{
        malformedNifti("a-dimension-of-0", [](auto& f) { f.dim[0] = 0; }, {"dim[0] must be 1 to 7, not 0"}),
        malformedNifti("a-dimension-of-8", [](auto& f) { f.dim[0] = 8; }, {"dim[0] must be 1 to 7, not 8"}),
        malformedNifti("a-dimension-below-0", [](auto& f) { f.dim[0] = -3; }, {"dim[0] must be 1 to 7, not -3"}),
        malformedNifti("of-two-dimensions",
                       [](auto& f) {
                           f.dim = {2, 2, 3};
                       },
                       {"dim[0] is 2", "2D picture"}),
        malformedNifti("a-size-of-0", [](auto& f) { f.dim[2] = 0; }, {"dim[2] must be above 0, not 0"}),
        malformedNifti("a-size-below-0", [](auto& f) { f.dim[2] = -3; }, {"dim[2] must be above 0, not -3"}),
        malformedNifti("several-values-a-voxel", [](auto& f) { f.dim = {5, 2, 3, 4, 1, 3}; },
                       {"dim[5] is 3", "several values"}),
        malformedNifti("a-size-beyond-the-file",
                       [](auto& f) {
                           f.dim = {3, 2, 3, 5};
                       },
                       {"dim declares 30 bytes", "holds only 24"}),
        malformedNifti("the-largest-size-of-16-bits",
                       [](auto& f) {
                           f.dim = {3, 32767, 32767, 32767};
                       },
                       {"dim declares 35181150961663 bytes", "holds only 24"}),
        malformedNifti("a-size-that-overflows",
                       [](auto& f) {
                           f.version = 2;
                           f.dim = {3, 1LL << 40, 1LL << 40, 2};
                       },
                       {"dim declares more voxels than any"}),
        malformedNifti("frames-whose-size-overflows",
                       [](auto& f) {
                           f.version = 2;
                           f.dim = {4, 1LL << 62, 1, 1, 2};
                       },
                       {"dim", "2D frames over time"}),
        malformedNifti("an-unknown-type", [](auto& f) { f.datatype = 0; }, {"datatype is 0", "unknown type"}),
        malformedNifti("single-bits", [](auto& f) { f.datatype = 1; }, {"datatype is 1", "single bits"}),
        malformedNifti("complex-numbers", [](auto& f) { f.datatype = 32; }, {"datatype is 32", "complex64"}),
        malformedNifti("complex-numbers-of-double-length", [](auto& f) { f.datatype = 1792; }, {"complex128"}),
        malformedNifti("complex-numbers-of-longer-length", [](auto& f) { f.datatype = 2048; }, {"complex256"}),
        malformedNifti("floats-of-128-bits", [](auto& f) { f.datatype = 1536; }, {"128-bit floats"}),
        malformedNifti("colours-with-opacity", [](auto& f) { f.datatype = 2304; }, {"RGBA32"}),
        malformedNifti("a-type-that-is-not-known", [](auto& f) { f.datatype = 77; },
                       {"datatype is 77, which is not known"}),
        malformedNifti("displacements", [](auto& f) { f.intent = 1006; }, {"intent_code is 1006", "displacements"}),
        malformedNifti("vectors", [](auto& f) { f.intent = 1007; }, {"intent_code is 1007", "vectors"}),
        malformedNifti("points-of-a-surface", [](auto& f) { f.intent = 1008; },
                       {"intent_code is 1008", "points of a surface"}),
        malformedNifti("colours-on-a-surface", [](auto& f) { f.intent = 2003; },
                       {"intent_code is 2003", "colours on a surface"}),
        malformedNifti(
            "an-offset-of-0", [](auto& f) { f.voxOffset = 0; },
            {"vox_offset is 0, within the header", "from byte 352 on"}, countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti(
            "an-offset-within-the-header", [](auto& f) { f.voxOffset = 351; }, {"vox_offset is 351, within the header"},
            countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti("an-offset-that-is-no-whole-number", [](auto& f) { f.voxOffset = 352.5; },
                       {"vox_offset must be", "352.5"}),
        malformedNifti("an-offset-below-0", [](auto& f) { f.voxOffset = -400; }, {"vox_offset must be", "-400"}),
        malformedNifti("an-offset-of-nan", [=](auto& f) { f.voxOffset = noNumber; }, {"vox_offset must be", "nan"}),
        malformedNifti("an-offset-beyond-any-file", [](auto& f) { f.voxOffset = 1e30; },
                       {"vox_offset must be", "e+30"}),
        malformedNifti("an-offset-beyond-the-file", [](auto& f) { f.voxOffset = 1e9; },
                       {"dim declares 24 bytes", "holds only 0"}),
        malformedNifti(
            "an-offset-within-the-header-of-version-2",
            [](auto& f) {
                f.version = 2;
                f.voxOffset = 540;
            },
            {"vox_offset is 540, within the header", "from byte 544 on"}, countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti("a-spacing-of-0",
                       [](auto& f) {
                           f.pixdim = {1, 1, 0, 1};
                       },
                       {"pixdim must be finite and not 0", "1 0 1"}),
        malformedNifti("a-spacing-of-nan",
                       [=](auto& f) {
                           f.pixdim = {1, 1, noNumber, 1};
                       },
                       {"pixdim must be finite and not 0"}),
        malformedNifti("a-spacing-of-infinity",
                       [=](auto& f) {
                           f.pixdim = {1, 1, infinite, 1};
                       },
                       {"pixdim must be finite and not 0"}),
        malformedNifti("a-spacing-that-no-scanner-makes",
                       [](auto& f) {
                           f.pixdim = {1, 1e-9, 1, 1};
                       },
                       {"pixdim", "no scanner makes"}),
        malformedNifti(
            "units-that-are-no-length", [](auto& f) { f.units = 5; },
            {"xyzt_units is 5, which names no length", "spacing of the voxels is unknown"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti("units-of-frequency",
                       [](auto& f) {
                           f.dim = {4, 2, 3, 2, 2};
                           f.units = 2 + 32;
                       },
                       {"xyzt_units", "frequency"}),
        malformedNifti(
            "units-that-are-no-time",
            [](auto& f) {
                f.dim = {4, 2, 3, 2, 2};
                f.units = 2 + 56;
            },
            {"xyzt_units is 58, which names no time"}, countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti("an-intercept-of-nan",
                       [=](auto& f) {
                           f.slope = 2;
                           f.inter = noNumber;
                       },
                       {"scl_inter is no number"}),
        malformedNifti(
            "an-sform-of-zeros", [](auto& f) { f.sformCode = 1; },
            {"sform is ignored: srow_x, srow_y, srow_z", "the sizes of pixdim count"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti(
            "an-sform-of-nan",
            [=](auto& f) {
                f.sformCode = 1;
                f.srow = {{{noNumber, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
            },
            {"sform is ignored: srow_x, srow_y, srow_z", "the sizes of pixdim count"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti(
            "an-sform-far-away",
            [](auto& f) {
                f.sformCode = 1;
                f.srow = {{{1, 0, 0, 1e30}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
            },
            {"sform is ignored: srow_x, srow_y, srow_z", "the sizes of pixdim count"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti(
            "a-quaternion-that-is-no-rotation",
            [](auto& f) {
                f.qformCode = 1;
                f.quatern = {1, 1, 0};
            },
            {"qform is ignored: quatern_b, quatern_c, quatern_d are no rotation"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti(
            "a-quaternion-of-nan",
            [=](auto& f) {
                f.qformCode = 1;
                f.quatern = {noNumber, 0, 0};
            },
            {"qform is ignored: quatern_b, quatern_c, quatern_d are no rotation"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti(
            "a-qfac-of-nan",
            [=](auto& f) {
                f.qformCode = 1;
                f.pixdim[0] = noNumber;
            },
            {"qform is ignored: pixdim[0] must be 1 or -1"}, countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti(
            "a-spacing-of-0-in-a-qform",
            [](auto& f) {
                f.qformCode = 1;
                f.pixdim = {1, 0, 0, 0};
            },
            {"qform is ignored: pixdim must be finite", "spacing of the voxels is unknown"}, countedVoxels,
            HostileOutcome::opensWithNote),
        malformedNifti(
            "an-offset-of-infinity-in-a-qform",
            [=](auto& f) {
                f.qformCode = 1;
                f.qoffset = {0, infinite, 0};
            },
            {"qform is ignored: qoffset_x"}, countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti(
            "an-offset-of-0-in-a-longer-file", [](auto& f) { f.voxOffset = 0; },
            {"vox_offset must be a whole number of 352 or more, not 0"}, countedVoxels + "more"),
        malformedNifti("sizes-below-0-beyond-time", [](auto& f) { f.dim = {6, 2, 3, 4, 1, 1, -1}; },
                       {"dim[6] must be above 0, not -1"}),
        malformedNifti(
            "sizes-of-0-beyond-space", [](auto& f) { f.dim = {7, 2, 3, 4, 0, 0, 0, 0}; },
            {"dim[4] is 0, which is taken as 1", "dim[7] is 0"}, countedVoxels, HostileOutcome::opensWithNote),
        malformedNifti(
            "one-voxel-too-few", [](auto&) {}, {"dim declares 24 bytes", "holds only 23"}, countedVoxels.substr(1)),
        malformedNifti(
            "no-voxels", [](auto&) {}, {"dim declares 24 bytes", "holds only 0"}, "")};
    for (HostileFile& row : namedNifti()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace echolucent
