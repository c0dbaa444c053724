// What an operation returns that may fail for reasons outside the program (a short file, a full disc).
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace echolucent {

/// Why an expected failure happened; the command line turns it into an exit status.
enum class FailureKind {
    wrongUsage,  ///< the request itself makes no sense (exit status 2)
    unreadable,  ///< an input could not be read (exit status 3)
    unwritable,  ///< an output could not be written (exit status 4)
    cancelled,   ///< the person, or a newer request, ended it
};

/// One expected failure, kept in parts so that the edge of the program can make one clear sentence of it.
struct Failure {
    FailureKind kind = FailureKind::unreadable;
    std::string file;     ///< path as the person gave it; empty where no file is concerned
    std::string element;  ///< the header key, DICOM tag or option concerned; may be empty
    std::string problem;  ///< what is wrong, lower case, no full stop: "holds 12 bytes where 4096 are declared"
    std::string remedy;   ///< what to do, a full sentence; may be empty

    /// "FILE: ELEMENT problem. Remedy" as one line for a person.
    [[nodiscard]] std::string sentence() const;

    /// True where the file holds 2D frames without volume geometry that the person may accept as slices.
    bool framesCouldBeSlices = false;
    /// True where the file has no header that is known, so that the person may say how it is laid out.
    bool layoutUnknown = false;
    /// True where the file holds an opacity curve, which opens as such.
    bool opacityCurve = false;
    /// True where the file holds presets, which are imported.
    bool presets = false;
};

template <typename T>
using Result = tl::expected<T, Failure>;

/// Shorthand for returning a failure from a function with a Result.
[[nodiscard]] tl::unexpected<Failure> fail(FailureKind kind, std::string file, std::string element, std::string problem,
                                           std::string remedy = {});

}  // namespace echolucent
