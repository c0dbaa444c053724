// The one dialog in which a file to be saved is chosen.
#pragma once

#include <QString>

class QWidget;

namespace echolucent {

class Settings;

/// Asks for a file in the folder of the last one, which is remembered; `name` is proposed for it, and `suffix` is added
/// where the person types none. An empty text where the person does not want to. The dialog's object name is saveFile.
[[nodiscard]] QString chooseFileToSave(QWidget& window, Settings& settings, const QString& title, const QString& filter,
                                       const QString& name, const QString& suffix);

}  // namespace echolucent
