// The one dialog in which a file to be saved is chosen.
#pragma once

#include <QString>

class QWidget;

namespace echolucent {

class OpenStudy;
class Settings;

/// What is asked of the person.
struct FileToSave {
    QString title;
    QString filter;                   ///< of the dialog's list, as QFileDialog takes it
    QString name;                     ///< proposed, without its suffix
    QString suffix;                   ///< "json"; added where the person types no ending that the filter names
    QString folder = {};              ///< proposed where it can be written to; else that of the file saved last
    bool asksBeforeReplacing = true;  ///< else whoever calls asks what is to become of a file that is there
    QString note = {};                ///< a sentence to be read before the file is saved; empty where there is none
};

/// Asks for a file; its folder is remembered. An empty text where the person does not want to, and where another study
/// opens in `openStudy` meanwhile, since what was to be saved is gone then. The dialog's object name is saveFile,
/// that of its note saveFile.note.
[[nodiscard]] QString chooseFileToSave(QWidget& window, Settings& settings, const OpenStudy& openStudy,
                                       const FileToSave& file);

}  // namespace echolucent
