// The rows of the panel Study, in the words of the window.
#pragma once

#include <QList>
#include <QString>

#include "io/study/study.h"
#include "processing/scene/pose.h"
#include "widgets/panels/study_panel.h"

namespace echolucent {

/// A sentence of a reader in which the moments of a 4D study are volumes, as the window calls them, and not phases, as
/// pages about files do. The names of a file's own entries ("Phase Vector") stay.
[[nodiscard]] QString withVolumesForPhases(QString sentence);

/// The rows about a study: first what a person wants to know of the scan, in the field's words; what only the file is
/// about follows. `facts` are those of the import report. How the probe looks is the document's beam, and is left out
/// if that is assumed.
[[nodiscard]] QList<StudyFactRow> studyRows(QList<StudyFactRow> facts, const Study& study, const Beam& beam);

}  // namespace echolucent
