#include "app/window/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/window/settings.h"

namespace echolucent {

QString chooseFileToSave(QWidget& window, Settings& settings, const QString& title, const QString& filter,
                         const QString& name, const QString& suffix) {
    QFileDialog dialog(&window, title, settings.lastSaveFolder(), filter);
    dialog.setObjectName("saveFile");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(name + '.' + suffix);
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString path = dialog.selectedFiles().first();
    settings.setLastSaveFolder(QFileInfo(path).absolutePath());
    return path;
}

}  // namespace echolucent
