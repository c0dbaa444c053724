#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "app/main_window.h"
#include "io/curve_file.h"
#include "io/output/overwriting.h"
#include "io/output/picture_file.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/raw_layout_dialog.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

RawLayout fromDialog(const RawLayoutValues& values) {
    RawLayout layout;
    layout.size = values.size;
    layout.type = values.type.toStdString();
    layout.bigEndian = values.bigEndian;
    layout.headerBytes = values.headerBytes;
    layout.spacing = {values.spacing[0], values.spacing[1], values.spacing[2]};
    layout.spacingKnown = values.spacingKnown;
    return layout;
}

RawLayoutValues toDialog(const RawLayout& layout) {
    RawLayoutValues values;
    values.size = layout.size;
    values.type = QString::fromStdString(layout.type);
    values.bigEndian = layout.bigEndian;
    values.headerBytes = layout.headerBytes;
    values.spacing = {layout.spacing[0], layout.spacing[1], layout.spacing[2]};
    values.spacingKnown = layout.spacingKnown;
    return values;
}

}  // namespace

void MainWindow::open(const QString& path, const ReadOptions& options) {
    if (path.isEmpty()) return;
    const QFileInfo info(path);
    m_settings.setLastFolder(info.absolutePath());
    m_session.open(info.absoluteFilePath(), options);
    updateIdle();
}

void MainWindow::openSimulatedScan() {
    m_session.openSimulatedScan();
    updateIdle();
}

void MainWindow::chooseAndOpen() {
    open(QFileDialog::getOpenFileName(
        this, tr("Open volume"), m_settings.lastFolder(),
        tr("3D ultrasound volumes (*.mha *.mhd *.nrrd *.nhdr *.dcm *.raw);;All files (*)")));
}

void MainWindow::chooseAndOpenFolder() {
    open(QFileDialog::getExistingDirectory(this, tr("Open folder of DICOM slices"), m_settings.lastFolder()));
}

void MainWindow::chooseAndOpenRaw() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open raw volume"), m_settings.lastFolder());
    if (!path.isEmpty()) openRaw(path);
}

void MainWindow::openRaw(const QString& path) {
    auto* dialog = new RawLayoutDialog(QFileInfo(path).fileName(), QFileInfo(path).size(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto remembered = recalledRawLayout(path.toStdString()); remembered && *remembered)
        dialog->setValues(toDialog(**remembered));
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        ReadOptions options;
        options.raw = fromDialog(dialog->values());
        // A folder that cannot be written to is no reason not to open the file: then the person is asked again.
        (void)rememberRawLayout(path.toStdString(), *options.raw);
        open(path, options);
    });
    dialog->open();
}

void MainWindow::openFailed(const QString& path, const Failure& failure) {
    QList<MessageAction> actions;
    if (failure.framesCouldBeSlices)
        actions << MessageAction{tr("Take the frames as slices"), [this, path] {
                                     ReadOptions options;
                                     options.framesAsSlices = true;
                                     open(path, options);
                                 }};
    if (failure.layoutUnknown) actions << MessageAction{tr("Say how it is laid out…"), [this, path] { openRaw(path); }};
    Failure shown = failure;
    shown.file = QFileInfo(path).fileName().toStdString();
    // The way out is a button here; the sentence would name an option of the command line.
    if (!actions.isEmpty()) shown.remedy.clear();
    m_messageBar->showMessage(MessageKind::error, QString::fromStdString(shown.sentence()), actions);
    updateIdle();
}

void MainWindow::showRecentFiles() {
    m_recentMenu->clear();
    for (const QString& path : m_settings.recentFiles())
        connect(m_recentMenu->addAction(path), &QAction::triggered, this, [this, path] { open(path); });
    if (m_recentMenu->isEmpty()) {
        m_recentMenu->addAction(tr("None yet"))->setEnabled(false);
        return;
    }
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("Forget these files")), &QAction::triggered, this,
            [this] { m_settings.clearRecentFiles(); });
}

void MainWindow::chooseAndOpenCurve() {
    if (!mayLoseManualCurve()) return;
    const QString path = QFileDialog::getOpenFileName(this, tr("Open curve"), m_settings.lastFolder(),
                                                      tr("Opacity curves (*.json);;All files (*)"));
    if (!path.isEmpty()) openCurve(path);
}

bool MainWindow::openCurve(const QString& path) {
    const auto curve = readCurve(path.toStdString());
    if (!curve) {
        m_messageBar->showMessage(MessageKind::error, QString::fromStdString(curve.error().sentence()));
        return false;
    }
    m_otfEditor->openManualCurve(*curve);
    return true;
}

bool MainWindow::chooseAndSaveCurve() {
    QFileDialog dialog(this, tr("Save curve"), m_settings.lastFolder(), tr("Opacity curves (*.json)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("json");
    return dialog.exec() == QDialog::Accepted && saveCurve(dialog.selectedFiles().first());
}

bool MainWindow::saveCurve(const QString& path) {
    if (!report(mayOverwrite(path))) return false;
    if (!report(writeCurve(path.toStdString(), m_otfEditor->state().manual))) return false;
    m_otfEditor->setManualSaved();
    return true;
}

void MainWindow::chooseAndSavePicture() {
    QFileDialog dialog(this, tr("Save picture"), m_settings.lastFolder(), tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("png");
    if (dialog.exec() == QDialog::Accepted) savePicture(dialog.selectedFiles().first());
}

bool MainWindow::savePicture(const QString& path) {
    if (!report(mayOverwrite(path))) return false;
    const QImage image = m_volumeView->convergedImage().convertToFormat(QImage::Format_RGB888);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()) * 3);
    for (int y = 0; y < image.height(); ++y)
        rgb.insert(rgb.end(), image.constScanLine(y),
                   image.constScanLine(y) + 3 * static_cast<std::ptrdiff_t>(image.width()));
    return report(writePng(path.toStdString(), image.width(), image.height(), rgb));
}

Result<void> MainWindow::mayOverwrite(const QString& path) const {
    if (!m_session.study()) return {};
    return refuseToOverwrite(m_session.study()->files, {path.toStdString()});
}

bool MainWindow::report(const Result<void>& written) {
    if (!written) m_messageBar->showMessage(MessageKind::error, QString::fromStdString(written.error().sentence()));
    return written.has_value();
}

bool MainWindow::mayLoseManualCurve() {
    if (!m_otfEditor->isManualModified()) return true;
    QMessageBox box(QMessageBox::NoIcon, tr("Edited curve"), tr("The manual curve was edited and is not saved."),
                    QMessageBox::NoButton, this);
    box.setObjectName("unsavedCurve");
    QPushButton* save = box.addButton(tr("Save curve…"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("Discard the edits"), QMessageBox::DestructiveRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(save);
    box.exec();
    if (static_cast<QAbstractButton*>(save) == box.clickedButton()) return chooseAndSaveCurve();
    return static_cast<QAbstractButton*>(discard) == box.clickedButton();
}

}  // namespace echolucent
