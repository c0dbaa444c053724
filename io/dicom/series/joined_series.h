// Volumes whose slices each have a series of their own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/dicom/series/slice_groups.h"
#include "io/study/series_list.h"

namespace echolucent {

/// Joins series that hold pictures of one place each and that lie side by side, at least three: of one study, alike in
/// what the slices of a volume share and in kind (contrast), parallel, at even distances. The joined groups are taken
/// out of `series`, which maps Series Instance UIDs to groups. Pictures that call themselves localizers stay alone. An
/// entry has the UID of the series of its first slice. If slices of one picture each would belong together (one series
/// description and frame of reference) but lie at uneven distances, the entry's whyNot says so. Else what does not fit
/// stays as it is.
[[nodiscard]] std::vector<SeriesEntry> joinSeries(const std::string& folder,
                                                  std::map<std::string, std::vector<SliceGroup>>& series);

}  // namespace echolucent
