// What dropping files on the window means.
#pragma once

#include <QList>
#include <QString>
#include <QUrl>

namespace echolucent {

/// What to do with dropped files.
struct DroppedFiles {
    QString path{};    ///< the file or folder to open; empty if there is none
    QString study{};   ///< the volume that was dropped with the session at `path`; empty if there is none
    QString whyNot{};  ///< if nothing is to be opened: one sentence that says why
};

/// Looks at the names only: a drive that does not answer must not stall the window.
///
/// One file or folder is opened. Of several, a session is opened with the volume beside it, and a header stands for its
/// data files, as does a NIfTI volume for its side-car ("v.nii.gz" and "v.json"). Files of one folder that may be
/// slices mean that folder. All else is refused, and so is what is not on this computer.
[[nodiscard]] DroppedFiles droppedFiles(const QList<QUrl>& urls);

}  // namespace echolucent
