#include "app/window/curve_and_picture_files.h"

#include <QFileDialog>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>

#include "io/curve_file.h"
#include "io/output/overwriting.h"
#include "io/output/picture_file.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

CurveAndPictureFiles::CurveAndPictureFiles(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
    connect(&m_parts.editor, &OtfEditor::openCurveRequested, this, &CurveAndPictureFiles::chooseAndOpenCurve);
    connect(&m_parts.editor, &OtfEditor::saveCurveRequested, this, [this] { chooseAndSaveCurve(); });
}

void CurveAndPictureFiles::chooseAndOpenCurve() {
    if (!mayLoseManualCurve()) return;
    const QString path = QFileDialog::getOpenFileName(&m_parts.window, tr("Open curve"), m_parts.settings.lastFolder(),
                                                      tr("Opacity curves (*.json);;All files (*)"));
    if (!path.isEmpty()) openCurve(path);
}

bool CurveAndPictureFiles::openCurve(const QString& path) {
    const auto curve = readCurve(path.toStdString());
    if (!curve) {
        m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(curve.error().sentence()));
        return false;
    }
    m_parts.editor.openManualCurve(*curve);
    return true;
}

bool CurveAndPictureFiles::chooseAndSaveCurve() {
    QFileDialog dialog(&m_parts.window, tr("Save curve"), m_parts.settings.lastFolder(), tr("Opacity curves (*.json)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("json");
    return dialog.exec() == QDialog::Accepted && saveCurve(dialog.selectedFiles().first());
}

bool CurveAndPictureFiles::saveCurve(const QString& path) {
    if (!report(mayOverwrite(path))) return false;
    if (!report(writeCurve(path.toStdString(), m_parts.editor.state().manual))) return false;
    m_parts.editor.setManualSaved();
    return true;
}

void CurveAndPictureFiles::chooseAndSavePicture() {
    QFileDialog dialog(&m_parts.window, tr("Save picture"), m_parts.settings.lastFolder(), tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("png");
    if (dialog.exec() == QDialog::Accepted) savePicture(dialog.selectedFiles().first());
}

bool CurveAndPictureFiles::savePicture(const QString& path) {
    if (!report(mayOverwrite(path))) return false;
    const QImage image = m_parts.picture.convergedImage().convertToFormat(QImage::Format_RGB888);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()) * 3);
    for (int y = 0; y < image.height(); ++y)
        rgb.insert(rgb.end(), image.constScanLine(y),
                   image.constScanLine(y) + 3 * static_cast<std::ptrdiff_t>(image.width()));
    return report(writePng(path.toStdString(), image.width(), image.height(), rgb));
}

Result<void> CurveAndPictureFiles::mayOverwrite(const QString& path) const {
    if (!m_parts.session.study()) return {};
    return refuseToOverwrite(m_parts.session.study()->files, {path.toStdString()});
}

bool CurveAndPictureFiles::report(const Result<void>& written) {
    if (!written) m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(written.error().sentence()));
    return written.has_value();
}

bool CurveAndPictureFiles::mayLoseManualCurve() {
    if (!m_parts.editor.isManualModified()) return true;
    QMessageBox box(QMessageBox::NoIcon, tr("Edited curve"), tr("The manual curve was edited and is not saved."),
                    QMessageBox::NoButton, &m_parts.window);
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
