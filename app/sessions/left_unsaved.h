// Sessions that were left and that nobody saved: of earlier runs, and of this one.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <deque>
#include <optional>

#include "app/sessions/leftovers.h"
#include "widgets/threads/newest_wins_thread.h"

class QMenu;

namespace echolucent {

class Autosave;
class MessageBar;
class OpenStudy;
class Settings;
class StudyNames;

/// They stand in one quiet place, a menu that lists them by name and time. A message offers each once: those of earlier
/// runs at the start, the others when they are left. It leaves by itself. What a person puts away with the message is
/// not offered at the next start, though the menu still has it. What is discarded is gone.
class LeftUnsaved : public QObject {
    Q_OBJECT

public:
    struct Parts {
        OpenStudy& openStudy;
        Works& works;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        Autosave& autosave;
    };
    /// Begins to look for what earlier runs left. What the parts refer to must outlive this object.
    explicit LeftUnsaved(const Parts& parts, QObject* parent = nullptr);

    /// Whether it still looks for what earlier runs left.
    [[nodiscard]] bool looking() const { return m_taking.busy(); }
    [[nodiscard]] const std::deque<Leftover>& list() const { return m_list; }
    /// Adds one that this run leaves.
    void add(Leftover left);
    /// Takes the one of this file out of the list, because it is open now. No value if there is none.
    [[nodiscard]] std::optional<Leftover> take(const QString& file);
    /// Opens or discards the one of this file. Does nothing if there is none.
    void open(const QString& file);
    void discard(const QString& file);
    /// Offers in a message what was not offered yet.
    void offer();
    /// Fills a menu with the list: names and times, and for each whether to open or to discard it.
    void fillMenu(QMenu& menu);

signals:
    void listChanged();

private:
    [[nodiscard]] QString nameOf(const Leftover& left) const;
    [[nodiscard]] static QString timeOf(const Leftover& left);
    void tellDamaged();
    void putAway(const QString& topic);

    Parts m_parts;
    std::deque<Leftover> m_list;  ///< oldest first
    QStringList m_told;           ///< files that a message has offered in this run
    QStringList m_offered;        ///< files of the newest message
    QString m_opening;            ///< file that was asked for last
    QStringList m_damaged;        ///< sentences to tell with the next study
    NewestWinsThread m_taking;
};

}  // namespace echolucent
