// Presets in the window: those of the program and those that a person keeps.
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

/// Makes one step of the document of each preset that is chosen, and keeps a person's own in a file beside the
/// settings, which is written with every change. Where that file cannot be read, it is left as it is, and nothing is
/// kept in it until it can.
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

    /// Reads the person's own presets and whether the gallery was open.
    void restore();
    void keep();
    /// Adds the presets of a file to a person's own, under other names where theirs are taken. False, with a message,
    /// where it cannot be read.
    bool importFrom(const QString& path);
    /// Writes one preset, counted from 0, as a file that importFrom() reads.
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
    std::vector<KeptFiles> m_read;  ///< presets that were imported: only presets take their places
    PresetPictures m_pictures;
};

}  // namespace echolucent
