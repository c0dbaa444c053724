// Lets a person choose among the series of a folder, with a small picture of each.
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>

#include "io/study/series_list.h"
#include "widgets/threads/newest_wins_thread.h"

class QWidget;

namespace echolucent {

class SeriesDialog;
class StudyNames;

/// Shows the dialog; its pictures are read in a thread of its own, one after the other.
class SeriesChoice : public QObject {
    Q_OBJECT

public:
    /// `window` is the parent of the dialog. It and `names` must outlive this object. If numbers stand for names,
    /// series are called by their numbers alone.
    SeriesChoice(QWidget& window, StudyNames& names, Works& works);

    /// Asks, and calls `chosen` with the entry's index in the list. A dialog that is open already closes.
    void ask(const std::shared_ptr<const SeriesList>& list, std::function<void(std::size_t)> chosen);

private:
    void readPicture(const std::shared_ptr<const SeriesList>& list, std::size_t index);

    QWidget& m_window;
    StudyNames& m_names;
    QPointer<SeriesDialog> m_dialog;
    NewestWinsThread m_pictures;
};

}  // namespace echolucent
