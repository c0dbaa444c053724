// The header of a NIfTI file as numbers: NIfTI-1 (348 bytes) and NIfTI-2 (540 bytes), in both byte orders.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace echolucent {

/// What the header holds, under NIfTI's own names. Nothing of it has been checked yet.
struct NiftiHeader {
    int version = 1;           ///< 1 or 2
    bool bigEndian = false;    ///< of header and voxels
    bool voxelsApart = false;  ///< whether the voxels lie in a file of their own (.img)
    std::array<std::int64_t, 8> dim{};
    std::int64_t intentCode = 0;
    std::int64_t datatype = 0;
    std::int64_t bitpix = 0;
    std::array<double, 8> pixdim{};  ///< pixdim[0] is qfac
    double voxOffset = 0;
    double sclSlope = 0, sclInter = 0;
    double calMax = 0, calMin = 0;
    double toffset = 0;
    std::string descrip;  ///< up to its first zero
    int xyztUnits = 0;
    std::int64_t qformCode = 0, sformCode = 0;
    std::array<double, 3> quatern{};              ///< b, c, d
    std::array<double, 3> qoffset{};              ///< x, y, z
    std::array<std::array<double, 4>, 3> srow{};  ///< srow_x, srow_y, srow_z
};

/// The description (descrip) that says white: "Echolucent white level 65535 of uint16". The display range of NIfTI
/// (cal_max) may be any program's choice of contrast; this is no choice.
[[nodiscard]] std::string niftiWhiteText(double whiteLevel, std::string_view typeName);

/// How many bytes of a file's beginning the header takes at least.
constexpr std::size_t shortestNiftiHeader = 348;
/// How many bytes of a file's beginning the header takes at most.
constexpr std::size_t niftiHeaderBytes = 540;

/// Whether the beginning of a file is a NIfTI header: its own length and its magic stand where they must.
[[nodiscard]] bool looksLikeNifti(std::string_view beginning);
/// Whether it is an Analyze 7.5 header, the like of NIfTI without its magic and without an orientation.
[[nodiscard]] bool looksLikeAnalyze(std::string_view beginning);
/// Whether bytes that end early may be the first of a NIfTI or Analyze header: they begin with its length.
[[nodiscard]] bool beginsLikeNifti(std::string_view beginning);
/// The header in the beginning of a file; no value where looksLikeNifti() says that it is none.
[[nodiscard]] std::optional<NiftiHeader> niftiHeaderIn(std::string_view beginning);

}  // namespace echolucent
