// The return value of an operation that may fail for reasons outside the program (a short file, a full disc).
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace echolucent {

/// Why an operation failed. The command line turns it into an exit status.
enum class FailureKind {
    wrongUsage,  ///< the request itself makes no sense (exit status 2)
    unreadable,  ///< an input could not be read (exit status 3)
    unwritable,  ///< an output could not be written (exit status 4)
    cancelled,   ///< the person, or a newer request, ended the operation (exit status 3)
};

/// One expected failure, in parts. The edge of the program makes one clear sentence of them.
struct Failure {
    FailureKind kind = FailureKind::unreadable;
    std::string file;     ///< path as the person gave it; empty if no file is concerned
    std::string element;  ///< the header key, DICOM tag or option concerned; may be empty
    std::string problem;  ///< what is wrong, lower case, no full stop: "holds 12 bytes where 4096 are declared"
    std::string remedy;   ///< what to do, a full sentence; may be empty

    /// "FILE: ELEMENT problem. Remedy" as one line for a person.
    [[nodiscard]] std::string sentence() const;

    /// Whether the file holds 2D frames without volume geometry. The person may accept them as slices.
    bool framesCouldBeSlices = false;
    /// Whether the file has no known header. The person may say how it is laid out.
    bool layoutUnknown = false;
    /// Whether the file holds an opacity curve. It can be opened as one.
    bool opacityCurve = false;
    /// Whether the file holds presets. They can be imported.
    bool presets = false;
};

template <typename T>
using Result = tl::expected<T, Failure>;

/// Makes a failure, for a function that returns a Result.
[[nodiscard]] tl::unexpected<Failure> fail(FailureKind kind, std::string file, std::string element, std::string problem,
                                           std::string remedy = {});

}  // namespace echolucent
