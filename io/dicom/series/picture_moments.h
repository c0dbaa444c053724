// When a single DICOM picture was taken, in the words of its file.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

class DcmItem;

namespace echolucent {

/// An attribute that tells the phases of slices apart.
struct MomentAttribute {
    const char* name;     ///< "(0018,1060) Trigger Time"
    double secondsOfOne;  ///< seconds of one unit of its value; 0 if it only counts
    bool countsTime;      ///< whether it says nothing but time; else pictures of several kinds may differ in it too
};
/// The attributes, those first that are to be trusted most.
constexpr std::array momentAttributes{
    MomentAttribute{"(0020,0100) Temporal Position Identifier", 0, true},
    MomentAttribute{"(0020,9128) Temporal Position Index", 0, true},
    MomentAttribute{"(0018,1060) Trigger Time", 1e-3, true},
    MomentAttribute{"(0020,9153) Nominal Cardiac Trigger Delay Time", 1e-3, true},
    MomentAttribute{"(0020,9241) Nominal Percentage of Cardiac Phase", 0, true},
    MomentAttribute{"(0020,9245) Nominal Percentage of Respiratory Phase", 0, true},
    MomentAttribute{"(0054,1300) Frame Reference Time", 1e-3, true},
    MomentAttribute{"(0008,002a) Acquisition DateTime", 1, false},
    MomentAttribute{"(0008,0032) Acquisition Time", 1, false},
    MomentAttribute{"(0008,0033) Content Time", 1, false},
    MomentAttribute{"(0020,0012) Acquisition Number", 0, false},
    MomentAttribute{"(0054,1330) Image Index", 0, false},
};

/// What one picture says of its moment.
struct PictureMoments {
    /// The value of each of momentAttributes; no value if it is missing or makes no sense. Times of day count seconds
    /// from 1 January 2000 if their date is stated, else from midnight.
    std::array<std::optional<double>, momentAttributes.size()> values{};
    std::optional<double> resolution;  ///< (0020,0110) Temporal Resolution, seconds between phases; above 0
    /// What makes pictures of one place and moment different: image type, echo, diffusion, kernel. Only compared.
    std::string kind;

    friend bool operator==(const PictureMoments&, const PictureMoments&) = default;
};

[[nodiscard]] PictureMoments momentsOf(DcmItem& dataset);

}  // namespace echolucent
