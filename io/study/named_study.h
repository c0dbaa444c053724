// How a document names a study that was opened.
#pragma once

#include "io/study/study.h"
#include "processing/document/study_reference.h"

namespace echolucent {

/// The name of a study that was read as `file` says, with the axis that was turned round. If its black is 0,
/// ReadOptions::blackAtZero is set: the study is the same with and without, and its document stays one that older
/// programs read alike.
[[nodiscard]] StudyFile asOpened(StudyFile file, const Study& study);

}  // namespace echolucent
