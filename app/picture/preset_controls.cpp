#include "app/picture/preset_controls.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/files/save_dialog.h"
#include "app/otf/editor_otfs.h"
#include "app/study/study_names.h"
#include "io/document/preset_file.h"
#include "io/output/overwriting.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/panels/presets_panel.h"

namespace echolucent {

namespace {

constexpr const char* presetTopic = "presets";

/// The value of a row of the look, in words.
QString shownOf(const Look& look, std::string_view name) {
    const Parameter<Look>& row = *parameterNamed(lookParameters(), name);
    return QString::fromStdString(shownValue(row, *row.get(look)));
}

/// What a preset sets, in words: the mode, and in direct mode the curve and the light.
QString contentsOf(const Preset& preset) {
    if (preset.look.mode != RenderMode::direct) return shownOf(preset.look, "mode");
    return PresetControls::tr("%1 curve, light: %2")
        .arg(curveName(preset.curve), shownOf(preset.look, "lighting").toLower());
}

}  // namespace

PresetControls::PresetControls(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_pictures(parts.model, parts.openStudy, parts.works) {
    const PresetsPanel* panel = &m_parts.panel;
    connect(panel, &PresetsPanel::seenChanged, &m_pictures, &PresetPictures::setSeen);
    connect(panel, &PresetsPanel::chosen, this, &PresetControls::choose);
    connect(panel, &PresetsPanel::saveRequested, this, &PresetControls::save);
    // Queued: the gallery is filled again, which it cannot be while it takes the name.
    connect(panel, &PresetsPanel::renameRequested, this, &PresetControls::rename, Qt::QueuedConnection);
    connect(panel, &PresetsPanel::removeRequested, this, &PresetControls::remove);
    connect(panel, &PresetsPanel::exportRequested, this, &PresetControls::chooseAndExport);
    connect(panel, &PresetsPanel::importRequested, this, &PresetControls::chooseAndImport);
    connect(&m_pictures, &PresetPictures::made, this,
            [this](int preset) { m_parts.panel.setPicture(preset, m_pictures.picture(preset)); });
    const DocumentModel* model = &m_parts.model;
    connect(model, &DocumentModel::lookChanged, this, &PresetControls::showCurrent);
    connect(model, &DocumentModel::curvesChanged, this, &PresetControls::showCurrent);
    connect(model, &DocumentModel::panesChanged, this, &PresetControls::showCurrent);
    connect(model, &DocumentModel::methodChanged, this, &PresetControls::showCurrent);
    showPresets();
}

void PresetControls::restore() {
    readOwn();
    showPresets();
    m_parts.panel.setOpen(m_parts.settings.presetsOpen());
}

/// Reads the file of the person's own presets again: another window of the program may have written it. False, with a
/// message, if it cannot be read.
bool PresetControls::readOwn() {
    const QString file = m_parts.settings.presetsFile();
    if (!QFileInfo::exists(file)) {
        m_own.clear();
        return true;
    }
    auto own = readPresets(file.toStdString());
    if (!own) return report(tl::unexpected(own.error()));
    m_own = std::move(*own);
    return true;
}

void PresetControls::keep() { m_parts.settings.setPresetsOpen(m_parts.panel.isOpen()); }

std::vector<Preset> PresetControls::all() const {
    std::vector<Preset> presets(standardPresets().begin(), standardPresets().end());
    presets.insert(presets.end(), m_own.begin(), m_own.end());
    return presets;
}

std::vector<std::string> PresetControls::names() const {
    std::vector<std::string> names;
    for (const Preset& preset : all()) names.push_back(preset.name);
    return names;
}

void PresetControls::showPresets() {
    const std::vector<Preset> presets = all();
    QList<PresetEntry> entries;
    for (std::size_t i = 0; i < presets.size(); ++i)
        entries.append({textOf(presets[i].name), contentsOf(presets[i]), i >= standardPresets().size()});
    m_pictures.setPresets(presets);
    m_parts.panel.setPresets(entries);
    for (int i = 0; i < static_cast<int>(presets.size()); ++i) m_parts.panel.setPicture(i, m_pictures.picture(i));
    showCurrent();
}

/// Shows the preset of the picture: the one that would change nothing.
void PresetControls::showCurrent() {
    const Document& document = m_parts.model.document();
    const std::vector<Preset> presets = all();
    int current = -1;
    for (int i = 0; current < 0 && i < static_cast<int>(presets.size()); ++i)
        if (isMadeBy(document, firstPane, presets[static_cast<std::size_t>(i)])) current = i;
    m_parts.panel.setCurrent(current);
}

void PresetControls::choose(int preset) {
    const Preset chosen = all().at(static_cast<std::size_t>(preset));
    m_parts.model.edit(withPreset(m_parts.model.document(), firstPane, chosen),
                       tr("preset %1").arg(textOf(chosen.name)));
}

/// Changes the person's own presets as the file holds them now. Changes nothing if the file cannot be read or written.
bool PresetControls::changeOwn(const std::function<void(std::vector<Preset>& own)>& change) {
    bool done = readOwn();
    if (done) {
        std::vector<Preset> own = m_own;
        change(own);
        const QFileInfo file(m_parts.settings.presetsFile());
        QDir().mkpath(file.absolutePath());
        done = report(writePresets(file.filePath().toStdString(), own));
        if (done) m_own = std::move(own);
    }
    showPresets();
    return done;
}

void PresetControls::save() {
    const bool saved = changeOwn([this](std::vector<Preset>& own) {
        own.push_back(
            presetOf(m_parts.model.document(), firstPane, freePresetName(tr("My preset").toStdString(), names())));
    });
    if (!saved) return;
    const Document& document = m_parts.model.document();
    const DesignerConfig* designer = designerConfigOf(document, firstPane);
    if (designer != nullptr && document.scene.look.mode == RenderMode::direct)
        m_parts.messages.showMessage(MessageKind::info,
                                     tr("The preset holds the %1 curve, which the OTF of %2 hides now: presets keep "
                                        "curves, sessions keep designers "
                                        "too.")
                                         .arg(curveName(document.panes.at(firstPane).curve), labelOf(*designer)),
                                     MessageEnd::soon(presetTopic));
    m_parts.panel.editName(static_cast<int>(all().size()) - 1);
}

void PresetControls::rename(int preset, const QString& name) {
    const std::string before = all().at(static_cast<std::size_t>(preset)).name;
    changeOwn([&, this](std::vector<Preset>& own) {
        const auto renamed = std::ranges::find(own, before, &Preset::name);
        if (renamed == own.end() || name.trimmed().isEmpty()) return;
        std::vector<std::string> taken = names();
        std::erase(taken, before);
        renamed->name = freePresetName(name.toStdString(), taken);
    });
}

void PresetControls::remove(int preset) {
    const Preset removed = all().at(static_cast<std::size_t>(preset));
    if (!changeOwn([&](std::vector<Preset>& own) {
            std::erase_if(own, [&](const Preset& each) { return each.name == removed.name; });
        }))
        return;
    m_parts.messages.showMessage(MessageKind::info, tr("The preset “%1” was removed.").arg(textOf(removed.name)),
                                 MessageEnd::soon(presetTopic), {{tr("Bring back"), [this, removed] {
                                                                      changeOwn([&, this](std::vector<Preset>& own) {
                                                                          own.push_back(removed);
                                                                          own.back().name =
                                                                              freePresetName(removed.name, names());
                                                                      });
                                                                  }}});
}

void PresetControls::chooseAndExport(int preset) {
    QString name = textOf(all().at(static_cast<std::size_t>(preset)).name);
    for (QChar& character : name)
        if (QStringLiteral("/\\:*?\"<>|").contains(character) || !character.isPrint()) character = '-';
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Export preset"),
                                           .filter = tr("Presets (*.json)"),
                                           .name = name,
                                           .suffix = QStringLiteral("json")});
    if (!path.isEmpty()) exportTo(path, preset);
}

bool PresetControls::exportTo(const QString& path, int preset) {
    std::vector<std::string> kept{m_parts.settings.presetsFile().toStdString()};
    if (const Study* study = m_parts.openStudy.study())
        kept.insert(kept.end(), study->files.begin(), study->files.end());
    if (!report(refuseToOverwrite(kept, {path.toStdString()}))) return false;
    const Preset exported = all().at(static_cast<std::size_t>(preset));
    if (!report(writePresets(path.toStdString(), {exported}))) return false;
    m_parts.messages.showMessage(
        MessageKind::info,
        tr("The preset “%1” was exported to %2.").arg(textOf(exported.name), m_parts.names.nameOfOther(path)),
        MessageEnd::soon(presetTopic));
    return true;
}

void PresetControls::chooseAndImport() {
    QFileDialog dialog(&m_parts.window, tr("Import presets"), m_parts.settings.lastSaveFolder(),
                       tr("Presets (*.json);;All files (*)"));
    dialog.setObjectName("importPresets");
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    m_parts.settings.setLastSaveFolder(QFileInfo(path).absolutePath());
    if (!path.isEmpty()) importFrom(path);
}

bool PresetControls::importFrom(const QString& path) {
    const auto read = readPresets(path.toStdString());
    if (!read) return report(tl::unexpected(read.error()));
    m_read.emplace_back(std::vector{path.toStdString()}, OutputKind::presets);
    const bool kept = changeOwn([&, this](std::vector<Preset>& own) {
        std::vector<std::string> taken = names();
        for (Preset preset : *read) {
            preset.name = freePresetName(preset.name, taken);
            taken.push_back(preset.name);
            own.push_back(std::move(preset));
        }
    });
    if (!kept) return false;
    m_parts.panel.setOpen(true);
    m_parts.messages.showMessage(
        MessageKind::info,
        read->size() == 1 ? tr("1 preset was imported.") : tr("%1 presets were imported.").arg(read->size()),
        MessageEnd::soon(presetTopic));
    return true;
}

bool PresetControls::report(const Result<void>& done) {
    if (!done)
        m_parts.messages.showMessage(MessageKind::error, m_parts.names.sentenceOf(done.error()),
                                     MessageEnd::withStudy(presetTopic));
    return done.has_value();
}

}  // namespace echolucent
