// The fuzz targets: one for each reader, with its samples and its mutation.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// A reader did what none may do. This is a finding, as a crash is.
class BrokenPromise : public std::logic_error {
    using std::logic_error::logic_error;
};

/// One file to begin from.
struct FuzzSample {
    std::string name;
    std::string bytes;
};

struct FuzzTarget {
    std::string_view name;  ///< as in scripts/fuzz: "meta-image"
    /// Lets the reader read these bytes. Throws BrokenPromise if the reader breaks its promises. Anything else that it
    /// throws is a finding too.
    void (*read)(std::string_view bytes);
    /// Other bytes, chosen by the seed, mostly of the same form.
    std::string (*mutated)(std::string bytes, std::uint64_t seed);
    /// Files to begin from, written by the project's own writers and by those of its tests.
    std::vector<FuzzSample> (*samples)();
    std::size_t longest;          ///< bytes; no longer inputs are made
    std::string_view dictionary;  ///< name of a file in tests/fuzz/dictionaries without its ending; may be empty
};

// Each stands in a source file of its own name in tests/fuzz/targets.
extern const FuzzTarget metaImageTarget;       ///< MetaImage
extern const FuzzTarget nrrdTarget;            ///< NRRD
extern const FuzzTarget niftiTarget;           ///< NIfTI
extern const FuzzTarget kretzTarget;           ///< GE Voluson
extern const FuzzTarget gzipTarget;            ///< packed files
extern const FuzzTarget rawLayoutTarget;       ///< the layout beside a raw file
extern const FuzzTarget dicomTarget;           ///< one DICOM file
extern const FuzzTarget dicomDirectoryTarget;  ///< a DICOMDIR beside slices
extern const FuzzTarget dicomPixelsTarget;     ///< a fragment in a good header: RLE, JPEG, JPEG-LS, JPEG 2000
extern const FuzzTarget dicomSeriesTarget;     ///< one file beside parts, slices over time, lone slices and a copy
extern const FuzzTarget dicomFolderTarget;     ///< one file among slices: listing, middle pictures, the series
extern const FuzzTarget curveTarget;           ///< an opacity curve
extern const FuzzTarget presetsTarget;         ///< presets
extern const FuzzTarget documentTarget;        ///< a document
extern const FuzzTarget sessionTarget;         ///< a session

[[nodiscard]] std::span<const FuzzTarget* const> fuzzTargets();
/// The target of that name. Throws std::invalid_argument if there is none.
[[nodiscard]] const FuzzTarget& fuzzTargetNamed(std::string_view name);

}  // namespace echolucent
