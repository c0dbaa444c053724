// One sheet of many pictures, to be looked at.
#pragma once

#include <QStringList>

/// Writes a sheet with a column for each folder and a row for each picture (*.png) that any of them holds, each with
/// its name; what a folder lacks stays black. False where nothing could be written.
bool writeContactSheet(const QString& file, const QStringList& folders);
