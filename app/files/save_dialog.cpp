#include "app/files/save_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QStandardPaths>

#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

QString writableFolder(const QString& proposed, const Settings& settings) {
    for (const QString& folder :
         {proposed, settings.lastSaveFolder(), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)})
        if (!folder.isEmpty() && QFileInfo(folder).isWritable()) return folder;
    return QDir::homePath();
}

/// The path, with the suffix added if it has no ending of the filter. QFileDialog takes what follows any point for an
/// ending, as in "Visit 1.2".
QString withEnding(const QString& path, const QString& filter, const QString& suffix) {
    static const QRegularExpression ending(QStringLiteral(R"(\*(\.[^\s)]+))"));
    bool named = false;
    for (auto endings = ending.globalMatch(filter); endings.hasNext(); named = true)
        if (path.endsWith(endings.next().captured(1), Qt::CaseInsensitive)) return path;
    return named ? path + '.' + suffix : path;
}

/// Shows the note below the fields. The dialog is Qt's own, since the desktop's dialogs take no words.
void showNote(QFileDialog& dialog, const QString& note) {
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    auto* fields = qobject_cast<QGridLayout*>(dialog.layout());
    if (fields != nullptr) fields->addWidget(noteLabel(note, "saveFile.note"), fields->rowCount(), 0, 1, -1);
}

}  // namespace

QString freeName(const QString& folder, const QString& name, const QString& suffix) {
    QString proposed = name + '.' + suffix;
    for (int number = 2; QFileInfo::exists(QDir(folder).filePath(proposed)); ++number)
        proposed = QStringLiteral("%1-%2.%3").arg(name).arg(number).arg(suffix);
    return proposed;
}

QString chooseFileToSave(QWidget& window, Settings& settings, const OpenStudy& openStudy, const FileToSave& file) {
    const QString folder = writableFolder(file.folder, settings);
    QFileDialog dialog(&window, file.title, folder, file.filter);
    dialog.setObjectName("saveFile");
    if (!file.note.isEmpty()) showNote(dialog, file.note);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite, !file.asksBeforeReplacing);
    dialog.setDefaultSuffix(file.suffix);
    dialog.selectFile(file.proposesAgain ? file.name + '.' + file.suffix : freeName(folder, file.name, file.suffix));
    QObject::connect(&openStudy, &OpenStudy::studyOpened, &dialog, &QDialog::reject);
    while (dialog.exec() == QDialog::Accepted) {
        const QString chosen = dialog.selectedFiles().first();
        const QString path = withEnding(chosen, dialog.selectedNameFilter(), file.suffix);
        if (path == chosen || !file.asksBeforeReplacing || !QFileInfo::exists(path)) {
            settings.setLastSaveFolder(QFileInfo(path).absolutePath());
            return path;
        }
        dialog.selectFile(path);  // the dialog then asks about replacing the file of that name
    }
    return {};
}

}  // namespace echolucent
