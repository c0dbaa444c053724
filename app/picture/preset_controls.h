// Presets in the window: those of the program and a person's own.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/picture/preset_pictures.h"
#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "io/output/overwriting.h"
#include "processing/document/preset.h"
#include "processing/result.h"
#include "widgets/document/document_model.h"

class QWidget;

namespace echolucent {

class MessageBar;
class PresetsPanel;
class StudyNames;
class Works;

/// Choosing a preset is one step of the document. A person's own presets are kept in a file beside the settings,
/// written with every change. If that file cannot be read, it stays as it is, and nothing is written until it can be
/// read.
class PresetControls : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;  ///< parent of the dialogs
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        PresetsPanel& panel;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
    };
    explicit PresetControls(const Parts& parts, QObject* parent = nullptr);

    /// Reads the person's own presets, and whether the gallery was open.
    void restore();
    void keep();
    /// Adds the presets of a file to a person's own. If a name is taken, the preset gets another. False, with a
    /// message, if the file cannot be read, or if the file of the person's own presets cannot be read or written.
    bool importFrom(const QString& path);
    /// Writes one preset, counted from 0, as a file that importFrom() reads. False, with a message, if the file cannot
    /// be written, or if it is one of the study's files or the file of the person's own presets.
    bool exportTo(const QString& path, int preset);

private:
    void choose(int preset);
    void save();
    void rename(int preset, const QString& name);
    void remove(int preset);
    void chooseAndExport(int preset);
    void chooseAndImport();
    bool readOwn();
    bool changeOwn(const std::function<void(std::vector<Preset>& own)>& change);
    void showPresets();
    void showCurrent();
    [[nodiscard]] std::vector<Preset> all() const;
    [[nodiscard]] std::vector<std::string> names() const;
    bool report(const Result<void>& done);

    Parts m_parts;
    std::vector<Preset> m_own;
    std::vector<KeptFiles> m_read;  ///< imported preset files: only presets may overwrite them
    PresetPictures m_pictures;
};

}  // namespace echolucent
