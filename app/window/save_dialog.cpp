#include "app/window/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/study/open_study.h"
#include "app/window/settings.h"

namespace echolucent {

QString chooseFileToSave(QWidget& window, Settings& settings, const OpenStudy& openStudy, const FileToSave& file) {
    QFileDialog dialog(&window, file.title, file.folder.isEmpty() ? settings.lastSaveFolder() : file.folder,
                       file.filter);
    dialog.setObjectName("saveFile");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite, !file.asksBeforeReplacing);
    dialog.setDefaultSuffix(file.suffix);
    dialog.selectFile(file.name + '.' + file.suffix);
    QObject::connect(&openStudy, &OpenStudy::studyOpened, &dialog, &QDialog::reject);
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString path = dialog.selectedFiles().first();
    settings.setLastSaveFolder(QFileInfo(path).absolutePath());
    return path;
}

}  // namespace echolucent
