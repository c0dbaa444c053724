// The voxels that small pictures of the open study are made from.
#pragma once

#include "app/study/open_study.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

/// The phase shown, uncut, with its quiet voxels if they are made already. At the size of a small picture nobody sees
/// whether voxels are quiet, so such pictures do not wait for quiet ones. Without a scan if no study is open.
[[nodiscard]] StudyPhases voxelsNow(const OpenStudy& openStudy);

}  // namespace echolucent
