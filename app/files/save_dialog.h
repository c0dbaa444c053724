// The one dialog for choosing the file to save.
#pragma once

#include <QString>

class QWidget;

namespace echolucent {

class OpenStudy;
class Settings;

/// What the dialog asks.
struct FileToSave {
    QString title;
    QString filter;                   ///< of the dialog's list, as QFileDialog takes it
    QString name;                     ///< proposed, without its suffix
    QString suffix;                   ///< "json"; added if the person types no ending of the filter
    QString folder = {};              ///< proposed if it can be written to; else the folder of the file saved last
    bool asksBeforeReplacing = true;  ///< whether the dialog asks; if false, the caller asks
    QString note = {};                ///< a sentence to read before saving; empty for none
    bool proposesAgain = false;       ///< whether a name that is there is proposed too; else freeName()
};

/// "NAME.SUFFIX", or "NAME-2.SUFFIX" and so on: the first of them that `folder` does not hold yet.
[[nodiscard]] QString freeName(const QString& folder, const QString& name, const QString& suffix);

/// Asks for a file and remembers its folder. The text is empty if the person cancels. It is also empty if another study
/// opens in `openStudy` meanwhile: the thing to save is gone then. The dialog's object name is saveFile, that of its
/// note saveFile.note.
[[nodiscard]] QString chooseFileToSave(QWidget& window, Settings& settings, const OpenStudy& openStudy,
                                       const FileToSave& file);

}  // namespace echolucent
