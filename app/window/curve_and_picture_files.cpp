#include "app/window/curve_and_picture_files.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <utility>
#include <variant>

#include "app/files/save_dialog.h"
#include "app/picture/document_view.h"
#include "app/picture/picture_to_keep.h"
#include "app/study/study_names.h"
#include "io/document/curve_file.h"
#include "io/output/overwriting.h"
#include "io/study/import_report.h"
#include "io/writers/picture_file.h"
#include "widgets/casting/picture_image.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

constexpr const char *curveTopic = "curve", *pictureTopic = "picture file", *copyTopic = "copied picture";

/// A curve as nodes. A manual curve gives its own, a linear one its corners, the adaptive one all its samples. A power
/// gives 256 samples.
ManualCurve nodesOf(const OpacityCurve& curve) {
    if (const auto* manual = std::get_if<ManualCurve>(&curve)) return *manual;
    if (const auto* linear = std::get_if<LinearCurve>(&curve)) {
        // The curve may reach opacity 1 before its upper end.
        const double full = linear->slope > 0 ? linear->lower + 1.0 / linear->slope : 1.0;
        const double upper = std::min(linear->upper, full);
        return {{{linear->lower, 0.0}, {upper, opacityAt(curve, upper)}}};
    }
    constexpr int samplesOfFormula = 256;
    const auto* sampled = std::get_if<SampledCurve>(&curve);
    const int count = sampled ? static_cast<int>(sampled->opacities.size()) : samplesOfFormula;
    ManualCurve nodes;
    if (count < 2) return {{{0.0, 0.0}}};
    const std::vector<double> opacities = sampledOpacities(curve, count);
    for (int i = 0; i < count; ++i)
        nodes.nodes.push_back({static_cast<double>(i) / (count - 1), opacities[static_cast<std::size_t>(i)]});
    return nodes;
}

}  // namespace

CurveAndPictureFiles::CurveAndPictureFiles(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
    connect(&m_parts.editor, &OtfEditor::openCurveRequested, this, &CurveAndPictureFiles::chooseAndOpenCurve);
    connect(&m_parts.editor, &OtfEditor::saveCurveRequested, this, [this] { chooseAndSaveCurve(rendered()); });
    connect(&m_parts.editor, &OtfEditor::activeCurveChanged, this, [this] { m_parts.messages.takeBack(curveTopic); });
    connect(QApplication::clipboard(), &QClipboard::dataChanged, this,
            [this] { m_parts.messages.takeBack(copyTopic); });
}

void CurveAndPictureFiles::chooseAndOpenCurve() {
    const QString path = QFileDialog::getOpenFileName(&m_parts.window, tr("Open curve"), m_parts.settings.lastFolder(),
                                                      tr("Opacity curves (*.json);;All files (*)"));
    if (!path.isEmpty()) openCurveOfPerson(path);
}

void CurveAndPictureFiles::openCurveOfPerson(const QString& path) {
    if (mayLoseManualCurve()) openCurve(path);
}

bool CurveAndPictureFiles::openCurve(const QString& path) {
    const auto curve = readCurve(path.toStdString());
    if (!curve) {
        m_parts.messages.showMessage(MessageKind::error, m_parts.names.sentenceOf(curve.error()),
                                     MessageEnd::withStudy(curveTopic));
        return false;
    }
    m_parts.messages.takeBack(curveTopic);
    m_read.emplace_back(std::vector{path.toStdString()}, OutputKind::curve);
    m_parts.editor.openManualCurve(*curve);
    return true;
}

QString CurveAndPictureFiles::proposedName(const QString& what) const {
    return m_parts.names.beginningFor(m_parts.openStudy.path()) + '-' + what;
}

CurveAndPictureFiles::SavedCurve CurveAndPictureFiles::curveOfKind(CurveKind kind) const {
    return {curveOf(m_parts.editor.state(), kind), curveName(kind), curveKey(kind), kind == CurveKind::manual};
}

CurveAndPictureFiles::SavedCurve CurveAndPictureFiles::rendered() const {
    const OtfEditorState& state = m_parts.editor.state();
    if (!state.designed) return curveOfKind(state.active);
    return {state.design.value_or(SampledCurve{}), QString::fromStdString(state.designer), QStringLiteral("design"),
            false, true};
}

bool CurveAndPictureFiles::chooseAndSaveCurve(const SavedCurve& saved) {
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save the %1 curve").arg(saved.name),
                                           .filter = tr("Opacity curves (*.json)"),
                                           .name = proposedName(saved.key),
                                           .suffix = QStringLiteral("json")});
    return !path.isEmpty() && saveCurve(path, saved);
}

bool CurveAndPictureFiles::saveCurve(const QString& path) { return saveCurve(path, rendered()); }

bool CurveAndPictureFiles::saveCurve(const QString& path, const SavedCurve& saved) {
    const auto* sampled = std::get_if<SampledCurve>(&saved.curve);
    if (sampled != nullptr && sampled->opacities.empty()) {
        m_parts.messages.showMessage(
            MessageKind::warning,
            tr("The %1 curve is not computed yet, so there is nothing to save. Save it once it is rendered.")
                .arg(saved.name),
            MessageEnd::soon(curveTopic));
        return false;
    }
    const ManualCurve nodes = nodesOf(saved.curve);
    if (!report(mayOverwrite(path), curveTopic)) return false;
    if (!report(writeCurve(path.toStdString(), nodes), curveTopic)) return false;
    if (saved.manual) m_parts.editor.setManualSaved();
    QString told = tr("The %1 curve was saved as %2 (%3).")
                       .arg(saved.name, m_parts.names.nameOfOther(path),
                            nodes.nodes.size() == 1 ? tr("1 node") : tr("%1 nodes").arg(nodes.nodes.size()));
    if (const QString left = leftOut(saved); !left.isEmpty()) told += ' ' + left;
    m_parts.messages.showMessage(MessageKind::info, told, MessageEnd::soon(curveTopic));
    return true;
}

QString CurveAndPictureFiles::leftOut(const SavedCurve& saved) const {
    QStringList sentences;
    if (saved.ofDesigner) sentences << tr("It is the largest opacity of each intensity in the OTF.");
    const CurveAdjustment& adjustment = m_parts.editor.state().adjustment;
    QStringList sliders;
    for (const Parameter<CurveAdjustment>& row : adjustmentParameters())
        if (const double value = numberOf(*row.get(adjustment)).value(); value != 0.0)
            sliders << tr("%1 %2 %").arg(textOf(row.label).toLower(), QString::fromStdString(textOf(100.0 * value)));
    if (!sliders.isEmpty())
        sentences << tr("It leaves out what the sliders change in the picture: %1. A session or a preset keeps that.")
                         .arg(sliders.join(QStringLiteral(", ")));
    return sentences.join(' ');
}

void CurveAndPictureFiles::chooseAndSavePicture() {
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save picture"),
                                           .filter = tr("Pictures (*.png)"),
                                           .name = proposedName(QStringLiteral("picture")),
                                           .suffix = QStringLiteral("png"),
                                           .note = burnedInText()});
    if (!path.isEmpty()) savePicture(path);
}

void CurveAndPictureFiles::copyPicture() {
    if (!m_parts.openStudy.volume() || !isThere(tr("copied"))) return;
    const QImage image = pictureToSave(m_parts.compared(), tr("copied"));
    if (image.isNull()) return;
    QApplication::clipboard()->setImage(image);
    const QString note = burnedInText();
    if (note.isEmpty())
        m_parts.messages.showMessage(MessageKind::info, tr("The picture was copied."), MessageEnd::soon(copyTopic));
    else  // true until something else is copied
        m_parts.messages.showMessage(MessageKind::warning, tr("The picture was copied. %1").arg(note),
                                     MessageEnd::whenTakenBack(copyTopic));
}

/// Whether the 3D view shows the open study. While it still shows the one before, says that nothing is kept of it:
/// the file would have the new study's name.
bool CurveAndPictureFiles::isThere(const QString& what) {
    if (!m_parts.shown.held()) return true;
    m_parts.messages.showMessage(
        MessageKind::info,
        tr("The picture of this study is not there yet, so nothing was %1. Try it again once it is.").arg(what),
        MessageEnd::soon(pictureTopic));
    return false;
}

QString CurveAndPictureFiles::burnedInText() const {
    const Study* study = m_parts.openStudy.study();
    return study ? QString::fromStdString(burnedInTextNote(*study)) : QString();
}

/// Null, with a message, while a compared pane is not final.
QImage CurveAndPictureFiles::pictureToSave(const std::optional<QImage>& compared, const QString& what) {
    if (compared) {
        if (compared->isNull())
            m_parts.messages.showMessage(
                MessageKind::info,
                tr("A compared picture is not final yet, so nothing was %1. Try it again once it is.").arg(what),
                MessageEnd::soon(pictureTopic));
        return *compared;
    }
    return pictureToKeep(m_parts.picture, m_parts.openStudy, m_parts.model.document());
}

bool CurveAndPictureFiles::savePicture(const QString& path) {
    if (!isThere(tr("saved")) || !report(mayOverwrite(path), pictureTopic)) return false;
    const auto compared = m_parts.compared();
    const QImage image = pictureToSave(compared, tr("saved"));
    if (compared && image.isNull()) return false;
    if (!report(writePng(path.toStdString(), image.width(), image.height(), rgbBytesOf(image)), pictureTopic))
        return false;
    m_parts.messages.showMessage(
        MessageKind::info,
        (compared ? tr("The compared pictures were saved as %1.") : tr("The 3D picture was saved as %1."))
            .arg(m_parts.names.nameOfOther(path)),
        MessageEnd::soon(pictureTopic));
    return true;
}

Result<void> CurveAndPictureFiles::mayOverwrite(const QString& path) const {
    if (!m_parts.openStudy.study()) return {};
    return refuseToOverwrite(m_parts.openStudy.study()->files, {path.toStdString()});
}

bool CurveAndPictureFiles::report(const Result<void>& written, const QString& topic) {
    if (!written)
        m_parts.messages.showMessage(MessageKind::error, m_parts.names.sentenceOf(written.error()),
                                     MessageEnd::withStudy(topic));
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
    if (static_cast<QAbstractButton*>(save) == box.clickedButton())
        return chooseAndSaveCurve(curveOfKind(CurveKind::manual));
    return static_cast<QAbstractButton*>(discard) == box.clickedButton();
}

}  // namespace echolucent
