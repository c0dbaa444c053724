// A gallery of presets: a small picture and a name each.
#pragma once

#include <QImage>
#include <QList>
#include <QString>
#include <QWidget>

class QAction;
class QLabel;
class QListWidget;
class QToolButton;

namespace echolucent {

struct PresetEntry {
    QString name;
    QString contents;  ///< what the preset sets, for the tool tip
    bool own = false;  ///< a person made it, and may rename or remove it
};

/// Objects: presets.open (opens and closes the gallery), presets.current, presets.list, presets.save, presets.more with
/// the actions presets.rename, presets.remove, presets.export and presets.import. A click or Enter chooses a preset.
/// The actions concern the selected one. Presets are counted from 0. seenChanged() is the only signal of a setter.
class PresetsPanel : public QWidget {
    Q_OBJECT

public:
    /// The largest size of a picture, logical pixels.
    static constexpr int pictureWidth = 92, pictureHeight = 69;

    explicit PresetsPanel(QWidget* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

    /// Replaces all presets. Their places stay dark until setPicture() gives each its picture. No preset is then the
    /// current one.
    void setPresets(const QList<PresetEntry>& presets);
    /// A null picture leaves the place dark.
    void setPicture(int preset, const QImage& picture);
    /// The preset of the present picture; its name is shown above the gallery. -1 if the picture has none of the
    /// presets.
    void setCurrent(int preset);
    [[nodiscard]] bool isOpen() const;
    void setOpen(bool open);
    /// Lets a person type the name of one of their own presets.
    void editName(int preset);

signals:
    void seenChanged(bool seen);
    void chosen(int preset);
    void saveRequested();
    void renameRequested(int preset, const QString& name);
    void removeRequested(int preset);
    void exportRequested(int preset);
    void importRequested();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void createList();
    void createActions();
    void fitHeight();
    void showCurrent();
    void enableActions();
    [[nodiscard]] int selected() const;
    [[nodiscard]] QString nameOf(int preset) const;

    QList<PresetEntry> m_presets;
    int m_current = -1;
    QToolButton* m_open = nullptr;
    QLabel* m_currentName = nullptr;
    QWidget* m_gallery = nullptr;
    QListWidget* m_list = nullptr;
    QToolButton* m_more = nullptr;
    QAction *m_rename = nullptr, *m_remove = nullptr, *m_export = nullptr;
};

}  // namespace echolucent
