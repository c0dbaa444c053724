// Pictures that may be the slices of one volume, and the putting of them in order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/series/series_traits.h"
#include "io/study/series_list.h"

namespace echolucent {

/// A file that cannot be read.
struct DamagedFile {
    std::string path;
    Failure damage;
    std::optional<ImageHeader> header;  ///< what could still be read
};

/// Single pictures that may belong to one volume.
struct SliceGroup {
    Images images;                           ///< at least one
    std::vector<DamagedFile> damaged{};      ///< slices that belong to it and cannot be read
    std::string distinction{};               ///< SeriesEntry::distinction
    std::optional<Failure> contradiction{};  ///< why the pictures cannot be one volume, whatever their places
    std::vector<std::string> notes{};        ///< SeriesEntry::notes
};

/// An entry with what its first image says; its files are not set.
[[nodiscard]] SeriesEntry entryOf(const ImageHeader& first);

/// Gives an entry the slices of a group, in order and in phases, with damaged ones among them if they fit. Sets
/// entry.whyNot if they are no volume. Gives back the damaged slices that do not fit.
[[nodiscard]] std::vector<DamagedFile> orderSlices(const std::string& folder, SliceGroup& group, SeriesEntry& entry);

/// Whether a file that failed so is damaged. Else it is of a kind that cannot be read.
[[nodiscard]] bool isDamage(const Failure& failure);

/// Why a series is no volume if `damaged` slices of `all` cannot be read. No value if enough can be read: at least two,
/// and at least half of them. `damaged` holds the paths; `first` is the failure of the first.
[[nodiscard]] std::optional<Failure> tooFewWhole(const std::string& folder, const std::vector<std::string>& damaged,
                                                 std::size_t all, const Failure& first);

}  // namespace echolucent
