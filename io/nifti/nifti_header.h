// The header of a NIfTI file as numbers: NIfTI-1 (348 bytes) and NIfTI-2 (540 bytes), in both byte orders.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace echolucent {

/// The fields of the header, under NIfTI's own names. Nothing is checked yet.
struct NiftiHeader {
    int version = 1;           ///< 1 or 2
    bool bigEndian = false;    ///< byte order of header and voxels
    bool voxelsApart = false;  ///< whether the voxels lie in their own file (.img)
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

/// The description (descrip) that states the white level, "Echolucent white level 65535 of uint16", and black if that
/// is not 0: "Echolucent black level -60, white level 0 of float32". cal_min and cal_max alone are not enough, because
/// any program may have set this display range as it likes.
[[nodiscard]] std::string niftiWhiteText(double black, double white, std::string_view typeName);

/// The length of the shortest header, bytes.
constexpr std::size_t shortestNiftiHeader = 348;
/// The length of the longest header, bytes.
constexpr std::size_t niftiHeaderBytes = 540;

/// Whether a file begins with a whole NIfTI header: with the header's length, and the magic in its place.
[[nodiscard]] bool looksLikeNifti(std::string_view beginning);
/// Whether a file begins with an Analyze 7.5 header, which resembles NIfTI but has no magic and no orientation.
[[nodiscard]] bool looksLikeAnalyze(std::string_view beginning);
/// Whether the bytes may be a NIfTI or Analyze header that was cut: they begin with its length, and are fewer.
[[nodiscard]] bool beginsLikeNifti(std::string_view beginning);
/// The header at the beginning of a file; no value unless looksLikeNifti().
[[nodiscard]] std::optional<NiftiHeader> niftiHeaderIn(std::string_view beginning);

}  // namespace echolucent
