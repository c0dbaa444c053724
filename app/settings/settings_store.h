// Keeps values by their keys in an INI file. It reads the file at once and writes it in a thread, since a disc may be
// slow.
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>
#include <QVariantMap>
#include <optional>

#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Does what QSettings does, but setting a value never waits for the disc. A change is written once the event loop is
/// reached. What other programs wrote meanwhile is read then.
class SettingsStore : public QObject {
    Q_OBJECT

public:
    /// Reads `file`. If it is missing, no key has a value.
    explicit SettingsStore(const QString& file);
    /// Waits until all is written.
    ~SettingsStore() override;

    [[nodiscard]] const QString& fileName() const { return m_file; }
    [[nodiscard]] QVariant value(const QString& key, const QVariant& otherwise = {}) const;
    [[nodiscard]] bool contains(const QString& key) const { return m_values.contains(key); }
    void setValue(const QString& key, const QVariant& value);
    /// Removes a key and all below it ("group/key").
    void remove(const QString& key);

    /// Writes all now and waits for it; false if that failed. Changes that could not be written are tried again with
    /// the next change.
    bool save();

private:
    /// New values by their keys; a key without one is removed.
    using Changes = QVariantMap;
    /// What a file holds after changes were written. If `whole` is false, they could not be written.
    struct Written {
        bool whole = false;
        QVariantMap values;
    };
    [[nodiscard]] static Written write(const QString& file, const Changes& changes);
    static void apply(const Changes& changes, QVariantMap& values);
    void change(const QString& key, const QVariant& value);
    void writeSoon();
    void writeNext();
    void take(const Written& written);

    QString m_file;
    QVariantMap m_values;
    Changes m_changes;       ///< not given to the thread yet
    Changes m_beingWritten;  ///< by the thread; or the thread failed to write them
    bool m_writesSoon = false;
    Works m_works;  ///< nobody waits for the settings
    // Last, so that its thread has ended before anything above is destroyed. Made when there is something to write.
    std::optional<NewestWinsThread> m_writing;
};

}  // namespace echolucent
