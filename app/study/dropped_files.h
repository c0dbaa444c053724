// What dropping files on the window means.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace echolucent {

/// What to do with dropped files.
struct DroppedFiles {
    QString path{};        ///< the file or folder to open; empty if nothing is opened
    QString study{};       ///< the volume that was dropped with the session at `path`; empty if there is none
    QStringList slices{};  ///< what was dropped of the folder at `path`, and must be files; empty for all else
    QString whyNot{};      ///< why nothing is opened, a sentence for the person; empty if nothing was dropped, too
};

/// Looks at the names only: a drive that does not answer must not stall the window.
///
/// One file or folder is opened. Of several, a session is opened with the volume beside it, and a header stands for its
/// data files, as does a NIfTI volume for its side-cars ("v.nii.gz" with "v.json" and "v.bval"). What may be slices of
/// one folder means that folder. All else is refused, and so is what is not on this computer.
[[nodiscard]] DroppedFiles droppedFiles(const QList<QUrl>& urls);

}  // namespace echolucent
